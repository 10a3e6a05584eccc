// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/PiercedMesh.h"

#include "Helper/Base/IndexedBox.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace carving::helper
{
namespace
{

template <std::size_t N>
CGAL::Bbox_3 BoundsOf(const std::array<Inexact::Point_3, N>& corners)
{
  CGAL::Bbox_3 bounds;
  for (const Inexact::Point_3& p : corners)
  {
    bounds += p.bbox();
  }
  return bounds;
}

} // namespace

Corners4 CornersOf(const PiercedMesh::Cell& cell)
{
  return { cell->vertex(0)->point(), cell->vertex(1)->point(), cell->vertex(2)->point(),
    cell->vertex(3)->point() };
}

Corners3 FaceOf(const PiercedMesh::Cell& cell, int f)
{
  Corners3 face;
  for (int i = 0; i < 3; ++i)
  {
    face[i] = cell->vertex(FaceCorners[f][i])->point();
  }
  return face;
}

PiercedMesh::PiercedMesh(const ResolvedMesh& input, const std::vector<Point>& further,
  const std::function<bool(double)>& progress)
  : Parts(input)
{
  for (const Point& p : further)
  {
    this->Parts.AddPoint(p);
  }
  std::vector<std::pair<Inexact::Point_3, VertexInfo>> points;
  for (const Point& p : this->Parts.GetPoints())
  {
    points.push_back({ ToInexact(p), { static_cast<int>(points.size()) } });
  }
  this->Mesh.insert(points.begin(), points.end());
  this->Vertices.resize(points.size());
  for (const Vertex v : this->Mesh.finite_vertex_handles())
  {
    this->Vertices[v->info().Index] = v;
  }
  const int count = static_cast<int>(input.Facets.size());
  for (int t = 0; t < count; ++t)
  {
    this->Place(t);
    if (t % 1000 == 0)
    {
      progress(static_cast<double>(t) / count);
    }
  }
}

Corners3 PiercedMesh::CornersOf(int part) const
{
  const Triangle& corners = this->Parts.GetParts()[part].Corners;
  return { this->Vertices[corners[0]]->point(), this->Vertices[corners[1]]->point(),
    this->Vertices[corners[2]]->point() };
}

/** Finds the contacts of a part that is a face, as most parts are, without a search. */
bool PiercedMesh::PlaceOnFace(int part)
{
  const Triangle& corners = this->Parts.GetParts()[part].Corners;
  Cell cell;
  int i = 0, j = 0, k = 0;
  if (!this->Mesh.is_facet(this->Vertices[corners[0]], this->Vertices[corners[1]],
        this->Vertices[corners[2]], cell, i, j, k))
  {
    return false;
  }
  const int f = 6 - i - j - k; // the remaining one of 0, 1, 2, 3
  const Cell other = cell->neighbor(f);
  for (const auto& [side, face] : { std::pair(cell, f), std::pair(other, other->index(cell)) })
  {
    if (!this->Mesh.is_infinite(side))
    {
      side->info().Add({ part, { false, face } });
    }
  }
  return true;
}

void PiercedMesh::Push(const Cell& cell, std::vector<Cell>& stack)
{
  if (cell->info().LastWalk != this->NumberOfWalks && !this->Mesh.is_infinite(cell))
  {
    cell->info().LastWalk = this->NumberOfWalks;
    stack.push_back(cell);
  }
}

void PiercedMesh::PushStar(const Vertex& v, std::vector<Cell>& stack)
{
  this->Star.clear();
  this->Mesh.finite_incident_cells(v, std::back_inserter(this->Star));
  for (const Cell& cell : this->Star)
  {
    this->Push(cell, stack);
  }
}

/**
 * Visits the tetrahedra that may meet a part: those around one of its corners, and the neighbors of
 * each tetrahedron for which `visit` returns that the part meets it.
 */
template <class Visit>
void PiercedMesh::Walk(int part, const Piercer& piercer, const Visit& visit)
{
  const Triangle& corners = this->Parts.GetParts()[part].Corners;
  ++this->NumberOfWalks;
  for (const int corner : corners)
  {
    this->Vertices[corner]->info().LastWalk = this->NumberOfWalks;
  }
  std::vector<Cell>& stack = this->Stack;
  this->PushStar(this->Vertices[corners[0]], stack);
  while (!stack.empty())
  {
    const Cell cell = stack.back();
    stack.pop_back();
    ++this->Effort;
    if (!visit(cell))
    {
      continue;
    }
    for (int i = 0; i < 4; ++i)
    {
      this->Push(cell->neighbor(i), stack);
      // If an edge of the cell lies in the triangle, the part may continue in cells around that
      // edge that share no face with this cell. Corners of the triangle need no search, since an
      // edge between two of them is on the border.
      const Vertex v = cell->vertex(i);
      if (v->info().LastWalk != this->NumberOfWalks)
      {
        v->info().LastWalk = this->NumberOfWalks;
        if (piercer.SideOf(v->point()) == CGAL::COPLANAR)
        {
          this->PushStar(v, stack);
        }
      }
    }
  }
}

/** Records the contact of a part with a cell; returns whether there is one. */
bool PiercedMesh::Meet(int part, const Piercer& piercer, const Cell& cell)
{
  const Contact contact = piercer.FindContact(helper::CornersOf(cell));
  if (contact.Exists())
  {
    cell->info().Add({ part, contact });
  }
  return contact.Exists();
}

/** Finds the tetrahedra that a part meets. */
void PiercedMesh::Place(int part)
{
  const Corners3 corners = this->CornersOf(part);
  // A part that rounding leaves without area needs no contacts: its neighbors have them.
  if (!this->PlaceOnFace(part) && !CGAL::collinear(corners[0], corners[1], corners[2]))
  {
    const Piercer piercer(corners);
    this->Walk(part, piercer, [&](const Cell& cell) { return this->Meet(part, piercer, cell); });
  }
}

std::vector<PiercedMesh::Cell> PiercedMesh::FindCells(int part)
{
  std::vector<Cell> cells;
  const Piercer piercer(this->CornersOf(part));
  this->Walk(part, piercer,
    [&](const Cell& cell)
    {
      const bool meets = piercer.FindContact(helper::CornersOf(cell)).Exists();
      if (meets)
      {
        cells.push_back(cell);
      }
      return meets;
    });
  return cells;
}

void PiercedMesh::Forget(int part)
{
  this->Walk(part, Piercer(this->CornersOf(part)),
    [&](const Cell& cell) { return cell->info().Remove(part); });
}

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
    this->Place(part);
  }
}

bool PiercedMesh::PutOnPart(int part, const Point& p)
{
  const int corner = this->Parts.GetParts()[part].Corners[0];
  return this->Put(p, this->Vertices[corner]->cell(), true,
    [&](int vertex) { return this->Parts.SplitPart(part, vertex); });
}

bool PiercedMesh::PutOnEdge(int a, int b, const Point& p)
{
  return this->Put(p, this->Vertices[a]->cell(), true,
    [&](int vertex) { return this->Parts.SplitEdge(a, b, vertex); });
}

bool PiercedMesh::PutOff(const Point& p, const Cell& near)
{
  return this->Put(p, near, false, [](int) { return Subdivision::Change(); });
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
  const std::function<Subdivision::Change(int)>& split)
{
  Delaunay::Locate_type type;
  int i = 0, j = 0;
  const Cell start = this->Mesh.locate(ToInexact(p), type, i, j, near);
  if (type == Delaunay::VERTEX || (type == Delaunay::OUTSIDE_CONVEX_HULL && !outsideToo))
  {
    return false;
  }
  const int vertex = this->Parts.AddPoint(p);
  this->Replace(split(vertex), [&] { this->Insert(vertex, start); });
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

/**
 * Records the contacts of parts with cells. Where points in a plane are off it by a rounding, both
 * are numerous and few of them meet.
 */
void PiercedMesh::MeetAll(const std::vector<int>& parts, const std::vector<Cell>& cells)
{
  // CGAL takes boxes of the same index for the same box, even from different sequences.
  const int firstCell = static_cast<int>(parts.size());
  std::vector<IndexedBox> partBoxes, cellBoxes;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    partBoxes.emplace_back(BoundsOf(this->CornersOf(parts[i])), static_cast<int>(i));
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    cellBoxes.emplace_back(BoundsOf(helper::CornersOf(cells[i])), firstCell + static_cast<int>(i));
  }
  std::vector<std::pair<int, int>> pairs;
  CGAL::box_intersection_d(partBoxes.begin(), partBoxes.end(), cellBoxes.begin(), cellBoxes.end(),
    [&](const IndexedBox& part, const IndexedBox& cell)
    { pairs.emplace_back(part.Index, cell.Index - firstCell); });
  std::sort(pairs.begin(), pairs.end());
  this->Effort += pairs.size();
  for (auto pair = pairs.begin(); pair != pairs.end();)
  {
    const int part = pair->first;
    const Piercer piercer(this->CornersOf(parts[part]));
    for (; pair != pairs.end() && pair->first == part; ++pair)
    {
      this->Meet(parts[part], piercer, cells[pair->second]);
    }
  }
}

} // namespace carving::helper
