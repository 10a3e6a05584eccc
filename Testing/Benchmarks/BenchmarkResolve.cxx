// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The growth of the time to resolve with the number of intersecting pairs, for stacks of coplanar
 * sheets and for crossing sheets. The counter `growth` is the time per pair divided by that of the
 * smallest mesh of the kind in the same run. It is about 1 if the time is linear in the number of
 * pairs.
 */
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Resolve.h"
#include "Shapes.h"

#include <benchmark/benchmark.h>

#include <ctime>
#include <map>
#include <stdexcept>

using namespace carving::helper;

namespace
{

/**
 * Sheets of squares, each shifted a little against the one before. With `upright`, every other
 * sheet is upright.
 */
carving::TriangleMesh Sheets(int sheets, int size, bool upright)
{
  carving::TriangleMesh mesh;
  for (int i = 0; i < sheets; ++i)
  {
    carving::TriangleMesh sheet = models::Sheet(size);
    for (carving::Point& p : sheet.Points)
    {
      p = { p[0] + 0.37 * i / sheets, p[1] + 0.61 * i / sheets, 0.0 };
      if (upright && i % 2 == 1)
      {
        p = { p[0], 0.013 * i, p[1] - 0.5 };
      }
    }
    mesh = models::Joined(mesh, sheet);
  }
  return mesh;
}

/** Arguments: number of sheets, squares along a side, whether every other sheet is upright. */
void ResolveSheets(benchmark::State& state)
{
  const carving::ResolvedMesh given = Clean(AsResolved(Sheets(
    static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), state.range(2) != 0)));
  int pairs = 0;
  double seconds = 0.0;
  std::size_t facets = 0;
  for (auto _ : state)
  {
    carving::ResolvedMesh mesh = given;
    const std::clock_t start = std::clock();
    const std::string error = Resolve(mesh, pairs, {});
    const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    state.SetIterationTime(taken);
    seconds += taken;
    facets = mesh.Facets.size();
    if (!error.empty())
    {
      throw std::runtime_error(error);
    }
  }
  const double ofPair = seconds / static_cast<double>(state.iterations()) / pairs;
  static std::map<bool, double> first;
  state.counters["pairs"] = pairs;
  state.counters["facets"] = static_cast<double>(facets);
  state.counters["growth"] = ofPair / first.try_emplace(state.range(2) != 0, ofPair).first->second;
}

} // namespace

// Ever more squares, ever more coplanar sheets, and crossing sheets.
BENCHMARK(ResolveSheets)
  ->Args({ 4, 16, 0 })
  ->Args({ 4, 32, 0 })
  ->Args({ 4, 64, 0 })
  ->Args({ 4, 128, 0 })
  ->Args({ 8, 32, 0 })
  ->Args({ 16, 32, 0 })
  ->Args({ 4, 16, 1 })
  ->Args({ 4, 64, 1 })
  ->Args({ 16, 32, 1 })
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond);
