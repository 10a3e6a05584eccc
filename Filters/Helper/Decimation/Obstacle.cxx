// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/Obstacle.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Decimation/LostParts.h"

#include <algorithm>
#include <cmath>

namespace carving::helper
{
namespace
{

/** The distance that contacts leave, as a fraction of M's diagonal: well above rounding errors. */
constexpr double RelativeMargin = 2e-9;

} // namespace

Obstacle::Obstacle(const FacetTree<3>& tree)
  : Triangles(tree)
  , Margin(RelativeMargin * Diagonal(tree.GetItems().GetMesh().Points))
{
  this->AssignVerticesAndEdges();
}

/**
 * Assigns each vertex and edge to one of its triangles. Leaves out edges that only divide a flat
 * region, and vertices that have no other edges: a face that touches these touches others as well.
 */
void Obstacle::AssignVerticesAndEdges()
{
  const ResolvedMesh& mesh = this->Triangles.GetMesh();
  const std::vector<Triangle>& triangles = mesh.Facets;
  this->Vertices.assign(triangles.size(), 0);
  this->Edges.assign(triangles.size(), 0);
  std::vector<char> isLeftOut(mesh.Points.size(), 1); // or has been assigned
  using Edge = std::array<int, 2>;                    // the greater end; 3 * triangle + corner
  Buckets<Edge> edges(mesh.Points.size(),
    [&](auto&& visit)
    {
      for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          const auto [lower, upper] = std::minmax({ triangles[t][k], triangles[t][(k + 1) % 3] });
          visit(lower, Edge{ upper, 3 * t + k });
        }
      }
    });
  for (int lower = 0; lower < edges.GetNumberOfBuckets(); ++lower)
  {
    const auto bucket = edges[lower];
    std::sort(bucket.begin(), bucket.end());
    for (auto first = bucket.begin(), end = first; first != bucket.end(); first = end)
    {
      const auto [upper, corner] = *first;
      end = std::find_if(
        first, bucket.end(), [upper = upper](const Edge& edge) { return edge[0] != upper; });
      if (end - first != 2 || !this->IsFlat(corner, first[1][1]))
      {
        this->Edges[corner / 3] |= static_cast<unsigned char>(1 << corner % 3);
        isLeftOut[lower] = isLeftOut[upper] = 0;
      }
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      char& leftOut = isLeftOut[triangles[t][k]];
      this->Vertices[t] |= static_cast<unsigned char>(!leftOut << k);
      leftOut = 1;
    }
  }
}

/**
 * Whether one triangle continues another in one plane, up to the distance that contacts leave. Each
 * has a common edge from corner `3 * triangle + k` on.
 */
bool Obstacle::IsFlat(int corner, int otherCorner) const
{
  const ResolvedMesh& mesh = this->Triangles.GetMesh();
  const auto opposite = [&mesh](int of) { return mesh.Points[mesh.Facets[of / 3][(of + 2) % 3]]; };
  const Point& a = mesh.Points[mesh.Facets[corner / 3][corner % 3]];
  const Point& b = mesh.Points[mesh.Facets[corner / 3][(corner + 1) % 3]];
  const Point normal = Cross(b - a, opposite(corner) - a);
  const Point beyond = opposite(otherCorner) - a;
  return Dot(Cross(normal, b - a), beyond) < 0.0 &&
    std::abs(Dot(normal, beyond)) <= this->Margin * Length(normal);
}

std::optional<FirstContact> Obstacle::FindContact(
  const Star& star, const Point& from, const Point& to)
{
  this->MoveTo(star, { from, to });
  ContactSearch search(star.Link, from, to, this->Margin);
  this->Triangles.Any([path = search.GetPath()](const Box& box) { return box.Overlaps(path); },
    [&](const Box&, const std::array<Point, 3>& corners)
    {
      search.AddTriangle(corners[0], corners[1], corners[2]);
      return false; // all of them
    });
  for (std::size_t face = 0; face < search.GetNumberOfFaces(); ++face)
  {
    SweptFace swept = search.Sweep(face);
    this->Triangles.ForEachSwept(
      swept, [this](int t) { return (this->Vertices[t] | this->Edges[t]) != 0; },
      [&](int t, const std::array<Point, 3>& corners)
      {
        const double time = search.GetTime();
        for (int k = 0; k < 3; ++k)
        {
          if (this->Vertices[t] >> k & 1)
          {
            search.AddVertex(face, corners[k]);
          }
          if (this->Edges[t] >> k & 1)
          {
            search.AddEdge(face, corners[k], corners[(k + 1) % 3]);
          }
        }
        if (search.GetTime() < time)
        {
          swept = search.Sweep(face); // the rest of the motion no longer matters
        }
      });
  }
  return search.Get();
}

/**
 * A point of M leaves the solid only if some removed tetrahedron contains the point in its
 * interior, in its face on the surface, or in a face between two removed tetrahedra. M is the
 * closure of its triangles' interiors, so a triangle that neither pierces a tetrahedron nor
 * overlaps a face of one in an area loses no point. Where the solid is a sheet without thickness,
 * the same holds within its plane for the triangles between w and the ends of the sheet.
 */
bool Obstacle::StaysEnclosed(const Star& star, const Point& w)
{
  const LostParts lost(star, w);
  this->MoveTo(star, { w });
  return !this->Triangles.Any([&lost](const Box& box) { return lost.MayMeet(box); },
    [&lost](const Box& bounds, const std::array<Point, 3>& corners)
    { return lost.Meet(corners, bounds); });
}

/** Prepares for searches about a star and further points. */
void Obstacle::MoveTo(const Star& star, std::initializer_list<Point> points)
{
  Box region = BoxAround(points);
  for (const auto& corners : star.Corners)
  {
    region.Add(BoxAround(corners));
  }
  this->Triangles.MoveTo(region);
}

} // namespace carving::helper
