// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Replaces a few tetrahedra of a PiercedMesh by others with the same corners.
 */
#include "Helper/Enclosing/CellShape.h"
#include "Helper/Enclosing/PiercedMesh.h"

#include <algorithm>
#include <set>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Vertex = PiercedMesh::Vertex;

/** The least quality of a tetrahedron that a flip makes. */
constexpr double LeastQuality = 1e-5;

std::array<Vertex, 4> WithCorner(const Cell& cell, int i, const Vertex& v)
{
  std::array<Vertex, 4> corners = { cell->vertex(0), cell->vertex(1), cell->vertex(2),
    cell->vertex(3) };
  corners[i] = v;
  return corners;
}

} // namespace

bool PiercedMesh::FlipFace(const Cell& cell, int f)
{
  const Cell other = cell->neighbor(f);
  if (this->Mesh.is_infinite(cell) || this->Mesh.is_infinite(other) || cell->info().PartOn(f) >= 0)
  {
    return false;
  }
  const Vertex apex = other->vertex(other->index(cell));
  std::vector<std::array<Vertex, 4>> made;
  for (int i = 0; i < 4; ++i)
  {
    if (i != f)
    {
      if (QualityOf(MovedCorners(cell, i, apex->point())) < LeastQuality)
      {
        return false;
      }
      made.push_back(WithCorner(cell, i, apex));
    }
  }
  this->Refill({ cell, other }, made);
  return true;
}

bool PiercedMesh::FlipEdge(int a, int b, const std::array<Cell, 3>& cells)
{
  const Vertex from = this->Vertices[a], to = this->Vertices[b];
  const auto mayGo = [&](const Cell& cell)
  {
    const auto& contacts = cell->info().All;
    return !this->Mesh.is_infinite(cell) &&
      std::all_of(contacts.begin(), contacts.end(),
        [&](const PartContact& contact)
        { return contact.How.Face == cell->index(from) || contact.How.Face == cell->index(to); });
  };
  if (!std::all_of(cells.begin(), cells.end(), mayGo))
  {
    return false;
  }
  const Cell& cell = cells[0];
  Vertex third; // the corner of the others that the first cell lacks
  for (int i = 0; i < 4; ++i)
  {
    third = cell->has_vertex(cells[1]->vertex(i)) ? third : cells[1]->vertex(i);
  }
  std::vector<std::array<Vertex, 4>> made;
  for (const int i : { cell->index(from), cell->index(to) })
  {
    if (QualityOf(MovedCorners(cell, i, third->point())) < LeastQuality)
    {
      return false;
    }
    made.push_back(WithCorner(cell, i, third));
  }
  this->Refill({ cells.begin(), cells.end() }, made);
  return true;
}

/** Makes a vertex where the two diagonals of a flat quadrilateral cross. */
PiercedMesh::Flattened PiercedMesh::RemoveCrossed(
  const Cell& cell, const std::array<std::vector<int>, 2>& faces, const EdgePredicate& isProtected)
{
  Flattened result;
  Place place{};
  for (int side = 0; side < 2; ++side)
  {
    const auto [i, j] = OtherCorners(faces[side][0], faces[side][1]);
    result.Edges[side] = { cell->vertex(i)->info().Index, cell->vertex(j)->info().Index };
    const Place edge = this->PlaceOnEdge(result.Edges[side][0], result.Edges[side][1], {});
    if (!edge.Outside.empty())
    {
      return result; // what is flat on the hull has nothing on its other side
    }
    place.Cells.insert(place.Cells.end(), edge.Cells.begin(), edge.Cells.end());
    place.Parts.insert(place.Parts.end(), edge.Parts.begin(), edge.Parts.end());
    place.Edges.push_back(result.Edges[side]);
  }
  // The flat cell itself is around both edges, and another one if it has the same corners.
  place.Cells.erase(std::find(place.Cells.begin(), place.Cells.end(), cell));
  if (std::set<Cell>(place.Cells.begin(), place.Cells.end()).size() < place.Cells.size())
  {
    return result;
  }
  const auto& points = this->Parts.GetPoints();
  const Point &a = points[place.Edges[0][0]], &b = points[place.Edges[0][1]],
              &c = points[place.Edges[1][0]], &d = points[place.Edges[1][1]];
  const Point normal = Cross(b - a, d - c);
  const double share = Dot(Cross(c - a, d - c), normal) / Dot(normal, normal);
  if (share > 0.0 && share < 1.0)
  {
    place.At = Between(a, b, share);
    result.Crossing = this->SplitStar(place, isProtected);
    result.IsRemoved = result.Crossing >= 0;
  }
  return result;
}

/** Replaces a flat cell below face f, and the cell above, by three. */
bool PiercedMesh::RemoveCovered(const Cell& cell, int f)
{
  const Cell above = cell->neighbor(f);
  if (this->Mesh.is_infinite(above))
  {
    return false;
  }
  const Vertex below = cell->vertex(f);
  std::vector<std::array<Vertex, 4>> made;
  for (int i = 0; i < 4; ++i)
  {
    if (i != above->index(cell))
    {
      if (!IsPositive(above, i, below->point()))
      {
        return false;
      }
      made.push_back(WithCorner(above, i, below));
    }
  }
  std::vector<int> parts; // go through the vertex below
  for (const PartContact& contact : cell->info().All)
  {
    if (contact.How.Face == f)
    {
      if (!this->IsOnWholeFace(cell, contact))
      {
        return false;
      }
      parts.push_back(contact.Part);
    }
  }
  Subdivision::Change change;
  for (const int part : parts)
  {
    this->Parts.SplitPart(part, below->info().Index, change);
  }
  this->Refill({ cell, above }, made);
  for (const int part : change.Made)
  {
    this->Settle(part);
  }
  return true;
}

PiercedMesh::Flattened PiercedMesh::RemoveFlat(const Cell& cell, const EdgePredicate& isProtected)
{
  std::array<Point, 4> normals;
  int largest = 0;
  for (int f = 0; f < 4; ++f)
  {
    const Corners3 c = FaceOf(cell, f);
    normals[f] = Cross(ToPoint(c[1]) - ToPoint(c[0]), ToPoint(c[2]) - ToPoint(c[0]));
    largest = Length(normals[f]) > Length(normals[largest]) ? f : largest;
  }
  std::array<std::vector<int>, 2> faces; // below, above
  for (int f = 0; f < 4; ++f)
  {
    faces[Dot(normals[f], normals[largest]) > 0.0].push_back(f);
  }
  if (faces[0].size() == 2)
  {
    return this->RemoveCrossed(cell, faces, isProtected);
  }
  Flattened result;
  const auto& alone = faces[0].size() == 1 ? faces[0] : faces[1];
  result.IsRemoved = alone.size() == 1 && this->RemoveCovered(cell, alone[0]);
  return result;
}

} // namespace carving::helper
