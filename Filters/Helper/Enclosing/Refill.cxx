// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * What a PiercedMesh offers to those who replace its tetrahedra.
 */
#include "Helper/Enclosing/PiercedMesh.h"

#include <algorithm>
#include <map>
#include <set>

namespace carving::helper
{
namespace
{

/** Makes neighbors of cells that have a face in common. */
class FaceJoiner
{
public:
  using Structure = PiercedMesh::Delaunay::Triangulation_data_structure;

  explicit FaceJoiner(Structure& structure)
    : Cells(structure)
  {
  }

  void Add(const PiercedMesh::Cell& cell, int f)
  {
    const auto& [a, b, c] = FaceCorners[f];
    std::array<PiercedMesh::Vertex, 3> face = { cell->vertex(a), cell->vertex(b), cell->vertex(c) };
    std::sort(face.begin(), face.end());
    const auto [other, isFirst] = this->Open.try_emplace(face, cell, f);
    if (!isFirst)
    {
      this->Cells.set_adjacency(cell, f, other->second.first, other->second.second);
      this->Open.erase(other);
    }
  }

private:
  Structure& Cells;
  /** The faces of which one cell is known. */
  std::map<std::array<PiercedMesh::Vertex, 3>, std::pair<PiercedMesh::Cell, int>> Open;
};

} // namespace

bool PiercedMesh::IsFace(int part) const
{
  const Triangle& corners = this->Parts.GetParts()[part].Corners;
  Cell cell;
  int i = 0, j = 0, k = 0;
  return this->Mesh.is_facet(this->Vertices[corners[0]], this->Vertices[corners[1]],
    this->Vertices[corners[2]], cell, i, j, k);
}

bool PiercedMesh::IsOnWholeFace(const Cell& cell, const PartContact& contact) const
{
  const int face = contact.How.Face;
  const Triangle& corners = this->Parts.GetParts()[contact.Part].Corners;
  return face >= 0 &&
    std::all_of(corners.begin(), corners.end(),
      [&](int corner)
      {
        const Vertex v = this->Vertices[corner];
        return cell->has_vertex(v) && cell->vertex(face) != v;
      });
}

std::vector<int> PiercedMesh::FindMissing() const
{
  const auto& parts = this->Parts.GetParts();
  std::vector<char> isFace(parts.size(), 0);
  std::vector<int> numberOfCells(parts.size(), 0);
  // Contacts tell faster than a search for each part.
  for (const Cell cell : this->Mesh.finite_cell_handles())
  {
    for (const PartContact& contact : cell->info().All)
    {
      isFace[contact.Part] |= this->IsOnWholeFace(cell, contact);
      ++numberOfCells[contact.Part];
    }
  }
  std::vector<int> missing;
  for (int part = 0; part < static_cast<int>(parts.size()); ++part)
  {
    if (parts[part].Parent >= 0 && !isFace[part])
    {
      missing.push_back(part);
    }
  }
  std::stable_sort(missing.begin(), missing.end(),
    [&](int a, int b) { return numberOfCells[a] < numberOfCells[b]; });
  return missing;
}

std::vector<PiercedMesh::Cell> PiercedMesh::FindCells(int a, int b)
{
  const Vertex from = this->Vertices[a], to = this->Vertices[b];
  const Inexact::Segment_3 segment(from->point(), to->point());
  const auto isCrossed = [&](const Cell& cell, int f)
  {
    const auto [p, q, r] = FaceOf(cell, f);
    return CGAL::do_intersect(segment, Inexact::Triangle_3(p, q, r));
  };
  ++this->NumberOfWalks;
  std::vector<Cell> cells, star;
  this->Mesh.finite_incident_cells(from, std::back_inserter(star));
  for (const Cell& cell : star)
  {
    if (cell->has_vertex(to))
    {
      return {};
    }
    if (isCrossed(cell, cell->index(from)))
    {
      this->Push(cell, cells);
    }
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    for (int f = 0; f < 4; ++f)
    {
      const Cell cell = cells[i];
      const auto isOnFace = [&](const Vertex& v)
      { return cell->has_vertex(v) && cell->index(v) != f; };
      if (!isOnFace(from) && !isOnFace(to) && isCrossed(cell, f))
      {
        this->Push(cell->neighbor(f), cells);
      }
    }
  }
  return cells;
}

PiercedMesh::Vertex PiercedMesh::AddVertex(const Point& p)
{
  const Vertex v = this->Mesh.tds().create_vertex();
  v->set_point(ToInexact(p));
  v->info().Index = this->Parts.AddPoint(p);
  this->Vertices.push_back(v);
  return v;
}

void PiercedMesh::RemoveLastVertices(int count)
{
  for (int i = 0; i < count; ++i)
  {
    this->Mesh.tds().delete_vertex(this->Vertices.back());
    this->Vertices.pop_back();
    this->Parts.RemoveLastPoint();
  }
}

std::vector<PiercedMesh::Cell> PiercedMesh::Refill(
  const std::vector<Cell>& old, const std::vector<std::array<Vertex, 4>>& cells)
{
  const std::vector<int> parts = PartsAt(old);
  const std::set<Cell> removed(old.begin(), old.end());
  FaceJoiner joiner(this->Mesh.tds());
  for (const Cell& cell : old)
  {
    for (int f = 0; f < 4; ++f)
    {
      const Cell neighbor = cell->neighbor(f);
      if (removed.count(neighbor) == 0)
      {
        joiner.Add(neighbor, neighbor->index(cell));
      }
    }
  }
  std::vector<Cell> made, finite;
  for (const auto& [a, b, c, d] : cells)
  {
    const Cell cell = this->Mesh.tds().create_cell(a, b, c, d);
    made.push_back(cell);
    for (int f = 0; f < 4; ++f)
    {
      cell->vertex(f)->set_cell(cell);
      joiner.Add(cell, f);
    }
    if (!this->Mesh.is_infinite(cell))
    {
      finite.push_back(cell);
    }
  }
  this->Mesh.tds().delete_cells(old.begin(), old.end());
  this->MeetAll(parts, finite);
  return made;
}

} // namespace carving::helper
