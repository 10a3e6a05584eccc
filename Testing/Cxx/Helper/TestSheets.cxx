// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Closed surfaces that are sheets without thickness somewhere.
 */
#include "Checks.h"
#include "Core/Mesh/Box.h"
#include "Helper/Decimation/ClosedSurface.h"
#include "Helper/Decimation/EnclosingDecimation.h"
#include "Helper/Decimation/Sheets.h"
#include "Helper/Resolve/Clean.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace carving;

namespace
{

/** Both sides of the graph of a function above a grid of n x n squares; they share the rim. */
TriangleMesh DoubledGraph(int n, const std::function<double(double, double)>& height)
{
  TriangleMesh mesh;
  const int upper = (n + 1) * (n + 1);
  for (int side = 0; side < 2; ++side)
  {
    for (int i = 0; i < upper; ++i)
    {
      const double x = i % (n + 1) - 0.5 * n, y = i / (n + 1) - 0.5 * n;
      mesh.Points.push_back({ x, y, height(x, y) });
    }
  }
  const auto isOnRim = [n](int i) { return i % (n + 1) % n == 0 || i / (n + 1) % n == 0; };
  const auto add = [&](int a, int b, int c)
  {
    if (isOnRim(a) && isOnRim(b) && isOnRim(c))
    {
      return; // the facet's third edge would have four facets
    }
    const auto below = [&](int i) { return isOnRim(i) ? i : upper + i; };
    mesh.Triangles.push_back({ a, b, c });
    mesh.Triangles.push_back({ below(c), below(b), below(a) });
  };
  for (int y = 0; y < n; ++y)
  {
    for (int x = 0; x < n; ++x)
    {
      const int a = y * (n + 1) + x;
      add(a, a + 1, a + n + 2);
      add(a, a + n + 2, a + n + 1);
    }
  }
  return mesh;
}

/** The number of faces that are sides of sheets. */
std::size_t CountSheets(const TriangleMesh& mesh)
{
  ResolvedMesh surface = helper::AsResolved(mesh);
  EXPECT_EQ(helper::MakeClosedSurface(surface), "");
  const std::vector<char> isSheet = helper::FindSheets(helper::AsSurfaceMesh(surface));
  return std::count(isSheet.begin(), isSheet.end(), 1);
}

int CountCrossings(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  return checks::CountCrossings(points, checks::WithPointsMerged(points, triangles));
}

} // namespace

// Both sides of a sheet are found, also with a solid beside the sheet.
TEST(Sheets, AreFoundOnBothSides)
{
  const TriangleMesh sheet = DoubledGraph(6, [](double x, double y) { return 0.1 * x * y; });
  EXPECT_EQ(CountSheets(sheet), sheet.Triangles.size());
  const TriangleMesh joined = models::Joined(sheet, models::Moved(models::Sphere(2), { 20, 0, 0 }));
  EXPECT_EQ(CountSheets(joined), sheet.Triangles.size());
}

// Where two solids touch in equal faces, or the walls of a void do, there is no sheet.
TEST(Sheets, AreNotWhereSolidsTouch)
{
  const TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  TriangleMesh mirrored = models::Flipped(box);
  for (Point& p : mirrored.Points)
  {
    p[2] = -p[2];
  }
  EXPECT_EQ(CountSheets(models::Joined(box, mirrored)), 0u);
  const TriangleMesh crack = models::Flipped(DoubledGraph(4, [](double, double) { return 0.0; }));
  const TriangleMesh around = models::Box({ -9, -9, -9 }, { 9, 9, 9 });
  EXPECT_EQ(CountSheets(models::Joined(around, crack)), 0u);
}

// A sheet gets as coarse as a solid does, encloses both sides and does not cross itself: domes,
// saddles, and flat sheets, whose sides rise a little to keep clear of each other.
TEST(Sheets, CanBeDecimated)
{
  const std::function<double(double, double)> heights[] = { [](double, double) { return 0.0; },
    [](double x, double y) { return -0.05 * (x * x + y * y); },
    [](double x, double y) { return 0.05 * (x * x - y * y); } };
  for (const auto& height : heights)
  {
    const TriangleMesh sheet = DoubledGraph(12, height);
    const int covered = CountCrossings(sheet.Points, sheet.Triangles); // by the other side
    DecimationOptions options;
    options.Targets = { 100, 30 };
    Decimation decimation;
    ASSERT_EQ(helper::DecimateEnclosing(sheet, sheet, {}, options, decimation), "");
    for (const DecimatedSurface& surface : decimation.Surfaces)
    {
      EXPECT_TRUE(surface.Reached);
      EXPECT_LT(surface.Error, 0.15 * Diagonal(sheet.Points));
      const CollapsedSurface result = ExtractSurface(decimation.Chain, surface.Collapses);
      std::vector<Point> points;
      for (const int point : result.Points)
      {
        points.push_back(decimation.Points[point]);
      }
      EXPECT_TRUE(checks::IsClosed(result.Triangles));
      EXPECT_LE(CountCrossings(points, result.Triangles), covered);
      for (const Triangle& t : sheet.Triangles)
      {
        EXPECT_TRUE(checks::Encloses(points, result.Triangles, sheet.Points[t[0]]));
      }
    }
  }
}
