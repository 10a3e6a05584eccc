// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The time of carving with budgets relative to carving without, as a ratio within one run, at about
 * 150,000 and 1.5 million tetrahedra.
 */
#include "Core/Carving/Carver.h"
#include "Figures.h"
#include "HelperRun.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <random>

namespace
{

struct Tetrahedra
{
  carving::Tetrahedralization Mesh;
  carving::Classification Regions;
};

/** n small triangles all over a cube, which seldom touch. */
carving::TriangleMesh Crumbs(int n)
{
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit;
  carving::TriangleMesh mesh;
  const double size = 0.3 / std::cbrt(n);
  for (int i = 0; i < n; ++i)
  {
    const carving::Point center = { unit(random), unit(random), unit(random) };
    for (int corner = 0; corner < 3; ++corner)
    {
      mesh.Points.push_back({ center[0] + size * unit(random), center[1] + size * unit(random),
        center[2] + size * unit(random) });
    }
    mesh.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return mesh;
}

/** `model` 0: a tree with `parts` leaves. `model` 1: `parts` small triangles. */
const Tetrahedra& GetTetrahedra(int model, int parts)
{
  static std::map<std::pair<int, int>, Tetrahedra> known;
  const auto [found, isNew] = known.try_emplace({ model, parts });
  if (isNew)
  {
    found->second.Mesh = GetReply(model == 0 ? models::Tree(parts) : Crumbs(parts)).Result;
    found->second.Regions = carving::Classify(found->second.Mesh);
  }
  return found->second;
}

/** Returns processor time in seconds, which does not depend on other programs. */
double Carve(
  const Tetrahedra& tetrahedra, const carving::BettiNumbers& budget, carving::Stream& stream)
{
  carving::CarveOptions options;
  options.Budget = budget;
  const std::clock_t start = std::clock();
  carving::Carve(tetrahedra.Mesh, tetrahedra.Regions, options, stream);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/** Arguments: the model, its parts, and the limits of components, tunnels and voids. */
void CarveWithBudget(benchmark::State& state)
{
  const Tetrahedra& tetrahedra =
    GetTetrahedra(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const carving::BettiNumbers budget = { static_cast<int>(state.range(2)),
    static_cast<int>(state.range(3)), static_cast<int>(state.range(4)) };
  carving::Stream stream;
  double with = 0.0, without = 0.0;
  for (auto _ : state)
  {
    without += Carve(tetrahedra, { -1, -1, -1 }, stream);
    const double seconds = Carve(tetrahedra, budget, stream);
    with += seconds;
    state.SetIterationTime(seconds);
  }
  state.counters["ratio"] = with / without;
  state.counters["tetrahedra"] = static_cast<double>(stream.Step.size());
  state.counters["left"] =
    static_cast<double>(std::count(stream.Step.begin(), stream.Step.end(), carving::Stream::Never));
}

void WithAllBudgets(benchmark::internal::Benchmark* benchmark)
{
  for (const auto& [model, parts] :
    { std::pair(0, 4800), std::pair(0, 48000), std::pair(1, 8000), std::pair(1, 80000) })
  {
    for (const auto& [components, tunnels, voids] :
      { std::tuple(1000000, 1000000, 1000000), std::tuple(1, 0, 0), std::tuple(1, -1, -1),
        std::tuple(-1, 0, -1), std::tuple(-1, 10, -1), std::tuple(100, 100, 0) })
    {
      benchmark->Args({ model, parts, components, tunnels, voids });
    }
  }
}

} // namespace

BENCHMARK(CarveWithBudget)->Apply(WithAllBudgets)->UseManualTime()->Unit(benchmark::kMillisecond);
