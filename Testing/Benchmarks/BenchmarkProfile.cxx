// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The time for the profile and the distances, to be compared with the time for carving the same
 * tetrahedra: trees with about 150,000 and 1,500,000 tetrahedra in the hull.
 */
#include "Core/Carving/Carver.h"
#include "Core/Measure/Profile.h"
#include "Core/Measure/StreamError.h"
#include "Core/Measure/StreamTopology.h"
#include "Core/Stream/StoredStream.h"
#include "Figures.h"
#include "HelperRun.h"

#include <benchmark/benchmark.h>

#include <map>

using namespace carving;

namespace
{

struct Carving
{
  Tetrahedralization Mesh;
  Classification Regions;
  Stream Order;
  StoredStream<3> Stored;
};

const Carving& GetCarving(int leaves)
{
  static std::map<int, Carving> made;
  const auto [found, isNew] = made.try_emplace(leaves);
  Carving& carving = found->second;
  if (isNew)
  {
    carving.Mesh = GetReply(models::Tree(leaves)).Result;
    carving.Regions = Classify(carving.Mesh);
    Carve(carving.Mesh, carving.Regions, {}, carving.Order);
    carving.Stored = Store(carving.Mesh, carving.Regions, carving.Order);
  }
  return carving;
}

void CarveTree(benchmark::State& state)
{
  const Carving& carving = GetCarving(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    Stream stream;
    Carve(carving.Mesh, carving.Regions, {}, stream);
    benchmark::DoNotOptimize(stream);
  }
  state.counters["cells"] = static_cast<double>(carving.Mesh.Cells.size());
}

/** Vertices, triangles, volume and priorities of every step. */
void ProfileSizes(benchmark::State& state)
{
  const Carving& carving = GetCarving(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(ComputeProfile(carving.Stored));
  }
}

/** Components, tunnels and voids of every step. */
void ProfileTopology(benchmark::State& state)
{
  const Carving& carving = GetCarving(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(ComputeTopology(carving.Mesh, carving.Regions, carving.Order));
  }
}

/** The distance of every step from the mesh. */
void ProfileErrors(benchmark::State& state)
{
  const Carving& carving = GetCarving(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    std::vector<double> errors;
    ComputeErrors<3>(carving.Stored, carving.Stored.Mesh.Surface, true, errors);
    benchmark::DoNotOptimize(errors);
  }
}

} // namespace

BENCHMARK(CarveTree)->Arg(4800)->Arg(57000)->Unit(benchmark::kMillisecond);
BENCHMARK(ProfileSizes)->Arg(4800)->Arg(57000)->Unit(benchmark::kMillisecond);
BENCHMARK(ProfileTopology)->Arg(4800)->Arg(57000)->Unit(benchmark::kMillisecond);

BENCHMARK(ProfileErrors)->Arg(4800)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
