// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stream/StoredStream.h"

#include "Core/Mesh/Adjacency.h"
#include "Core/Mesh/LargePages.h"
#include "Core/Mesh/Validity.h"

#include <utility>

namespace carving
{
namespace
{

/** Sets `Sides` from the constraints of the stored cells and from `solidSides`. */
template <int D>
void FindSides(StoredStream<D>& stream, const std::vector<int>& solidSides)
{
  const Decomposition<D>& mesh = stream.Mesh;
  stream.Sides = MakeLarge<std::array<int, 2>>(mesh.Surface.Facets.size());
  for (std::size_t facet = 0; facet < stream.Sides.size(); ++facet)
  {
    stream.Sides[facet] = { solidSides[facet] & 1 ? Solid : Outside,
      solidSides[facet] & 2 ? Solid : Outside };
  }
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      const int facet = mesh.Constraints.Get(cell, f);
      if (facet >= 0)
      {
        stream.Sides[facet][SideOfFacet(mesh, cell, f)] = HalfFace<D>::Of(cell, f);
      }
    }
  }
}

} // namespace

template <int D>
StoredStream<D> Store(
  const Decomposition<D>& mesh, const Classification& regions, const Stream& stream)
{
  StoredStream<D> result;
  const int numberOfCells = static_cast<int>(mesh.Cells.size());
  std::vector<int> newIndex(numberOfCells, Solid);
  std::vector<int> solidSides(mesh.Surface.Facets.size(), 0);
  result.Mesh.Surface = mesh.Surface;
  result.Order.StepPriority = stream.StepPriority;
  const bool all = D == 2 || !mesh.Kept.empty();
  const auto isStored = [&](int cell) { return all || regions.Kind(cell) != RegionKind::Solid; };
  int stored = 0;
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    stored += isStored(cell);
  }
  const auto reserve = [stored](auto&... arrays) { (ReserveLarge(arrays, stored), ...); };
  reserve(result.Mesh.Cells, result.Mesh.Neighbors, result.Regions, result.Order.Step,
    result.Order.Priority, result.Order.Depth);
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    if (isStored(cell))
    {
      newIndex[cell] = static_cast<int>(result.Mesh.Cells.size());
      result.Mesh.Cells.push_back(mesh.Cells[cell]);
      result.Mesh.Neighbors.push_back(mesh.Neighbors[cell]);
      result.Mesh.Constraints.Append(mesh.Constraints.Get(cell));
      result.Regions.push_back(regions.RegionOfCell[cell]);
      result.Order.Step.push_back(stream.Step[cell]);
      result.Order.Priority.push_back(stream.Priority[cell]);
      result.Order.Depth.push_back(stream.Depth[cell]);
      continue;
    }
    for (int f = 0; f <= D; ++f)
    {
      const int facet = mesh.Constraints.Get(cell, f);
      if (facet >= 0)
      {
        solidSides[facet] |= 1 << SideOfFacet(mesh, cell, f);
      }
    }
  }
  for (auto& neighbors : result.Mesh.Neighbors)
  {
    for (int& neighbor : neighbors)
    {
      neighbor = neighbor < 0 ? neighbor : newIndex[neighbor];
    }
  }
  FindSides(result, solidSides);
  return result;
}

StoredStream<3> Store(Tetrahedralization&& mesh, const Classification& regions, Stream&& stream)
{
  StoredStream<3> result;
  result.Mesh = std::move(mesh);
  result.Order = std::move(stream);
  result.Regions = regions.RegionOfCell;
  std::vector<int> solidSides;
  solidSides.reserve(regions.SolidRegions.size());
  for (const auto& [behind, inFront] : regions.SolidRegions)
  {
    solidSides.push_back((behind >= 0 ? 1 : 0) + (inFront >= 0 ? 2 : 0));
  }
  FindSides(result, solidSides);
  return result;
}

template <int D>
bool Connect(StoredStream<D>& stream, const std::vector<int>& solidSides)
{
  if (!CornersDiffer(stream.Mesh.Cells) || !CornersDiffer(stream.Mesh.Surface.Facets) ||
    !FindAdjacency(stream.Mesh))
  {
    return false;
  }
  FindSides(stream, solidSides);
  for (std::size_t facet = 0; facet < stream.Sides.size(); ++facet)
  {
    for (int side = 0; side < 2; ++side)
    {
      const int halfFace = stream.Sides[facet][side];
      if (halfFace >= 0 && stream.Sides[facet][1 - side] == Solid)
      {
        stream.Mesh.Neighbors[HalfFace<D>::Cell(halfFace)][HalfFace<D>::Corner(halfFace)] = Solid;
      }
    }
  }
  return true;
}

template <int D>
std::vector<int> GetSolidSides(const StoredStream<D>& stream)
{
  std::vector<int> result;
  result.reserve(stream.Sides.size());
  for (const auto& [behind, inFront] : stream.Sides)
  {
    result.push_back((behind == Solid ? 1 : 0) + (inFront == Solid ? 2 : 0));
  }
  return result;
}

template StoredStream<2> Store<2>(const Decomposition<2>&, const Classification&, const Stream&);
template StoredStream<3> Store<3>(const Decomposition<3>&, const Classification&, const Stream&);
template bool Connect<2>(StoredStream<2>&, const std::vector<int>&);
template bool Connect<3>(StoredStream<3>&, const std::vector<int>&);
template std::vector<int> GetSolidSides<2>(const StoredStream<2>&);
template std::vector<int> GetSolidSides<3>(const StoredStream<3>&);

} // namespace carving
