// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Puts vertices on the edges and faces of a PiercedMesh.
 */
#include "Core/Mesh/SortUnique.h"
#include "Helper/Enclosing/CellShape.h"
#include "Helper/Enclosing/PiercedMesh.h"
#include "Helper/Enclosing/StarShape.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Vertex = PiercedMesh::Vertex;
using Edge = std::array<int, 2>;

/**
 * Whether a point sees an edge of a hull face from inside of that face. The edge is opposite to
 * corner i of the face's infinite cell. A point in the plane of a face beyond a dent may see the
 * edge from outside.
 */
bool SeesBorder(
  const PiercedMesh::Delaunay& mesh, const Cell& outside, int i, const Inexact::Point_3& p)
{
  const auto [j, k] = OtherCorners(i, outside->index(mesh.infinite_vertex()));
  const auto &a = outside->vertex(j)->point(), &b = outside->vertex(k)->point(),
             &c = outside->vertex(i)->point();
  return CGAL::orientation(a, b, c, p) != CGAL::COPLANAR ||
    CGAL::coplanar_orientation(a, b, c, p) == CGAL::POSITIVE;
}

bool IsAmong(const std::vector<Edge>& edges, int a, int b)
{
  return std::any_of(edges.begin(), edges.end(),
    [&](const Edge& edge) { return EdgeKey(edge[0], edge[1]) == EdgeKey(a, b); });
}

} // namespace

PiercedMesh::Place PiercedMesh::PlaceOnEdge(int a, int b, const Point& p) const
{
  Place place{ p, {}, {}, { { a, b } }, {} };
  for (const Cell& cell : this->FindCellsAround(a, b))
  {
    if (this->Mesh.is_infinite(cell))
    {
      place.Outside.push_back(cell);
      continue;
    }
    place.Cells.push_back(cell);
    this->AddPartsWithEdge(cell, a, b, place.Parts);
  }
  if (!place.Outside.empty())
  {
    // A part that is outside of the hull near its edge meets none of these cells.
    std::vector<Cell> around;
    this->Mesh.finite_incident_cells(this->Vertices[a], std::back_inserter(around));
    this->Mesh.finite_incident_cells(this->Vertices[b], std::back_inserter(around));
    for (const Cell& cell : around)
    {
      this->AddPartsWithEdge(cell, a, b, place.Parts);
    }
  }
  return place;
}

/** Adds those parts with a contact with a cell that have an edge. */
void PiercedMesh::AddPartsWithEdge(const Cell& cell, int a, int b, std::vector<int>& parts) const
{
  for (const PartContact& contact : cell->info().All)
  {
    if (this->Parts.HasEdge(contact.Part, a, b))
    {
      parts.push_back(contact.Part);
    }
  }
}

PiercedMesh::Place PiercedMesh::PlaceOnFace(const Cell& cell, int f, const Point& p) const
{
  Place place{ p, {}, {}, {}, {} };
  const Cell other = cell->neighbor(f);
  for (const auto& [side, face] : { std::pair(cell, f), std::pair(other, other->index(cell)) })
  {
    if (this->Mesh.is_infinite(side))
    {
      place.Outside.push_back(side);
      continue;
    }
    place.Cells.push_back(side);
    for (const PartContact& contact : side->info().All)
    {
      if (contact.How.Face == face && this->IsOnWholeFace(side, contact))
      {
        place.Parts.push_back(contact.Part);
      }
    }
  }
  return place;
}

Subdivision::Change PiercedMesh::SplitParts(const Place& place, int vertex)
{
  std::vector<int> parts = place.Parts; // cells share some of them
  SortUnique(parts);
  Subdivision::Change change;
  for (const int part : parts)
  {
    const auto isOfPart = [&](const Edge& edge)
    { return this->Parts.HasEdge(part, edge[0], edge[1]); };
    const auto edge = std::find_if(place.Edges.begin(), place.Edges.end(), isOfPart);
    if (edge == place.Edges.end())
    {
      this->Parts.SplitPart(part, vertex, change);
    }
    else
    {
      this->Parts.SplitAtEdge(part, (*edge)[0], (*edge)[1], vertex, change);
    }
  }
  return change;
}

/** Splits the cells and parts of a place; `insert` makes the vertex among the cells. */
int PiercedMesh::Split(const Place& place, const std::function<Vertex()>& insert)
{
  const int index = this->TakeIndex(place.At);
  const Subdivision::Change change = this->SplitParts(place, index);
  for (const int part : change.Gone)
  {
    if (!this->IsFace(part)) // the part may meet further cells
    {
      this->Forget(part);
    }
  }
  const PartsOfCells parts = this->Collect(place.Cells);
  for (const Cell& cell : place.Cells)
  {
    cell->info() = {};
  }
  const Vertex v = insert();
  this->SetVertex(index, v);
  std::vector<Cell> star;
  this->Mesh.finite_incident_cells(v, std::back_inserter(star));
  this->Renew(star, parts);
  for (const int part : change.Made)
  {
    this->Settle(part);
  }
  return index;
}

/**
 * Whether everything that must stay is on the surface of a star, or at the place, where it is
 * split.
 */
bool PiercedMesh::MayReplace(const StarShape& star, const StarSurface& surface, const Place& place,
  const EdgePredicate& isProtected) const
{
  const auto stays = [&](int a, int b) { return surface.Has(a, b) || IsAmong(place.Edges, a, b); };
  for (const Cell& cell : star.GetCells())
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        const int a = IndexOf(cell, i), b = IndexOf(cell, j);
        if (!surface.Has(a) || !surface.Has(b) ||
          (!stays(a, b) && std::min(a, b) >= 0 && isProtected(a, b)))
        {
          return false;
        }
      }
    }
    for (const PartContact& contact : cell->info().All)
    {
      const bool isSplit =
        std::find(place.Parts.begin(), place.Parts.end(), contact.Part) != place.Parts.end();
      if (this->IsOnWholeFace(cell, contact) && !isSplit &&
        star.Has(cell->neighbor(contact.How.Face)))
      {
        return false;
      }
    }
  }
  return std::all_of(place.Parts.begin(), place.Parts.end(),
    [&](int part)
    {
      const auto& [a, b, c] = this->Parts.GetParts()[part].Corners;
      return stays(a, b) && stays(b, c) && stays(c, a);
    });
}

/**
 * Joins the cells of a place, and as many around them as need be, to a star around a new vertex.
 */
int PiercedMesh::SplitStar(const Place& place, const EdgePredicate& isProtected)
{
  std::vector<Cell> cells = place.Cells;
  cells.insert(cells.end(), place.Outside.begin(), place.Outside.end());
  StarShape star(cells);
  const Inexact::Point_3 at = ToInexact(place.At);
  if (!star.Grow(this->Mesh, at, !place.Outside.empty()))
  {
    return -1;
  }
  const StarSurface surface(star);
  if (!surface.IsSphere() || !this->MayReplace(star, surface, place, isProtected))
  {
    return -1;
  }
  std::vector<std::array<Vertex, 4>> made;
  std::vector<int> corners;
  for (const Cell& cell : star.GetCells())
  {
    for (int i = 0; i < 4; ++i)
    {
      if (star.Has(cell->neighbor(i)))
      {
        continue;
      }
      if (this->Mesh.is_infinite(cell) && !SeesBorder(this->Mesh, cell, i, at))
      {
        return -1;
      }
      made.push_back({ cell->vertex(0), cell->vertex(1), cell->vertex(2), cell->vertex(3) });
      corners.push_back(i);
    }
  }
  const Vertex v = this->AddVertex(place.At);
  const Subdivision::Change change = this->SplitParts(place, v->info().Index);
  for (std::size_t i = 0; i < made.size(); ++i)
  {
    made[i][corners[i]] = v;
  }
  this->Refill(star.GetCells(), made);
  for (const int part : change.Made)
  {
    this->Settle(part);
  }
  return v->info().Index;
}

int PiercedMesh::SplitEdge(int a, int b, const Point& p, const EdgePredicate& isProtected)
{
  const Place place = this->PlaceOnEdge(a, b, p);
  if (place.Cells.empty())
  {
    return -1;
  }
  const Inexact::Point_3 at = ToInexact(p);
  if (IsBeyond(this->Mesh, place.Outside, at))
  {
    return -1;
  }
  const bool isPositive = std::all_of(place.Cells.begin(), place.Cells.end(),
    [&](const Cell& around)
    {
      return IsPositive(around, around->index(this->Vertices[a]), at) &&
        IsPositive(around, around->index(this->Vertices[b]), at);
    });
  const auto insert = [&]
  {
    const Cell cell = place.Cells.front();
    return this->Mesh.tds().insert_in_edge(
      cell, cell->index(this->Vertices[a]), cell->index(this->Vertices[b]));
  };
  return isPositive ? this->Split(place, insert) : this->SplitStar(place, isProtected);
}

int PiercedMesh::SplitFace(
  const Cell& cell, int f, const Point& p, const EdgePredicate& isProtected)
{
  const Place place = this->PlaceOnFace(cell, f, p);
  const Inexact::Point_3 at = ToInexact(p);
  if (IsBeyond(this->Mesh, place.Outside, at))
  {
    return -1;
  }
  const bool isPositive = std::all_of(place.Cells.begin(), place.Cells.end(),
    [&](const Cell& side)
    {
      const int apex = side == cell ? f : side->index(cell);
      return IsPositive(side, (apex + 1) % 4, at) && IsPositive(side, (apex + 2) % 4, at) &&
        IsPositive(side, (apex + 3) % 4, at);
    });
  return isPositive ? this->Split(place, [&] { return this->Mesh.tds().insert_in_facet(cell, f); })
                    : this->SplitStar(place, isProtected);
}

} // namespace carving::helper
