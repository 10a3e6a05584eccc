// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/SurfaceErrors.h"

#include "Core/Mesh/Box.h"

#include <algorithm>
#include <cmath>

namespace carving::helper
{
namespace
{

/**
 * The weight of the squared largest distance beside the quadric error, in areas of the surface that
 * a vertex stands for on average. More weight raises the mean distance and the time.
 */
constexpr double AreasPerVertex = 6.0;

} // namespace

SurfaceErrors::SurfaceErrors(const SurfaceMesh& surface, const FaceDistance<3>& fromStart)
  : Surface(surface)
  , FromStart(fromStart)
  , Quadrics(surface.num_vertices())
{
  const auto [lower, upper] = BoxAround(fromStart.GetTree().GetItems().GetMesh().Points);
  this->Origin = Between(lower, upper, 0.5);
  this->AddPlanes();
}

/** Adds the planes of faces to the quadrics of their vertices, weighted by area. Sums the areas. */
void SurfaceErrors::AddPlanes()
{
  for (const Face face : this->Surface.faces())
  {
    const auto [a, b, c] = CornersOf(this->Surface, face);
    const Point normal = Cross(b - a, c - a);
    const double length = Length(normal);
    if (length > 0.0)
    {
      const Point n = normal / length;
      this->Area += length / 2.0;
      for (const Vertex v : CGAL::vertices_around_face(this->Surface.halfedge(face), this->Surface))
      {
        this->Quadrics[v].AddPlane(n, a - this->Origin, length);
      }
    }
  }
}

LocalError SurfaceErrors::OfEdge(HalfEdge edge) const
{
  const Vertex u = this->Surface.source(edge), v = this->Surface.target(edge);
  const Point middle = Between(this->Surface.point(u), this->Surface.point(v), 0.5);
  Quadric sum = this->Quadrics[u];
  sum.Add(this->Quadrics[v]);
  return { sum.MovedTo(middle - this->Origin), middle };
}

LocalError SurfaceErrors::OfVertex(Vertex vertex) const
{
  const Point& p = this->Surface.point(vertex);
  return { this->Quadrics[vertex].MovedTo(p - this->Origin), p };
}

double SurfaceErrors::CostOf(const Star& star, const LocalError& error, const Point& w) const
{
  const double weight = AreasPerVertex * this->Area / this->Surface.number_of_vertices();
  const double least = error.At(w);
  // Distances that do not count need not be found; the factor makes up for roundings.
  const double farthest =
    this->FindFarthest(star, w, 0.999 * std::sqrt(std::max(least, 0.0) / weight));
  return std::max(least, weight * farthest * farthest);
}

double SurfaceErrors::FindFarthest(const Star& star, const Point& w, double atLeast) const
{
  double farthest = atLeast;
  int nearby = -1;
  const auto add = [&](const Point& p)
  {
    const auto closest = this->FromStart.GetTree().Find(p, farthest, nearby);
    farthest = std::max(farthest, closest.Distance);
    nearby = closest.Item;
  };
  add(w);
  for (const auto& [a, b] : star.Link)
  {
    add((a + b + w) / 3.0);
  }
  return farthest;
}

} // namespace carving::helper
