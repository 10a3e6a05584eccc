// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * What a PiercedMesh offers to those who replace its tetrahedra.
 */
#include "Core/Mesh/SortUnique.h"
#include "Helper/Enclosing/PiercedMesh.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

/** Makes neighbors of cells that have a face in common. */
class FaceJoiner
{
public:
  using Structure = PiercedMesh::Delaunay::Triangulation_data_structure;

  void Add(const PiercedMesh::Cell& cell, int f)
  {
    const auto& [a, b, c] = FaceCorners[f];
    Side side = { { cell->vertex(a)->info().Index, cell->vertex(b)->info().Index,
                    cell->vertex(c)->info().Index },
      cell, f };
    std::sort(side.Corners.begin(), side.Corners.end());
    this->Sides.push_back(side);
  }

  void Join(Structure& cells)
  {
    std::sort(this->Sides.begin(), this->Sides.end(),
      [](const Side& a, const Side& b) { return a.Corners < b.Corners; });
    for (std::size_t i = 0; i + 1 < this->Sides.size(); ++i)
    {
      const Side &a = this->Sides[i], &b = this->Sides[i + 1];
      if (a.Corners == b.Corners)
      {
        cells.set_adjacency(a.Of, a.F, b.Of, b.F);
        ++i;
      }
    }
  }

private:
  struct Side
  {
    std::array<int, 3> Corners; ///< in ascending order; -1: infinity
    PiercedMesh::Cell Of;
    int F;
  };
  std::vector<Side> Sides;
};

} // namespace

/** The face that is a part, if there is one. */
std::optional<PiercedMesh::Delaunay::Facet> PiercedMesh::FindFace(int part) const
{
  // CGAL searches the cells around the first vertex. Vertices that were added have few.
  Triangle corners = this->Parts.GetParts()[part].Corners;
  std::sort(corners.rbegin(), corners.rend());
  Cell cell;
  int i = 0, j = 0, k = 0;
  return this->Mesh.is_facet(this->Vertices[corners[0]], this->Vertices[corners[1]],
           this->Vertices[corners[2]], cell, i, j, k)
    ? std::optional(Delaunay::Facet(cell, 6 - i - j - k)) // the remaining one of 0, 1, 2, 3
    : std::nullopt;
}

bool PiercedMesh::IsFace(int part) const
{
  return this->FindFace(part).has_value();
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

std::vector<int> PiercedMesh::CountCells() const
{
  std::vector<int> counts(this->Parts.GetParts().size(), 0);
  for (const Cell cell : this->Mesh.finite_cell_handles())
  {
    for (const PartContact& contact : cell->info().All)
    {
      ++counts[contact.Part];
    }
  }
  return counts;
}

std::vector<int> PiercedMesh::FindMissing() const
{
  const auto& parts = this->Parts.GetParts();
  std::vector<char> isFace(parts.size(), 0);
  // Contacts tell faster than a search for each part.
  for (const Cell cell : this->Mesh.finite_cell_handles())
  {
    for (const PartContact& contact : cell->info().All)
    {
      isFace[contact.Part] |= this->IsOnWholeFace(cell, contact);
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
  this->SetVertex(this->TakeIndex(p), v);
  return v;
}

/** An index for a vertex at a point. */
int PiercedMesh::TakeIndex(const Point& p)
{
  if (this->Free.empty())
  {
    this->Vertices.emplace_back();
    return this->Parts.AddPoint(p);
  }
  const int index = this->Free.back();
  this->Free.pop_back();
  this->Parts.MovePoint(index, p);
  return index;
}

void PiercedMesh::SetVertex(int index, const Vertex& v)
{
  v->set_point(ToInexact(this->Parts.GetPoints()[index]));
  v->info().Index = index;
  this->Vertices[index] = v;
}

void PiercedMesh::Refill(
  const std::vector<Cell>& old, const std::vector<std::array<Vertex, 4>>& cells)
{
  const PartsOfCells parts = this->Collect(old);
  ++this->NumberOfWalks;
  for (const Cell& cell : old)
  {
    cell->info().LastWalk = this->NumberOfWalks;
  }
  FaceJoiner joiner;
  for (const Cell& cell : old)
  {
    for (int f = 0; f < 4; ++f)
    {
      const Cell neighbor = cell->neighbor(f);
      if (neighbor->info().LastWalk != this->NumberOfWalks)
      {
        joiner.Add(neighbor, neighbor->index(cell));
        for (const int i : FaceCorners[f])
        {
          cell->vertex(i)->set_cell(neighbor); // which may be all that is left around it
        }
      }
    }
  }
  std::vector<Cell> finite;
  for (const auto& [a, b, c, d] : cells)
  {
    const Cell cell = this->Mesh.tds().create_cell(a, b, c, d);
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
  joiner.Join(this->Mesh.tds());
  this->Mesh.tds().delete_cells(old.begin(), old.end());
  this->Renew(finite, parts);
}

/** Finds the parts that meet cells. */
PiercedMesh::PartsOfCells PiercedMesh::Collect(const std::vector<Cell>& cells) const
{
  PartsOfCells parts;
  for (const Cell& cell : cells)
  {
    for (const PartContact& contact : cell->info().All)
    {
      const auto& [corners, parent] = this->Parts.GetParts()[contact.Part];
      if (parent >= 0 && this->IsOnWholeFace(cell, contact))
      {
        FaceKey key = corners;
        std::sort(key.begin(), key.end());
        parts.OnFaces.emplace_back(key, contact.Part);
      }
      else if (parent >= 0)
      {
        parts.Others.push_back(contact.Part);
      }
    }
  }
  SortUnique(parts.OnFaces);
  SortUnique(parts.Others);
  return parts;
}

/** Records the contacts of new cells with the parts that met the cells in their place. */
void PiercedMesh::Renew(const std::vector<Cell>& cells, const PartsOfCells& parts)
{
  for (const Cell& cell : cells)
  {
    for (int f = 0; f < 4 && !parts.OnFaces.empty(); ++f)
    {
      const auto& [a, b, c] = FaceCorners[f];
      FaceKey key = { cell->vertex(a)->info().Index, cell->vertex(b)->info().Index,
        cell->vertex(c)->info().Index };
      std::sort(key.begin(), key.end());
      const auto first =
        std::lower_bound(parts.OnFaces.begin(), parts.OnFaces.end(), std::pair(key, -1));
      for (auto at = first; at != parts.OnFaces.end() && at->first == key; ++at)
      {
        cell->info().Add({ at->second, { false, f } });
      }
    }
  }
  if (!parts.Others.empty())
  {
    this->MeetAll(parts.Others, cells);
  }
}

} // namespace carving::helper
