// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Inserts points into a PiercedMesh that is Delaunay, and stays so.
 */
#include "Helper/Enclosing/PiercedMesh.h"

#include <algorithm>

namespace carving::helper
{

/** Removes parts, calls `meanwhile`, and adds parts. */
void PiercedMesh::Replace(const Subdivision::Change& change, const std::function<void()>& meanwhile)
{
  for (const int part : change.Gone)
  {
    this->Forget(part);
  }
  meanwhile();
  for (const int part : change.Made)
  {
    this->Settle(part);
  }
}

bool PiercedMesh::PutOnPart(int part, const Point& p)
{
  const int corner = this->Parts.GetParts()[part].Corners[0];
  return this->Put(p, this->Vertices[corner]->cell(), true,
    [&](int vertex, Subdivision::Change& change)
    {
      this->Parts.SplitPart(part, vertex, change);
      this->Parts.Legalize(vertex, change);
    });
}

bool PiercedMesh::PutOnEdge(int a, int b, const Point& p)
{
  return this->Put(p, this->Vertices[a]->cell(), true,
    [&](int vertex, Subdivision::Change& change)
    {
      this->Parts.SplitEdge(a, b, vertex, change);
      this->Parts.Legalize(vertex, change);
    });
}

bool PiercedMesh::PutOff(const Point& p, const Cell& near)
{
  return this->Put(p, near, false, [](int, Subdivision::Change&) {});
}

bool PiercedMesh::TakeFaces(int part)
{
  const auto areFaces = [this](int a, int b, int c)
  {
    Cell cell;
    int i = 0, j = 0, k = 0;
    return this->Mesh.is_facet(
      this->Vertices[a], this->Vertices[b], this->Vertices[c], cell, i, j, k);
  };
  Subdivision::Change change;
  const bool taken = this->Parts.SwapTie(part, areFaces, change);
  this->Replace(change, [] {});
  return taken;
}

bool PiercedMesh::Put(const Point& p, const Cell& near, bool outsideToo,
  const std::function<void(int, Subdivision::Change&)>& split)
{
  Delaunay::Locate_type type;
  int i = 0, j = 0;
  const Cell start = this->Mesh.locate(ToInexact(p), type, i, j, near);
  if (type == Delaunay::VERTEX || (type == Delaunay::OUTSIDE_CONVEX_HULL && !outsideToo))
  {
    return false;
  }
  const int vertex = this->Parts.AddPoint(p);
  Subdivision::Change change;
  split(vertex, change);
  this->Replace(change, [&] { this->Insert(vertex, start); });
  return true;
}

std::vector<int> PiercedMesh::PartsAt(const std::vector<Cell>& cells)
{
  std::vector<int> parts;
  for (const Cell& cell : cells)
  {
    for (const PartContact& contact : cell->info().All)
    {
      parts.push_back(contact.Part);
    }
  }
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  return parts;
}

/**
 * Inserts a point into the tetrahedralization. Parts that met removed tetrahedra may meet the new
 * ones.
 */
void PiercedMesh::Insert(int vertex, const Cell& start)
{
  const Inexact::Point_3 p = ToInexact(this->Parts.GetPoints()[vertex]);
  std::vector<Cell> cells;
  Delaunay::Facet facet;
  this->Mesh.find_conflicts(
    p, start, CGAL::Oneset_iterator<Delaunay::Facet>(facet), std::back_inserter(cells));
  const std::vector<int> parts = PartsAt(cells);
  const Vertex v =
    this->Mesh.insert_in_hole(p, cells.begin(), cells.end(), facet.first, facet.second);
  v->info().Index = vertex;
  this->Vertices.push_back(v);
  std::vector<Cell> star;
  this->Mesh.finite_incident_cells(v, std::back_inserter(star));
  this->MeetAll(parts, star);
}

} // namespace carving::helper
