// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Depth and breadth have the effects that sections 5.3 and 5.4 describe. Snaking and spiking are
 * measured as the share of the vertices that lie deep below the initial approximation, in the level
 * with half of the vertices.
 */
#include "Contours.h"
#include "Core/Carving/Carver.h"
#include "Core/Measure/LevelSelection.h"
#include "Core/Measure/Profile.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Core/Stream/Level.h"
#include "Figures.h"
#include "HelperRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace carving;

namespace
{

/** A normal of a triangle or of an edge in the plane z = 0; not of unit length. */
Point Normal(const std::vector<Point>& p, const Triangle& t)
{
  return Cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}

Point Normal(const std::vector<Point>& p, const std::array<int, 2>& e)
{
  return Cross(p[e[1]] - p[e[0]], { 0.0, 0.0, 1.0 });
}

/** The distance of every point from the surface of the convex hull. */
template <int D>
std::vector<double> Depths(const Decomposition<D>& mesh)
{
  const std::vector<Point>& points = mesh.Surface.Points;
  std::vector<double> depths(points.size(), HUGE_VAL);
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      if (mesh.Neighbors[cell][f] >= 0)
      {
        continue;
      }
      const auto face = mesh.OutwardFace(cell, f);
      const Point normal = Normal(points, face);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        depths[i] =
          std::min(depths[i], std::abs(Dot(normal, points[i] - points[face[0]])) / Length(normal));
      }
    }
  }
  return depths;
}

/**
 * In the level with half of the vertices, the share of vertices more than half as deep as the
 * deepest point.
 */
template <int D>
double ShareOfDeepVertices(const Decomposition<D>& mesh, double depthExponent, double breadthRadius)
{
  CarveOptions options;
  options.DepthExponent = depthExponent;
  options.BreadthRadius = breadthRadius;
  const Classification regions = Classify(mesh);
  Stream order;
  Carve(mesh, regions, options, order);
  const StoredStream<D> stream = Store(mesh, regions, order);
  const Profile profile = ComputeProfile(stream);
  const double half = (profile.Vertices.front() + profile.Vertices.back()) / 2.0;
  const Level<D> level =
    ExtractLevel(stream, SelectStep(profile, LevelTarget::Vertices, half).Step);
  std::set<int> vertices;
  for (const FaceLife<D>& face : level.Faces)
  {
    vertices.insert(face.Corners.begin(), face.Corners.end());
  }
  const std::vector<double> depths = Depths(mesh);
  const double deep = *std::max_element(depths.begin(), depths.end()) / 2.0;
  return static_cast<double>(std::count_if(
           vertices.begin(), vertices.end(), [&](int vertex) { return depths[vertex] > deep; })) /
    vertices.size();
}

Decomposition<2> TriangulateContour(const models::ContourModel& contour)
{
  Job job;
  job.Kind = JobKind::Triangulate;
  job.Contours = { contour.Points, contour.Edges };
  return GetReply(job).Plane;
}

} // namespace

// Figure 9: in the plane, depth prevents carving from digging out narrow pockets first.
TEST(CarvingStyle, DepthKeepsFromSnakingInThePlane)
{
  const Decomposition<2> mesh = TriangulateContour(models::SnakingContour());
  EXPECT_LT(ShareOfDeepVertices(mesh, 2.0, 0.0), ShareOfDeepVertices(mesh, 0.0, 0.0));
}

// Figure 11: breadth and depth prevent spiking between leaves.
TEST(CarvingStyle, BreadthAndDepthKeepFromSpikingBetweenLeaves)
{
  const Decomposition<3> mesh = GetReply(models::YuccaLeaves()).Result;
  const double breadth = 0.05 * Diagonal(mesh.Surface.Points);
  const double plain = ShareOfDeepVertices(mesh, 0.0, 0.0);
  EXPECT_LT(ShareOfDeepVertices(mesh, 0.0, breadth), plain);
  EXPECT_LT(ShareOfDeepVertices(mesh, 2.0, 0.0), plain);
}
