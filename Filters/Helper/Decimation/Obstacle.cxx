// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/Obstacle.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Enclosing/Pierce.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

/** The distance that contacts leave, as a fraction of M's diagonal: well above rounding errors. */
constexpr double RelativeMargin = 2e-9;

} // namespace

Obstacle::Obstacle(const FacetTree<3>& tree)
  : Tree(tree)
  , Margin(RelativeMargin * Diagonal(tree.GetItems().GetMesh().Points))
{
  this->AssignVerticesAndEdges();
}

void Obstacle::AssignVerticesAndEdges()
{
  const ResolvedMesh& mesh = this->Tree.GetItems().GetMesh();
  const std::vector<Triangle>& triangles = mesh.Facets;
  this->Vertices.assign(triangles.size(), 0);
  this->Edges.assign(triangles.size(), 0);
  std::vector<char> isAssigned(mesh.Points.size(), 0);
  using Edge = std::array<int, 2>; // the greater end; 3 * triangle + corner
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
    int last = -1;
    for (const auto& [upper, corner] : bucket)
    {
      this->Edges[corner / 3] |= static_cast<unsigned char>((upper != last) << corner % 3);
      last = upper;
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      char& assigned = isAssigned[triangles[t][k]];
      this->Vertices[t] |= static_cast<unsigned char>(!assigned << k);
      assigned = 1;
    }
  }
}

std::optional<FirstContact> Obstacle::FindContact(
  const Fan& fan, const Point& from, const Point& to) const
{
  ContactSearch search(fan, from, to, this->Margin);
  this->Tree.ForEachOverlap(search.GetPath(),
    [&](int t)
    {
      const auto [p, q, r] = this->Tree.GetItems().CornersOf(t);
      search.AddTriangle(p, q, r);
    });
  for (std::size_t face = 0; face < search.GetNumberOfFaces(); ++face)
  {
    SweptFace swept = search.Sweep(face);
    this->Tree.ForEachFromTop(
      swept.GetStartNormal(), [&swept](const Box& box) { return swept.MayMeet(box); },
      [&](int t)
      {
        const double time = search.GetTime();
        const auto corners = this->Tree.GetItems().CornersOf(t);
        if (!swept.MayMeet(corners))
        {
          return;
        }
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
 * overlaps a face of one in an area loses no point.
 */
bool Obstacle::AllowsRemoval(const std::vector<std::array<Point, 3>>& faces, const Point& w) const
{
  bool allowed = true;
  for (const auto& [a, b, c] : faces)
  {
    // w is behind the face, so that this order is positive.
    const Corners4 tetrahedron = { ToInexact(a), ToInexact(c), ToInexact(b), ToInexact(w) };
    this->Tree.ForEachOverlap(BoxAround({ a, b, c, w }),
      [&](int t)
      {
        if (allowed)
        {
          const Corners3 corners = ToInexact(this->Tree.GetItems().CornersOf(t));
          allowed = !Piercer(corners).FindContact(tetrahedron).Exists();
        }
      });
  }
  return allowed;
}

} // namespace carving::helper
