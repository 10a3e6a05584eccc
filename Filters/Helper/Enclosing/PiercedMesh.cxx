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
    VertexInfo info;
    info.Index = static_cast<int>(points.size());
    points.emplace_back(ToInexact(p), info);
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
    this->Settle(t);
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
bool PiercedMesh::SettleOnFace(int part)
{
  const std::optional<Delaunay::Facet> found = this->FindFace(part);
  if (!found)
  {
    return false;
  }
  const auto& [cell, f] = *found;
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
void PiercedMesh::Settle(int part)
{
  const Corners3 corners = this->CornersOf(part);
  if (this->SettleOnFace(part))
  {
    return;
  }
  if (CGAL::collinear(corners[0], corners[1], corners[2]))
  {
    this->Parts.Take(part); // rounding leaves it without area: its neighbors are enough
    return;
  }
  const Piercer piercer(corners);
  this->Walk(part, piercer, [&](const Cell& cell) { return this->Meet(part, piercer, cell); });
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
