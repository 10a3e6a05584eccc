// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/Refine.h"

#include "Core/Mesh/Vector.h"
#include "Helper/Enclosing/ExposedFaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Corners = SurfaceDistance::Corners;

Point CornerOf(const Cell& cell, int i)
{
  return ToPoint(cell->vertex(i)->point());
}

double DistanceToCorners(const Cell& cell, const Point& p)
{
  double nearest = HUGE_VAL;
  for (int i = 0; i < 4; ++i)
  {
    nearest = std::min(nearest, Length(p - CornerOf(cell, i)));
  }
  return nearest;
}

/** The intersection of a triangle with a cell, a convex polygon, except for rounding. */
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

/** Adds points to a mesh where pierced cells reach too far. */
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

  /** The corners of the pierced cells that reach too far from M. */
  std::vector<std::array<PiercedMesh::Vertex, 4>> FindFar() const;

  /** Makes a cell less pierced or smaller; returns whether the mesh has changed. */
  bool Improve(const Cell& cell);

private:
  /** A number from 0 to 1. */
  double Draw()
  {
    return this->Random() / static_cast<double>(std::mt19937::max());
  }
  Point DrawPoint(const std::vector<Point>& polygon);
  int FindEdgeToSplit(int part, const Point& p) const;
  bool PutOnPart(int part, const Point& p);
  bool PutOff(const Cell& cell);

  PiercedMesh& Mesh;
  const SurfaceDistance& Distance;
  double Tolerance;
  double Spacing; ///< the least distance between points on M
  /**
   * Points are drawn at random, since regular points are cocircular and make every diagonal a tie.
   */
  std::mt19937 Random;
};

std::vector<std::array<PiercedMesh::Vertex, 4>> Refiner::FindFar() const
{
  std::vector<std::array<PiercedMesh::Vertex, 4>> far;
  for (const Cell cell : this->Mesh.GetDelaunay().finite_cell_handles())
  {
    if (ReachesTooFar(this->Mesh, cell, this->Distance, this->Tolerance))
    {
      far.push_back({ cell->vertex(0), cell->vertex(1), cell->vertex(2), cell->vertex(3) });
    }
  }
  return far;
}

Point Refiner::DrawPoint(const std::vector<Point>& polygon)
{
  Point sum = {};
  double total = 0.0;
  for (const Point& p : polygon)
  {
    const double weight = 1.0 + 0.5 * this->Draw();
    total += weight;
    sum = sum + weight * p;
  }
  return sum / total;
}

bool Refiner::Improve(const Cell& cell)
{
  double farthest = this->Spacing;
  int best = -1;
  Point place;
  const std::vector<PartContact> contacts = cell->info().All;
  for (const auto& [part, contact] : contacts)
  {
    if (!contact.Pierces)
    {
      continue;
    }
    if (this->Mesh.TakeFaces(part))
    {
      return true;
    }
    const std::vector<Point> polygon = Clip(this->Mesh.GetParts().GetCorners(part), cell);
    if (polygon.empty())
    {
      continue;
    }
    const Point p = this->DrawPoint(polygon);
    const double nearest = DistanceToCorners(cell, p);
    if (nearest > farthest)
    {
      farthest = nearest;
      best = part;
      place = p;
    }
  }
  return (best >= 0 && this->PutOnPart(best, place)) || this->PutOff(cell);
}

/** The edge, by its opposite corner, that is to be split instead of the part; -1: none. */
int Refiner::FindEdgeToSplit(int part, const Point& p) const
{
  const Corners t = this->Mesh.GetParts().GetCorners(part);
  const Point normal = Cross(t[1] - t[0], t[2] - t[0]);
  // An edge of M whose diametral sphere contains the point would no longer be Delaunay.
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
  constexpr double TooNear = 0.1; // to an edge of the part: splitting the part would leave a sliver
  const int nearest = static_cast<int>(std::min_element(share, share + 3) - share);
  return edge < 0 && share[nearest] < TooNear ? nearest : edge;
}

bool Refiner::PutOnPart(int part, const Point& p)
{
  const int edge = this->FindEdgeToSplit(part, p);
  if (edge < 0)
  {
    return this->Mesh.PutOnPart(part, p);
  }
  const Triangle corners = this->Mesh.GetParts().GetParts()[part].Corners;
  const Corners t = this->Mesh.GetParts().GetCorners(part);
  const int first = (edge + 1) % 3, second = (edge + 2) % 3;
  return Length(t[second] - t[first]) >= 2.0 * this->Spacing &&
    this->Mesh.PutOnEdge(
      corners[first], corners[second], Between(t[first], t[second], 0.4 + 0.2 * this->Draw()));
}

/**
 * Adds the cell's circumcenter, or else its centroid, for a cell that M pierces although points on
 * M are dense.
 */
bool Refiner::PutOff(const Cell& cell)
{
  const Point centroid = Between(Between(CornerOf(cell, 0), CornerOf(cell, 1), 0.5),
    Between(CornerOf(cell, 2), CornerOf(cell, 3), 0.5), 0.5);
  return this->Mesh.PutOff(ToPoint(this->Mesh.GetDelaunay().dual(cell)), cell) ||
    this->Mesh.PutOff(centroid, cell);
}

} // namespace

void Refine(PiercedMesh& mesh, const SurfaceDistance& distance, double tolerance,
  std::size_t maximumPoints, const std::function<bool(double)>& progress)
{
  Refiner refiner(mesh, distance, tolerance);
  const auto& points = mesh.GetParts().GetPoints();
  const std::size_t given = points.size(), start = mesh.GetEffort();
  // Where many points of a plane are off it by a rounding, thousands of parts pierce a tetrahedron
  // that covers the plane, and each point that is added there changes as many tetrahedra.
  constexpr std::size_t Initial = 10000000, PerPoint = 2000;
  const auto mayContinue = [&]
  {
    const std::size_t added = points.size() - given;
    return added < maximumPoints && mesh.GetEffort() - start < Initial + PerPoint * added;
  };
  bool changed = true;
  for (double left = 1.0; changed && mayContinue(); left *= 0.8)
  {
    changed = false;
    for (const auto& [a, b, c, d] : refiner.FindFar())
    {
      Cell cell;
      if (mayContinue() && mesh.GetDelaunay().is_cell(a, b, c, d, cell) && cell->info().IsPierced())
      {
        changed = refiner.Improve(cell) || changed;
      }
    }
    progress(1.0 - left);
  }
}

} // namespace carving::helper
