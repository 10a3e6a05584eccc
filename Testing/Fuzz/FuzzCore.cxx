// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fuzz target: carves small decompositions by every rule and checks the properties of the results.
 */
#include "Carving.h"
#include "Chain.h"
#include "Core/Measure/StreamTopology.h"
#include "Core/Mesh/Validity.h"
#include "Core/Solid/DropSolid.h"
#include "Core/Stream/Level.h"
#include "Core/Surface/Manifold.h"
#include "Core/Surface/SurfaceTopology.h"
#include "Decompositions.h"
#include "GluedCount.h"
#include "ManifoldCheck.h"

#include <algorithm>
#include <cstdint>
#include <utility>

using namespace carving;

namespace
{

/**
 * A level has the sizes that the profile states. Cutting it gives a manifold and opens no tunnel.
 */
template <int D>
void CheckLevel(const Carving<D>& carved, int step)
{
  const Level<D> level = ExtractLevel(carved.Stored, step);
  const ManifoldLevel<D> cut = CutIntoManifold(carved.Stored, level);
  Require(static_cast<int>(level.Faces.size()) == carved.Profile.Triangles[step]);
  Require(static_cast<int>(KeepUncut(level).Points.size()) == carved.Profile.Vertices[step]);
  if constexpr (D == 3)
  {
    Require(checks::FindFaults(level, cut) == checks::ManifoldFaults());
    Require(MeasureSurface(cut).Genus <= carved.Profile.Tunnels[step]);
  }
}

/**
 * Voids never decrease, nor do components if M has all points. Volume never grows. Every step has a
 * priority.
 */
template <int D>
void CheckProfile(const Profile& profile, const ResolvedInput<D>& surface)
{
  std::vector<char> used(surface.Points.size(), 0);
  for (const auto& facet : surface.Facets)
  {
    for (const int corner : facet)
    {
      used[corner] = 1;
    }
  }
  const bool allUsed = std::find(used.begin(), used.end(), 0) == used.end();
  Require(!allUsed || std::is_sorted(profile.Components.begin(), profile.Components.end()));
  Require(std::is_sorted(profile.Voids.begin(), profile.Voids.end()));
  Require(std::is_sorted(profile.Volume.rbegin(), profile.Volume.rend()));
  Require(std::all_of(profile.Priority.begin() + 1, profile.Priority.end(),
    [](double priority) { return priority >= 0.0; }));
  Require(std::all_of(
    profile.Tunnels.begin(), profile.Tunnels.end(), [](int tunnels) { return tunnels >= 0; }));
}

/**
 * No approximation exceeds the budget. Components are also counted as tetrahedra connected across
 * faces.
 */
template <int D>
void CheckBudget(const Decomposition<D>& mesh, const Carving<D>& carved)
{
  const auto& [components, tunnels, voids] = carved.Budget;
  const int most = std::max(components, 1); // C0 has one
  const auto holds = [](const std::vector<int>& numbers, int limit)
  { return *std::max_element(numbers.begin(), numbers.end()) <= limit; };
  Require(components < 0 || holds(carved.Profile.Components, most));
  Require(tunnels < 0 || holds(carved.Profile.Tunnels, tunnels));
  Require(voids < 0 || holds(carved.Profile.Voids, voids));
  if constexpr (D == 3)
  {
    for (const int step : carved.Steps)
    {
      Require(components < 0 || CountGlued(mesh, carved.Order, step) <= most);
    }
  }
}

/** Forward and backward, the chain has the sizes that the profile states. */
template <int D>
void CheckChain(const Carving<D>& carved)
{
  Chain<D> chain(carved.Stored);
  int vertices = carved.Profile.Vertices[0], faces = carved.Profile.Triangles[0];
  const auto apply = [&](const ChainUpdate<D>& update)
  {
    faces += static_cast<int>(update.Added.size()) - static_cast<int>(update.Removed.size());
    vertices += static_cast<int>(update.AddedVertices.size()) -
      static_cast<int>(update.RemovedVertices.size());
    Require(faces == carved.Profile.Triangles[chain.GetStep()]);
    Require(vertices == carved.Profile.Vertices[chain.GetStep()]);
  };
  while (chain.HasNext())
  {
    apply(chain.Next());
  }
  while (chain.HasPrevious())
  {
    apply(chain.Previous());
  }
}

/** The parts of a stream that files omit can be restored. */
template <int D>
void CheckRestoring(const StoredStream<D>& stored)
{
  StoredStream<D> restored = stored;
  restored.Mesh.Neighbors.clear();
  restored.Mesh.Constraints = {};
  restored.Sides.clear();
  Require(Connect(restored, GetSolidSides(stored)));
  Require(restored.Mesh.Neighbors == stored.Mesh.Neighbors);
  Require(restored.Mesh.Constraints == stored.Mesh.Constraints);
  Require(restored.Sides == stored.Sides);
}

/** Cutting levels of a damaged stream, as a file may contain it, ends and keeps all faces. */
template <int D>
void CheckDamaged(Bytes& bytes, StoredStream<D> stored, const std::vector<int>& steps)
{
  std::vector<int> sides = GetSolidSides(stored);
  const int numberOfPoints = static_cast<int>(stored.Mesh.Surface.Points.size());
  for (int damages = bytes.Below(4); damages > 0 && !stored.Mesh.Cells.empty(); --damages)
  {
    const int index = bytes.Below(static_cast<int>(stored.Mesh.Cells.size()));
    auto& cell = stored.Mesh.Cells[index];
    switch (bytes.Below(4))
    {
      case 0:
        std::swap(cell[0], cell[1]);
        break;
      case 1:
        cell[0] = bytes.Below(numberOfPoints);
        break;
      case 2:
        stored.Order.Step[index] = steps.back() - stored.Order.Step[index] % (1 + steps.back());
        break;
      default:
        if (!sides.empty())
        {
          sides[index % sides.size()] = bytes.Below(4);
        }
    }
  }
  if (Connect(stored, sides))
  {
    for (const int step : steps)
    {
      const Level<D> level = ExtractLevel(stored, step);
      Require(CutIntoManifold(stored, level).Faces.size() == level.Faces.size());
    }
  }
}

/**
 * Without the cells of the solid, a decomposition is valid and has the same stream and topology.
 */
void CheckWithoutSolid(Tetrahedralization mesh, SolidRule rule)
{
  Classification regions = Classify(mesh, rule);
  Stream order;
  Require(Carve(mesh, regions, {}, order, {}));
  const StoredStream<3> expected = Store(mesh, regions, order);
  const StreamTopology topology = ComputeTopology(mesh, regions, order);
  DropSolid(mesh, regions);
  Require(FindMistake(mesh, regions.SolidRegions).empty());
  Require(Carve(mesh, regions, {}, order, {}));
  const StoredStream<3> found = Store(std::move(mesh), regions, std::move(order));
  Require(found.Mesh.Cells == expected.Mesh.Cells);
  Require(found.Mesh.Neighbors == expected.Mesh.Neighbors);
  Require(found.Order.Step == expected.Order.Step);
  Require(found.Sides == expected.Sides);
  const StreamTopology same = ComputeTopology(found.Mesh, regions, found.Order);
  Require(same.Components == topology.Components);
  Require(same.Tunnels == topology.Tunnels && same.Voids == topology.Voids);
}

template <int D>
void Check(Bytes& bytes)
{
  const Decomposition<D> mesh = MakeDecomposition<D>(bytes);
  Require(FindMistake(mesh).empty());
  const Carving<D> carved = CarveWith(bytes, mesh);
  for (const int step : carved.Steps)
  {
    CheckLevel(carved, step);
  }
  CheckProfile(carved.Profile, mesh.Surface);
  CheckBudget(mesh, carved);
  CheckChain(carved);
  CheckRestoring(carved.Stored);
  if constexpr (D == 3)
  {
    if (mesh.Kept.empty())
    {
      CheckWithoutSolid(mesh, static_cast<SolidRule>(bytes.Below(3)));
    }
  }
  CheckDamaged(bytes, carved.Stored, carved.Steps);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  if (bytes.Below(4) == 0)
  {
    Check<2>(bytes);
  }
  else
  {
    Check<3>(bytes);
  }
  return 0;
}
