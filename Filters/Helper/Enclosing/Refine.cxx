// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/Refine.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace carving;

namespace
{

using Cell = PiercedMesh::Cell;
using Corners = SurfaceDistance::Corners;

Corners FacePoints(const Cell& cell, int f)
{
  const Corners3 face = FaceOf(cell, f);
  return { ToPoint(face[0]), ToPoint(face[1]), ToPoint(face[2]) };
}

Point CornerOf(const Cell& cell, int i)
{
  return ToPoint(cell->vertex(i)->point());
}

/** No point of a pierced cell is farther from M. */
double LongestEdge(const Cell& cell)
{
  double longest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    for (int k = 0; k < i; ++k)
    {
      longest = std::max(longest, Length(CornerOf(cell, i) - CornerOf(cell, k)));
    }
  }
  return longest;
}

/** Whether a face of a pierced cell bounds all that is pierced. */
bool Shows(const PiercedMesh& mesh, const Cell& cell, int f)
{
  const Cell other = cell->neighbor(f);
  return mesh.GetDelaunay().is_infinite(other) || !other->info().IsPierced();
}

/** The part of a triangle within a cell, or nearly so: a convex polygon. */
std::vector<Point> Clip(const Corners& triangle, const Cell& cell)
{
  constexpr double Slack = 1e-9;
  std::vector<Point> polygon(triangle.begin(), triangle.end());
  for (int f = 0; f < 4; ++f)
  {
    const Corners face = FacePoints(cell, f);
    const Point normal = Cross(face[1] - face[0], face[2] - face[0]);
    const double limit = Slack * Length(normal) * Length(face[1] - face[0]);
    const auto height = [&](const Point& p) { return Dot(normal, p - face[0]) - limit; };
    std::vector<Point> clipped;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double atP = height(p), atQ = height(q);
      if (atP <= 0.0)
      {
        clipped.push_back(p);
      }
      if ((atP < 0.0 && atQ > 0.0) || (atP > 0.0 && atQ < 0.0))
      {
        clipped.push_back(Between(p, q, atP / (atP - atQ)));
      }
    }
    polygon = std::move(clipped);
  }
  return polygon;
}

class Refiner
{
public:
  Refiner(PiercedMesh& mesh, const SurfaceDistance& distance, double tolerance)
    : Mesh(mesh)
    , Distance(distance)
    , Tolerance(tolerance)
    , Spacing(tolerance / 4.0)
  {
  }

  /** The corners of the cells that reach too far. */
  std::vector<std::array<PiercedMesh::Vertex, 4>> FindFar() const;

  /** Takes a step towards a cell that is not pierced or not as large; returns whether there was one. */
  bool Improve(const Cell& cell);

private:
  Point SomewhereIn(const std::vector<Point>& polygon);
  bool PutOnPart(int part, const Point& p);
  bool PutAside(const Cell& cell);

  PiercedMesh& Mesh;
  const SurfaceDistance& Distance;
  double Tolerance;
  double Spacing; ///< between points on M
  /** Points are drawn: regular ones lie on common circles, for which all diagonals are alike. */
  std::mt19937 Random;
};

std::vector<std::array<PiercedMesh::Vertex, 4>> Refiner::FindFar() const
{
  std::vector<std::array<PiercedMesh::Vertex, 4>> far;
  for (const Cell cell : this->Mesh.GetDelaunay().finite_cell_handles())
  {
    CellContacts& info = cell->info();
    if (!info.IsPierced())
    {
      continue;
    }
    for (int f = 0; f < 4; ++f)
    {
      if (info.Near[f] || !Shows(this->Mesh, cell, f))
      {
        continue;
      }
      info.Near[f] = LongestEdge(cell) <= this->Tolerance ||
        this->Distance.IsWithin(FacePoints(cell, f), this->Tolerance);
      if (!info.Near[f])
      {
        far.push_back({ cell->vertex(0), cell->vertex(1), cell->vertex(2), cell->vertex(3) });
        break;
      }
    }
  }
  return far;
}

Point Refiner::SomewhereIn(const std::vector<Point>& polygon)
{
  Point sum = {};
  double total = 0.0;
  for (const Point& p : polygon)
  {
    const double weight = 1.0 + 0.5 * (this->Random() / static_cast<double>(std::mt19937::max()));
    total += weight;
    for (int i = 0; i < 3; ++i)
    {
      sum[i] += weight * p[i];
    }
  }
  return { sum[0] / total, sum[1] / total, sum[2] / total };
}

bool Refiner::Improve(const Cell& cell)
{
  double farthest = this->Spacing;
  int best = -1;
  Point place;
  const std::vector<PartContact> contacts = cell->info().All;
  for (const PartContact& contact : contacts)
  {
    if (!contact.How.Pierces)
    {
      continue;
    }
    if (this->Mesh.TakeFaces(contact.Part))
    {
      return true;
    }
    const std::vector<Point> polygon = Clip(this->Mesh.GetParts().GetCorners(contact.Part), cell);
    if (polygon.empty())
    {
      continue;
    }
    const Point p = this->SomewhereIn(polygon);
    double nearest = HUGE_VAL;
    for (int i = 0; i < 4; ++i)
    {
      nearest = std::min(nearest, Length(p - CornerOf(cell, i)));
    }
    if (nearest > farthest)
    {
      farthest = nearest;
      best = contact.Part;
      place = p;
    }
  }
  return (best >= 0 && this->PutOnPart(best, place)) || this->PutAside(cell);
}

bool Refiner::PutOnPart(int part, const Point& p)
{
  const Triangle corners = this->Mesh.GetParts().GetParts()[part].Corners;
  const Corners t = this->Mesh.GetParts().GetCorners(part);
  const Point normal = Cross(t[1] - t[0], t[2] - t[0]);
  // An edge of M that has the point in its diametral sphere is not Delaunay once the point is there.
  int edge = -1;
  double longest = 0.0, share[3];
  for (int i = 0; i < 3; ++i)
  {
    const Point &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
    share[i] = Dot(Cross(a - p, b - p), normal) / Dot(normal, normal);
    const double length = Length(b - a);
    if (Dot(a - p, b - p) < 0.0 && length > longest && this->Mesh.GetParts().OnEdgeOfInput(part, i))
    {
      longest = length;
      edge = i;
    }
  }
  constexpr double TooNear = 0.1; // to an edge of the part: it would leave a sliver
  const int nearest = static_cast<int>(std::min_element(share, share + 3) - share);
  if (edge < 0 && share[nearest] < TooNear)
  {
    edge = nearest;
  }
  if (edge < 0)
  {
    return this->Mesh.PutOnPart(part, p);
  }
  const Point &a = t[(edge + 1) % 3], &b = t[(edge + 2) % 3];
  if (Length(b - a) < 2.0 * this->Spacing)
  {
    return false;
  }
  const double t01 = 0.4 + 0.2 * (this->Random() / static_cast<double>(std::mt19937::max()));
  return this->Mesh.PutOnEdge(corners[(edge + 1) % 3], corners[(edge + 2) % 3], Between(a, b, t01));
}

/** Where M has points enough and still crosses a cell: at the cell's circumcenter, or within it. */
bool Refiner::PutAside(const Cell& cell)
{
  const Point centroid = Between(Between(CornerOf(cell, 0), CornerOf(cell, 1), 0.5),
    Between(CornerOf(cell, 2), CornerOf(cell, 3), 0.5), 0.5);
  return this->Mesh.PutAside(ToPoint(this->Mesh.GetDelaunay().dual(cell)), cell) ||
    this->Mesh.PutAside(centroid, cell);
}

} // namespace

void Refine(PiercedMesh& mesh, const SurfaceDistance& distance, double tolerance,
  std::size_t maximumPoints, const std::function<bool(double)>& progress)
{
  Refiner refiner(mesh, distance, tolerance);
  const auto& points = mesh.GetParts().GetPoints();
  const std::size_t most = points.size() + maximumPoints;
  bool changed = true;
  for (double left = 1.0; changed && points.size() < most; left *= 0.8)
  {
    changed = false;
    for (const auto& [a, b, c, d] : refiner.FindFar())
    {
      Cell cell;
      if (points.size() < most && mesh.GetDelaunay().is_cell(a, b, c, d, cell) &&
        cell->info().IsPierced())
      {
        changed = refiner.Improve(cell) || changed;
      }
    }
    progress(1.0 - left);
  }
}

double Reach(const PiercedMesh& mesh, const SurfaceDistance& distance, double negligible)
{
  double reach = 0.0;
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    for (int f = 0; f < 4 && cell->info().IsPierced(); ++f)
    {
      if (Shows(mesh, cell, f) && LongestEdge(cell) > reach)
      {
        reach = distance.Farthest(FacePoints(cell, f), std::max(reach, negligible));
      }
    }
  }
  return reach;
}
