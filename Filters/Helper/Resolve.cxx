// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Resolve.h"

#include "Clean.h"
#include "Intersections.h"
#include "Kernels.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Projection_traits_3.h>

#include <map>
#include <unordered_map>

using namespace carving;

namespace
{

using Traits = CGAL::Projection_traits_3<Exact>;
using Triangulation =
  CGAL::Constrained_Delaunay_triangulation_2<Traits, CGAL::Default, CGAL::Exact_intersections_tag>;

/** What a triangle has in common with others; isolated points are segments of length zero. */
using Cuts = std::vector<Exact::Segment_3>;

Exact::Triangle_3 ExactTriangle(const ResolvedMesh& mesh, int triangle)
{
  const Triangle& t = mesh.Facets[triangle];
  return { ToExact(mesh.Points[t[0]]), ToExact(mesh.Points[t[1]]), ToExact(mesh.Points[t[2]]) };
}

/** Visits the intersection of two triangles as segments. */
struct CutCollector
{
  using result_type = void;
  Cuts& Out;

  void operator()(const Exact::Point_3& point) const
  {
    this->Out.emplace_back(point, point);
  }
  void operator()(const Exact::Segment_3& segment) const
  {
    this->Out.push_back(segment);
  }
  void operator()(const Exact::Triangle_3& t) const
  {
    (*this)(std::vector<Exact::Point_3>{ t[0], t[1], t[2] });
  }
  void operator()(const std::vector<Exact::Point_3>& polygon) const
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      this->Out.emplace_back(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
  }
};

/** The double next to each coordinate: equal points give equal results, however they were made. */
Point Round(const Exact::Point_3& p)
{
  return { CGAL::to_double(CGAL::exact(p.x())), CGAL::to_double(CGAL::exact(p.y())),
    CGAL::to_double(CGAL::exact(p.z())) };
}

/** Appends the triangle, cut into the faces of its constrained triangulation, to `result`. */
void AppendPieces(const ResolvedMesh& mesh, int triangle, const Cuts& cuts, ResolvedMesh& result)
{
  const Exact::Triangle_3 whole = ExactTriangle(mesh, triangle);
  Triangulation triangulation{ Traits(whole.supporting_plane().orthogonal_vector()) };
  std::unordered_map<Triangulation::Vertex_handle, int> indices;
  Triangulation::Vertex_handle corners[3];
  for (int i = 0; i < 3; ++i)
  {
    corners[i] = triangulation.insert(whole[i]);
    indices[corners[i]] = mesh.Facets[triangle][i];
  }
  for (int i = 0; i < 3; ++i)
  {
    triangulation.insert_constraint(corners[i], corners[(i + 1) % 3]);
  }
  for (const Exact::Segment_3& cut : cuts)
  {
    if (cut.is_degenerate())
    {
      triangulation.insert(cut.source());
    }
    else
    {
      triangulation.insert_constraint(cut.source(), cut.target());
    }
  }
  for (const auto face : triangulation.finite_face_handles())
  {
    Triangle piece;
    for (int i = 0; i < 3; ++i)
    {
      const auto [found, isNew] =
        indices.try_emplace(face->vertex(i), static_cast<int>(result.Points.size()));
      if (isNew)
      {
        result.Points.push_back(Round(face->vertex(i)->point()));
        result.PointSources.push_back(-1);
      }
      piece[i] = found->second;
    }
    AppendFacet<3>(mesh, triangle, piece, result);
  }
}

} // namespace

std::string Resolve(
  ResolvedMesh& mesh, int& intersectingPairs, const Progress& progress, double maximumPairs)
{
  // Nearly every mesh is clean after one round; the limit ends those that rounding keeps dirty.
  constexpr int maximumRounds = 10;
  std::vector<std::pair<int, int>> pairs = FindIntersections(mesh.Points, mesh.Facets);
  intersectingPairs = static_cast<int>(pairs.size());
  if (static_cast<double>(pairs.size()) > maximumPairs)
  {
    return std::to_string(pairs.size()) +
      " pairs of triangles cross each other: resolving them would multiply the mesh.";
  }
  for (int round = 0; !pairs.empty(); ++round)
  {
    if (round == maximumRounds)
    {
      return "After " + std::to_string(maximumRounds) + " rounds of splitting, " +
        std::to_string(pairs.size()) +
        " pairs of triangles still cross each other: the mesh is too intricate for double "
        "precision.";
    }
    std::map<int, Cuts> cuts;
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      GoOn(progress, static_cast<double>(i) / pairs.size());
      const auto& [a, b] = pairs[i];
      Cuts common;
      if (const auto met = CGAL::intersection(ExactTriangle(mesh, a), ExactTriangle(mesh, b)))
      {
        boost::apply_visitor(CutCollector{ common }, *met);
      }
      for (const int triangle : { a, b })
      {
        Cuts& all = cuts[triangle];
        all.insert(all.end(), common.begin(), common.end());
      }
    }
    ResolvedMesh next;
    next.Points = mesh.Points;
    next.PointSources = mesh.PointSources;
    for (int i = 0; i < static_cast<int>(mesh.Facets.size()); ++i)
    {
      const auto found = cuts.find(i);
      if (found == cuts.end())
      {
        AppendFacet<3>(mesh, i, mesh.Facets[i], next);
      }
      else
      {
        AppendPieces(mesh, i, found->second, next);
      }
    }
    mesh = Clean(next);
    pairs = FindIntersections(mesh.Points, mesh.Facets);
  }
  return {};
}
