// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/TouchingVertices.h"

#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/DisjointSets.h"

#include <algorithm>
#include <map>

namespace carving
{
namespace
{

using CellsAtPoint = Buckets<int>::Range;

/** Per point of the stream: whether the level has several vertices there. */
std::vector<char> FindShared(std::size_t numberOfPoints, const std::vector<int>& points)
{
  std::vector<char> isShared(numberOfPoints, 0);
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    if (points[i] == points[i - 1]) // points are in ascending order
    {
      isShared[points[i]] = 1;
    }
  }
  return isShared;
}

/** The place of a cell among the exterior cells at a point; behind the last one for Outside. */
int PlaceOf(const CellsAtPoint& cells, int cell)
{
  return static_cast<int>(
    (cell == Outside ? cells.end() : std::lower_bound(cells.begin(), cells.end(), cell)) -
    cells.begin());
}

/**
 * The parts of the exterior around a point: sets of places, connected through faces at the point.
 */
DisjointSets FindExteriorParts(
  const StoredStream<3>& stream, int step, int point, const CellsAtPoint& cells)
{
  DisjointSets parts(cells.end() - cells.begin() + 1);
  for (const int cell : cells)
  {
    for (int f = 0; f < 4; ++f)
    {
      const int neighbor = stream.Mesh.Neighbors[cell][f];
      const bool isExterior =
        neighbor == Outside || (neighbor >= 0 && stream.Order.Step[neighbor] <= step);
      if (isExterior && stream.Mesh.Cells[cell][f] != point &&
        !stream.Mesh.Constraints.Has(cell, f))
      {
        parts.Unite(PlaceOf(cells, cell), PlaceOf(cells, neighbor));
      }
    }
  }
  return parts;
}

} // namespace

int CountTouchingVertices(
  const StoredStream<3>& stream, const Level<3>& level, const ManifoldLevel<3>& cut)
{
  const std::size_t numberOfPoints = stream.Mesh.Surface.Points.size();
  const std::vector<char> isShared = FindShared(numberOfPoints, cut.Points);
  Buckets<int> cellsAt(numberOfPoints,
    [&](auto&& visit)
    {
      for (int cell = 0; cell < static_cast<int>(stream.Mesh.Cells.size()); ++cell)
      {
        for (const int point : stream.Mesh.Cells[cell])
        {
          if (isShared[point] && stream.Order.Step[cell] <= level.Step)
          {
            visit(point, cell);
          }
        }
      }
    });
  Buckets<int> facesAt(numberOfPoints,
    [&](auto&& visit)
    {
      for (int face = 0; face < static_cast<int>(level.Faces.size()); ++face)
      {
        for (const int point : level.Faces[face].Corners)
        {
          if (isShared[point])
          {
            visit(point, face);
          }
        }
      }
    });
  int count = 0;
  for (int point = 0; point < static_cast<int>(numberOfPoints); ++point)
  {
    if (!isShared[point])
    {
      continue;
    }
    const CellsAtPoint cells = cellsAt[point];
    DisjointSets parts = FindExteriorParts(stream, level.Step, point, cells);
    std::map<int, int> placeOf; // per vertex at the point: a place in front of its faces
    for (const int face : facesAt[point])
    {
      const std::array<int, 3>& corners = level.Faces[face].Corners;
      const auto corner = std::find(corners.begin(), corners.end(), point) - corners.begin();
      const int inFront = InFront(stream, level.Faces[face]);
      const int place = PlaceOf(cells, inFront < 0 ? inFront : HalfFace<3>::Cell(inFront));
      // Where the cut goes through an edge, faces of one vertex have several parts in front.
      parts.Unite(placeOf.emplace(cut.Faces[face][corner], place).first->second, place);
    }
    std::map<int, int> verticesOf; // per part
    for (const auto& [vertex, place] : placeOf)
    {
      ++verticesOf[parts.Find(place)];
    }
    for (const auto& [part, vertices] : verticesOf)
    {
      count += vertices > 1 ? vertices : 0;
    }
  }
  return count;
}

} // namespace carving
