// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How the time to resolve grows with the number of pairs that meet: stacks of sheets in one plane, which
 * cover each other, and sheets that cross. The counter `growth` is the time a pair by that of the smallest
 * mesh of the kind in the same run: about 1 where time is linear in the pairs.
 */
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Resolve.h"
#include "Shapes.h"

#include <benchmark/benchmark.h>

#include <ctime>
#include <map>
#include <stdexcept>

namespace
{

/** Sheets of squares, each shifted a little against the one before; in one plane, or upright in turn. */
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

/** Arguments: number of sheets, squares along a side, whether every other one is upright. */
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

// The first four: ever more squares; then ever more sheets that cover each other; then ones that cross.
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
