// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "Helper/Base/Kernels.h"
#include "Helper/Plane/ResolveContours.h"
#include "Helper/Plane/Triangulate.h"
#include "HelperRun.h"

#include <CGAL/Segment_2.h>

#include <gtest/gtest.h>

#include <random>

using namespace carving;
using namespace carving::helper;

namespace
{

Contours ResolvedContours(const ContourSet& given, int& splitPoints)
{
  Contours contours = Clean(AsContours(given, false));
  EXPECT_EQ(Resolve(contours, splitPoints, {}), "");
  return contours;
}

Contours ResolvedContours(const ContourSet& given)
{
  int splitPoints = 0;
  return ResolvedContours(given, splitPoints);
}

Decomposition<2> Triangulated(
  const ContourSet& given, InitialApproximation initial = InitialApproximation::ConvexHull)
{
  Decomposition<2> result;
  EXPECT_EQ(Triangulate(ResolvedContours(given), initial, given, result), "");
  return result;
}

/** The four sides of a square around segments, many of which cross. */
ContourSet RandomSegments(unsigned int seed, int count)
{
  std::mt19937 random(seed);
  ContourSet set = { { { 0, 0, 0 }, { 64, 0, 0 }, { 64, 64, 0 }, { 0, 64, 0 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } } };
  for (int i = 0; i < count; ++i)
  {
    const int first = static_cast<int>(set.Points.size());
    for (int end = 0; end < 2; ++end)
    {
      // Half of the ends are on a coarse grid, for collinear overlaps and common ends.
      const double x = random() / 67108864.0, y = random() / 67108864.0;
      set.Points.push_back(
        i % 2 ? Point{ x, y, 0 } : Point{ std::floor(x / 8) * 8, std::floor(y / 8) * 8, 0 });
    }
    set.Edges.push_back({ first, first + 1 });
  }
  return set;
}

Inexact::Segment_2 SegmentOf(const Contours& contours, const std::array<int, 2>& edge)
{
  const Point &a = contours.Points[edge[0]], &b = contours.Points[edge[1]];
  return { Inexact::Point_2(a[0], a[1]), Inexact::Point_2(b[0], b[1]) };
}

/** Whether two edges have more in common than an end. */
bool Cross(const Contours& contours, const std::array<int, 2>& e, const std::array<int, 2>& f)
{
  const Inexact::Segment_2 s = SegmentOf(contours, e), t = SegmentOf(contours, f);
  int common = 0;
  for (const int end : e)
  {
    common += end == f[0] || end == f[1];
  }
  if (common == 0)
  {
    return CGAL::do_intersect(s, t);
  }
  const auto isInside = [](const Inexact::Point_2& p, const Inexact::Segment_2& segment)
  { return segment.has_on(p) && p != segment.source() && p != segment.target(); };
  return common == 2 || isInside(s.source(), t) || isInside(s.target(), t) ||
    isInside(t.source(), s) || isInside(t.target(), s);
}

int CountCrossings(const Contours& contours)
{
  int crossings = 0;
  for (std::size_t i = 0; i < contours.Facets.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      crossings += Cross(contours, contours.Facets[i], contours.Facets[j]);
    }
  }
  return crossings;
}

double Area(const Decomposition<2>& mesh)
{
  double sum = 0.0;
  for (const auto& [i, j, k] : mesh.Cells)
  {
    const Point &a = mesh.Surface.Points[i], &b = mesh.Surface.Points[j],
                &c = mesh.Surface.Points[k];
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    EXPECT_GE(twice, 0.0);
    sum += 0.5 * twice;
  }
  return sum;
}

} // namespace

// Equal points are merged, and edges without length and points without edges are dropped.
TEST(CleanContours, MergesPointsAndDropsEmptyEdges)
{
  const Contours contours =
    Clean(AsContours({ { { 5, 5, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { -0.0, 0, 0 }, { 0, 1, 0 } },
                       { { 1, 3 }, { 1, 2 }, { 3, 4 } } },
      false));
  EXPECT_EQ(contours.PointSources, (std::vector<int>{ 1, 2, 4 }));
  EXPECT_EQ(contours.Facets, (std::vector<std::array<int, 2>>{ { 0, 1 }, { 0, 2 } }));
  EXPECT_EQ(contours.FacetSources, (std::vector<int>{ 1, 2 }));
}

// The multiplicities of equal edges are added.
TEST(CleanContours, AddsMultiplicities)
{
  const Contours contours = Clean(AsContours(
    { { { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 1 }, { 1, 0 }, { 1, 0 }, { 1, 0 } } }, false));
  ASSERT_EQ(contours.Facets.size(), 1u);
  EXPECT_EQ(contours.SignedMultiplicities[0], -2);
  EXPECT_EQ(contours.Multiplicities[0], 4);
}

// A crossing becomes a new point with an interpolated third coordinate.
TEST(ResolveContours, SplitsACrossing)
{
  int splitPoints = 0;
  const Contours contours = ResolvedContours(
    { { { 0, 0, 0 }, { 4, 4, 8 }, { 0, 2, 2 }, { 2, 0, 2 } }, { { 0, 1 }, { 2, 3 } } },
    splitPoints);
  EXPECT_EQ(splitPoints, 1);
  EXPECT_EQ(contours.Facets.size(), 4u);
  EXPECT_EQ(contours.Points.back(), (Point{ 1, 1, 2 }));
  EXPECT_EQ(contours.PointSources.back(), -1);
  EXPECT_EQ(contours.FacetSources, (std::vector<int>{ 0, 0, 1, 1 }));
}

// An end on another edge splits that edge without a new point.
TEST(ResolveContours, SplitsAtAnEnd)
{
  int splitPoints = 0;
  const Contours contours = ResolvedContours(
    { { { 0, 0, 0 }, { 4, 0, 0 }, { 1, 0, 0 }, { 1, 5, 0 } }, { { 0, 1 }, { 2, 3 } } },
    splitPoints);
  EXPECT_EQ(splitPoints, 1);
  EXPECT_EQ(contours.Points.size(), 4u);
  EXPECT_EQ(contours.Facets.size(), 3u);
}

// The common part of overlapping edges becomes one edge with added multiplicities.
TEST(ResolveContours, MergesOverlaps)
{
  const Contours contours = ResolvedContours(
    { { { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0, 0 }, { 3, 0, 0 } }, { { 0, 1 }, { 3, 2 } } });
  EXPECT_EQ(contours.Multiplicities, (std::vector<int>{ 1, 2, 1 }));
  EXPECT_EQ(contours.SignedMultiplicities, (std::vector<int>{ 1, 0, 1 }));
}

// Resolving contours without crossings changes nothing.
TEST(ResolveContours, LeavesCleanContoursAlone)
{
  const ContourSet square = RandomSegments(1, 0);
  int splitPoints = -1;
  const Contours contours = ResolvedContours(square, splitPoints);
  EXPECT_EQ(splitPoints, 0);
  EXPECT_EQ(contours.Points, square.Points);
  EXPECT_EQ(contours.Facets, square.Edges);
}

// After resolving random segments, no two edges have more in common than an end.
TEST(ResolveContours, LeavesNoCrossing)
{
  for (unsigned int seed = 0; seed < 20; ++seed)
  {
    int splitPoints = 0;
    const Contours contours = ResolvedContours(RandomSegments(seed, 30), splitPoints);
    EXPECT_GT(splitPoints, 30);
    EXPECT_EQ(CountCrossings(contours), 0) << "seed " << seed;
  }
}

// Edges that overlap except for rounding, as on a rotated grid, are resolved.
TEST(ResolveContours, ResolvesNearlyCollinearEdges)
{
  for (unsigned int seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    ContourSet set;
    for (int i = 0; i < 40; ++i)
    {
      const double x = random() % 6, y = random() % 6;
      set.Points.push_back({ 100 + 0.8 * x - 0.3 * y, 100 + 0.1 * x + 0.7 * y, 0 });
      set.Edges.push_back({ i, (i + 1) % 40 });
    }
    const Contours contours = ResolvedContours(set);
    EXPECT_EQ(CountCrossings(contours), 0) << "seed " << seed;
  }
}

// The triangles fill the hull and are counter-clockwise, and every edge of M is a face of one.
TEST(Triangulate, FillsTheHull)
{
  for (unsigned int seed = 0; seed < 20; ++seed)
  {
    const Decomposition<2> mesh = Triangulated(RandomSegments(seed, 30));
    EXPECT_NEAR(Area(mesh), 64.0 * 64.0, 1e-8);
    const std::vector<int> sides = checks::CountFaces(mesh);
    EXPECT_EQ(std::count(sides.begin(), sides.end(), 0), 0);
  }
}

// Equal input gives equal bytes.
TEST(Triangulate, IsDeterministic)
{
  std::string bytes[2];
  for (std::string& result : bytes)
  {
    Reply reply;
    reply.StageSeconds.assign(NumberOfStages, 0.0);
    reply.Plane = Triangulated(RandomSegments(3, 100));
    result = ToBytes(reply);
    EXPECT_EQ(Read(result.data(), result.size(), reply), "");
  }
  EXPECT_EQ(bytes[0], bytes[1]);
}

// The corners of the bounding box lie in the plane of the input.
TEST(Triangulate, PutsTheBoxIntoThePlane)
{
  const Decomposition<2> mesh =
    Triangulated({ { { 0, 0, 0 }, { 4, 0, 2 }, { 0, 3, -3 } }, { { 0, 1 }, { 1, 2 }, { 2, 0 } } },
      InitialApproximation::BoundingBox);
  ASSERT_EQ(mesh.Surface.Points.size(), 7u);
  for (const Point& p : mesh.Surface.Points)
  {
    EXPECT_NEAR(p[2], 0.5 * p[0] - p[1], 1e-12);
  }
  EXPECT_NEAR(Area(mesh), 4.1 * 3.1, 1e-12); // the diagonal is 5
}

// Contours without an edge or without an area are refused with a message.
TEST(Triangulate, RefusesContoursWithoutArea)
{
  const ContourSet nothing = { { { 1, 1, 1 } }, { { 0, 0 } } };
  const ContourSet line = { { { 0, 0, 0 }, { 1, 1, 0 } }, { { 0, 1 } } };
  Decomposition<2> result;
  const auto initial = InitialApproximation::ConvexHull;
  EXPECT_NE(Triangulate(ResolvedContours(nothing), initial, nothing, result).find("No edge"),
    std::string::npos);
  EXPECT_NE(
    Triangulate(ResolvedContours(line), initial, line, result).find("one line"), std::string::npos);
}
