// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/HullFace.h"

#include "Core/Mesh/SortUnique.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cfloat>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;

/** Twice the area of a triangle, as a vector along its normal. */
Point AreaVector(const Corners3& corners)
{
  const Point a = ToPoint(corners[0]);
  return Cross(ToPoint(corners[1]) - a, ToPoint(corners[2]) - a);
}

/** The sum of the area vectors of the hull faces that share a corner with one. */
Point SumAround(const PiercedMesh::Delaunay& mesh, const Cell& outside)
{
  Point sum = {};
  const int infinite = outside->index(mesh.infinite_vertex());
  for (int i = 0; i < 4; ++i)
  {
    if (i == infinite)
    {
      continue;
    }
    auto at = mesh.incident_cells(outside, i, infinite);
    const Cell first = at;
    do
    {
      const Cell below = Cell(at)->neighbor(at->index(mesh.infinite_vertex()));
      sum = sum + AreaVector(FaceOf(below, below->index(at)));
      ++at;
    } while (Cell(at) != first);
  }
  return sum;
}

} // namespace

HullFace::HullFace(const PiercedMesh::Delaunay& mesh, const Cell& cell, int f)
  : Corners(FaceOf(cell, f))
  , Origin(ToPoint(Corners[0]))
{
  constexpr double share = 1e-6; // of the sides
  constexpr double roundings = 64.0;
  constexpr double narrow = 1e-10; // width per side
  const Point u = ToPoint(this->Corners[1]) - this->Origin;
  const Point v = ToPoint(this->Corners[2]) - this->Origin;
  const double size = Length(u) + Length(v);
  Point normal = Cross(u, v);
  this->IsNeedle = Length(normal) < narrow * size * size;
  if (this->IsNeedle)
  {
    normal = SumAround(mesh, cell->neighbor(f));
  }
  const double length = Length(normal);
  this->Center = this->Origin + (u + v) / 3.0;
  this->Normal = length > 0.0 ? normal / length : Point{};
  this->Height = std::max(share * size, roundings * DBL_EPSILON * (Length(this->Origin) + size));
}

CGAL::Bbox_3 HullFace::GetBounds() const
{
  const CGAL::Bbox_3 b = BoundsOf(this->Corners);
  const double h = this->Height;
  return { b.xmin() - h, b.ymin() - h, b.zmin() - h, b.xmax() + h, b.ymax() + h, b.zmax() + h };
}

Corners4 HullFace::GetPyramid() const
{
  const auto& [a, b, c] = this->Corners;
  const auto apex = ToInexact(this->Center + this->Height * this->Normal);
  return CGAL::orientation(a, b, c, apex) == CGAL::POSITIVE ? Corners4{ a, b, c, apex }
                                                            : Corners4{ b, a, c, apex };
}

/** Whether a part may be outside of the hull near a hull face. */
bool PiercedMesh::MayPassBeyond(int part, const Cell& cell, int f) const
{
  const Corners3 corners = this->CornersOf(part);
  const HullFace face(this->Mesh, cell, f);
  return CGAL::do_overlap(BoundsOf(corners), face.GetBounds()) &&
    std::any_of(corners.begin(), corners.end(),
      [&face](const Inexact::Point_3& p)
      { return Dot(face.Normal, ToPoint(p) - face.Origin) >= -face.Height; });
}

void PiercedMesh::PierceBelowNeedles()
{
  for (const Cell cell : this->Mesh.finite_cell_handles())
  {
    for (int f = 0; f < 4 && !cell->info().IsPierced(); ++f)
    {
      if (!this->Mesh.is_infinite(cell->neighbor(f)))
      {
        continue;
      }
      const HullFace face(this->Mesh, cell, f);
      if (!face.IsNeedle)
      {
        continue;
      }
      const std::vector<int> parts = this->FindPartsAround(cell, f);
      const auto beyond = std::find_if(parts.begin(), parts.end(),
        [this, pyramid = face.GetPyramid()](int part)
        { return Piercer(this->CornersOf(part)).FindContact(pyramid).Pierces; });
      if (beyond != parts.end())
      {
        cell->info().Add({ *beyond, { true, -1 } });
      }
    }
  }
}

/** The parts that meet the tetrahedra around the corners of a face. */
std::vector<int> PiercedMesh::FindPartsAround(const Cell& cell, int f)
{
  std::vector<int> parts;
  for (int i = 0; i < 4; ++i)
  {
    if (i == f)
    {
      continue;
    }
    std::vector<Cell> star;
    this->Mesh.finite_incident_cells(cell->vertex(i), std::back_inserter(star));
    for (const Cell& around : star)
    {
      for (const PartContact& contact : around->info().All)
      {
        parts.push_back(contact.Part);
      }
    }
  }
  SortUnique(parts);
  return parts;
}

} // namespace carving::helper
