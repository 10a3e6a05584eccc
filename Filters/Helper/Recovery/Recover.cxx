// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/Recover.h"

#include "Helper/Recovery/Filling.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Vertex = PiercedMesh::Vertex;

constexpr int WholePart = -1; ///< instead of an edge

/** How hard a part is tried: ever harder from pass to pass. */
struct Pass
{
  bool EdgesFirst;
  int Rings;            ///< of cells around those that the part meets
  std::ptrdiff_t Steps; ///< in each cavity
};

constexpr Pass Passes[] = { { false, 0, 4000 }, { true, 1, 20000 }, { true, 2, 100000 } };

/** The cells to be replaced, and their vertices as points of a cavity. */
struct Region
{
  const std::vector<Cell>& Cells;
  std::vector<Vertex> Vertices; ///< per point of the cavity
  std::map<Vertex, int> Indices;
  Cavity Space;
};

class Recoverer
{
public:
  Recoverer(PiercedMesh& mesh, std::ptrdiff_t steps)
    : Mesh(mesh)
    , StepsLeft(steps)
  {
  }

  /** Returns whether the part is a face now. */
  bool TryPart(int part, const Pass& pass);

  bool HasStepsLeft() const
  {
    return this->StepsLeft > 0;
  }

private:
  bool IsInfinite(const Cell& cell) const
  {
    return this->Mesh.GetDelaunay().is_infinite(cell);
  }
  bool IsRecovered(const Cell& cell, int f) const;
  void AddInfinite(int part, std::vector<Cell>& cells) const;
  void Grow(std::vector<Cell>& cells) const;
  void TryEdge(int part, int edge, const Pass& pass);
  bool TryCells(int part, int edge, const std::vector<Cell>& cells, const Pass& pass);
  void AddVertices(int part, Region& region) const;
  Inexact::Point_3 PlaceInfinity(int part, const Cell& cell, int i) const;
  void AddFront(Region& region) const;
  void Demand(int part, int edge, Region& region) const;
  void Commit(const std::vector<Filling::Tetrahedron>& cells, const Region& region);

  PiercedMesh& Mesh;
  std::ptrdiff_t StepsLeft;
};

/** Whether a face of a cell is a part of M. */
bool Recoverer::IsRecovered(const Cell& cell, int f) const
{
  if (this->IsInfinite(cell))
  {
    const Cell other = cell->neighbor(f);
    return !this->IsInfinite(other) && this->IsRecovered(other, other->index(cell));
  }
  const auto& contacts = cell->info().All;
  return std::any_of(contacts.begin(), contacts.end(),
    [&](const PartContact& contact)
    { return contact.How.Face == f && this->Mesh.IsOnWholeFace(cell, contact); });
}

/** Adds the infinite cells at faces of the hull that lie in the plane of a part. */
void Recoverer::AddInfinite(int part, std::vector<Cell>& cells) const
{
  const Piercer piercer(this->Mesh.CornersOf(part));
  const std::size_t count = cells.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    for (int f = 0; f < 4; ++f)
    {
      const Corners3 face = FaceOf(cells[i], f);
      const Cell neighbor = cells[i]->neighbor(f);
      if (this->IsInfinite(neighbor) &&
        std::all_of(face.begin(), face.end(),
          [&](const auto& p) { return piercer.SideOf(p) == CGAL::COPLANAR; }))
      {
        cells.push_back(neighbor);
      }
    }
  }
}

/** Adds a ring of cells, but none behind a part of M. */
void Recoverer::Grow(std::vector<Cell>& cells) const
{
  std::set<Cell> within(cells.begin(), cells.end());
  const std::size_t count = cells.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    for (int f = 0; f < 4 && !this->IsInfinite(cells[i]); ++f)
    {
      const Cell neighbor = cells[i]->neighbor(f);
      if (!this->IsInfinite(neighbor) && !this->IsRecovered(cells[i], f) &&
        within.insert(neighbor).second)
      {
        cells.push_back(neighbor);
      }
    }
  }
}

/** A point that stands for the infinite vertex i of a cell, off the plane of a part. */
Inexact::Point_3 Recoverer::PlaceInfinity(int part, const Cell& cell, int i) const
{
  const Corners3 t = this->Mesh.CornersOf(part);
  const auto normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
  const double scale = std::sqrt((t[1] - t[0]).squared_length() / normal.squared_length());
  const Vertex inside = this->Mesh.GetDelaunay().mirror_vertex(cell, i);
  const double sign = Piercer(t).SideOf(inside->point()) == CGAL::POSITIVE ? -1.0 : 1.0;
  return CGAL::centroid(t[0], t[1], t[2]) + sign * scale * normal;
}

void Recoverer::AddVertices(int part, Region& region) const
{
  const Piercer piercer(this->Mesh.CornersOf(part));
  Cavity& cavity = region.Space;
  for (const Cell& cell : region.Cells)
  {
    for (int i = 0; i < 4; ++i)
    {
      const Vertex v = cell->vertex(i);
      const int index = static_cast<int>(region.Vertices.size());
      if (!region.Indices.try_emplace(v, index).second)
      {
        continue;
      }
      region.Vertices.push_back(v);
      if (this->Mesh.GetDelaunay().is_infinite(v))
      {
        cavity.Infinite = index;
        cavity.AddPoint(this->PlaceInfinity(part, cell, i), false, false);
      }
      else
      {
        cavity.AddPoint(v->point(), true, piercer.SideOf(v->point()) == CGAL::COPLANAR);
      }
    }
  }
}

void Recoverer::AddFront(Region& region) const
{
  const std::set<Cell> within(region.Cells.begin(), region.Cells.end());
  for (const Cell& cell : region.Cells)
  {
    for (int f = 0; f < 4; ++f)
    {
      if (within.count(cell->neighbor(f)) == 0 || this->IsRecovered(cell, f))
      {
        const auto& [a, b, c] = FaceCorners[f];
        region.Space.Front.push_back({ region.Indices.at(cell->vertex(a)),
          region.Indices.at(cell->vertex(c)), region.Indices.at(cell->vertex(b)) });
      }
    }
  }
}

/** Demands that a part, or one of its edges, is there after the filling. */
void Recoverer::Demand(int part, int edge, Region& region) const
{
  const Triangle& corners = this->Mesh.GetParts().GetParts()[part].Corners;
  const auto find = [&](int corner)
  {
    return static_cast<int>(std::find_if(region.Vertices.begin(), region.Vertices.end(),
                              [&](const Vertex& v) { return v->info().Index == corner; }) -
      region.Vertices.begin());
  };
  if (edge == WholePart)
  {
    const Triangle wall = { find(corners[0]), find(corners[1]), find(corners[2]) };
    region.Space.Front.push_back(wall);
    region.Space.Front.push_back(Flipped<3>(wall));
  }
  else
  {
    region.Space.Edge = { find(corners[(edge + 1) % 3]), find(corners[(edge + 2) % 3]) };
  }
}

/** Fills the space of cells anew, with a part or an edge of it. Returns whether it did. */
bool Recoverer::TryCells(int part, int edge, const std::vector<Cell>& cells, const Pass& pass)
{
  Region region{ cells, {}, {}, {} };
  this->AddVertices(part, region);
  if (region.Vertices.size() > MaximumCavityVertices)
  {
    return false;
  }
  this->AddFront(region);
  this->Demand(part, edge, region);
  std::ptrdiff_t steps = pass.Steps;
  Filling filling(region.Space);
  const bool filled = filling.Run(steps);
  this->StepsLeft -= pass.Steps - steps;
  if (filled)
  {
    this->Commit(filling.GetCells(), region);
  }
  return filled;
}

/** Replaces the cells of a region. */
void Recoverer::Commit(const std::vector<Filling::Tetrahedron>& cells, const Region& region)
{
  std::vector<std::array<Vertex, 4>> made;
  for (const Filling::Tetrahedron& cell : cells)
  {
    auto& corners = made.emplace_back();
    for (int i = 0; i < 4; ++i)
    {
      corners[i] = region.Vertices[cell[i]];
    }
  }
  this->Mesh.Refill(region.Cells, made);
}

void Recoverer::TryEdge(int part, int edge, const Pass& pass)
{
  const Triangle& corners = this->Mesh.GetParts().GetParts()[part].Corners;
  std::vector<Cell> cells = this->Mesh.FindCells(corners[(edge + 1) % 3], corners[(edge + 2) % 3]);
  for (int ring = 0; ring <= pass.Rings && !cells.empty(); ++ring)
  {
    if (this->TryCells(part, edge, cells, pass))
    {
      return;
    }
    this->Grow(cells);
  }
}

bool Recoverer::TryPart(int part, const Pass& pass)
{
  for (int edge = 0; edge < 3 && pass.EdgesFirst; ++edge)
  {
    this->TryEdge(part, edge, pass);
  }
  if (this->Mesh.IsFace(part))
  {
    return true;
  }
  std::vector<Cell> cells = this->Mesh.FindCells(part);
  this->AddInfinite(part, cells);
  for (int ring = 0; ring <= pass.Rings && !cells.empty(); ++ring)
  {
    if (this->TryCells(part, WholePart, cells, pass))
    {
      return true;
    }
    this->Grow(cells);
  }
  return false;
}

} // namespace

void Recover(PiercedMesh& mesh, std::ptrdiff_t steps, const std::function<bool(double)>& progress)
{
  std::vector<int> missing = mesh.FindMissing();
  // The cheapest first: with as many steps, more parts are recovered.
  const std::vector<int> counts = mesh.CountCells();
  std::stable_sort(
    missing.begin(), missing.end(), [&](int a, int b) { return counts[a] < counts[b]; });
  Recoverer recoverer(mesh, steps);
  double done = 0.0;
  for (const Pass& pass : Passes)
  {
    const auto isRecovered = [&](int part)
    { return recoverer.HasStepsLeft() && recoverer.TryPart(part, pass); };
    missing.erase(std::remove_if(missing.begin(), missing.end(), isRecovered), missing.end());
    progress(done += 1.0 / static_cast<double>(std::size(Passes)));
  }
}

} // namespace carving::helper
