// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/Carver.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

using namespace carving;

// Without the exposed cascade each step carves one tetrahedron, the one with the longest edge
// first.
TEST(Carver, CarvesTheLongestEdgeFirst)
{
  const Stream stream = small::Carved(small::Row(6), small::OneByOne());
  EXPECT_EQ(stream.Step, (std::vector<int>{ 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(stream.LastStep(), 6);
  EXPECT_TRUE(std::isnan(stream.StepPriority[0]));
  EXPECT_TRUE(std::is_sorted(
    stream.StepPriority.begin() + 1, stream.StepPriority.end(), std::greater<double>()));
}

// The priority of a tetrahedron is the length of its longest edge.
TEST(Carver, TakesTheLengthOfTheLongestEdgeForPriority)
{
  const Stream stream = small::Carved(small::Assemble(
    { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 }, { 0, 0, 1 } }, { { 0, 1, 2, 3 } }, {}));
  EXPECT_EQ(stream.Priority[0], 5.0);
  EXPECT_EQ(stream.StepPriority[1], 5.0);
}

// Of equal priorities the tetrahedron with the smaller index comes first.
TEST(Carver, BreaksTiesByIndex)
{
  // Two regular tetrahedra of the same size, apart from each other.
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 },
    { 4, 0, 0 }, { 5, 1, 0 }, { 5, 0, 1 }, { 4, 1, 1 } };
  EXPECT_EQ(small::Carved(small::Assemble(points, { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } }, {})).Step,
    (std::vector<int>{ 1, 2 }));
  EXPECT_EQ(small::Carved(small::Assemble(points, { { 4, 5, 6, 7 }, { 0, 1, 2, 3 } }, {})).Step,
    (std::vector<int>{ 1, 2 }));
}

// Exposed tetrahedra go along in the step that exposed them, and those that they expose in turn.
TEST(Carver, TakesExposedTetrahedraAlong)
{
  const Stream stream = small::Carved(small::Row(6));
  EXPECT_EQ(stream.LastStep(), 1);
  EXPECT_EQ(stream.Step, std::vector<int>(6, 1));
}

// Tetrahedra on the hull have depth 1; every other is one deeper than a neighbor carved before it.
TEST(Carver, CountsDepthFromTheHull)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(small::InnerFaces());
  const Stream stream = small::Carved(mesh, small::OneByOne());
  for (int cell = 0; cell < 12; ++cell)
  {
    // Of each prism's three cells the first has a face on the hull, and the others lie behind it.
    ASSERT_EQ(stream.Depth[cell] == 1, cell % 3 == 0);
    if (stream.Depth[cell] > 1)
    {
      EXPECT_TRUE(std::any_of(mesh.Neighbors[cell].begin(), mesh.Neighbors[cell].end(),
        [&](int n)
        {
          return n >= 0 && stream.Depth[n] == stream.Depth[cell] - 1 &&
            stream.Step[n] < stream.Step[cell];
        }));
    }
  }
}

// The solid stays: it has no step, no priority and no depth.
TEST(Carver, LeavesTheSolid)
{
  const Stream stream = small::Carved(small::NestedTetrahedra(small::InnerFaces()));
  EXPECT_EQ(stream.Step[12], Stream::Never);
  EXPECT_TRUE(std::isnan(stream.Priority[12]));
  EXPECT_EQ(stream.Depth[12], 0);
  EXPECT_EQ(std::count(stream.Step.begin(), stream.Step.end(), Stream::Never), 1);
}

// Carving does not pass through the triangles of M.
TEST(Carver, StopsAtConstrainingFaces)
{
  const Stream stream = small::Carved(small::HollowTetrahedron());
  for (int cell = 0; cell < 12; ++cell)
  {
    EXPECT_EQ(stream.Step[cell], Stream::Never);
  }
}

// A void, which no path joins to the outside, is opened all the same; its depth begins at 1.
TEST(Carver, OpensVoids)
{
  const Stream stream = small::Carved(small::HollowTetrahedron());
  EXPECT_EQ(stream.Step[12], 1);
  EXPECT_EQ(stream.Depth[12], 1);
}

// Where there is no complement there is no step.
TEST(Carver, HasNothingToDoForASolidThatFillsItsHull)
{
  EXPECT_EQ(small::Carved(small::NestedTetrahedra(small::OuterFaces())).LastStep(), 0);
}

// Carving stops when the caller wants it to, at the start or on the way.
TEST(Carver, StopsOnRequest)
{
  const Tetrahedralization mesh = small::EvenRow(20000);
  CarveOptions options = small::OneByOne();
  for (const int wanted : { 1, 3 })
  {
    int reports = 0;
    Stream stream;
    EXPECT_FALSE(
      Carve(mesh, Classify(mesh), options, stream, [&](double) { return ++reports < wanted; }));
    EXPECT_EQ(reports, wanted);
  }
}

// Progress begins at 0, grows from report to report, and ends at 1.
TEST(Carver, ReportsProgress)
{
  const Tetrahedralization mesh = small::EvenRow(20000);
  std::vector<double> reports;
  Stream stream;
  CarveOptions options = small::OneByOne();
  Carve(mesh, Classify(mesh), options, stream,
    [&](double fraction)
    {
      reports.push_back(fraction);
      return true;
    });
  ASSERT_GE(reports.size(), 5u);
  EXPECT_EQ(reports.front(), 0.0);
  EXPECT_EQ(
    std::adjacent_find(reports.begin(), reports.end(), std::greater_equal<>()), reports.end());
  EXPECT_EQ(reports.back(), 1.0);
}

// The volume measure carves the largest tetrahedron first, the longest edge or not.
TEST(Carver, CarvesByVolume)
{
  // A needle with a long edge, and a bulky tetrahedron apart from it.
  const std::vector<Point> points = { { 0, 0, 0 }, { 9, 0, 0 }, { 0, 0.1, 0 }, { 0, 0, 0.1 },
    { 20, 0, 0 }, { 23, 0, 0 }, { 20, 3, 0 }, { 20, 0, 3 } };
  const Tetrahedralization mesh = small::Assemble(points, { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } }, {});
  CarveOptions options;
  EXPECT_EQ(small::Carved(mesh, options).Step, (std::vector<int>{ 1, 2 }));
  options.Measure = PriorityMeasure::Volume;
  const Stream stream = small::Carved(mesh, options);
  EXPECT_EQ(stream.Step, (std::vector<int>{ 2, 1 }));
  EXPECT_NEAR(stream.StepPriority[1], 27.0 / 6.0, 1e-12);
}

// Equation (2): a tetrahedron of depth 2 counts half with dp = 1, and a quarter with dp = 2.
TEST(Carver, DividesPriorityByAPowerOfDepth)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(small::InnerFaces());
  CarveOptions options = small::OneByOne();
  const std::vector<double> priorities = ComputePriorities(mesh, PriorityMeasure::LongestEdge);
  for (const auto& [exponent, share] : { std::pair(0.0, 1.0), { 1.0, 0.5 }, { 2.0, 0.25 } })
  {
    options.DepthExponent = exponent;
    const Stream stream = small::Carved(mesh, options);
    EXPECT_EQ(std::count(stream.Depth.begin(), stream.Depth.end(), 1.0), 4);
    EXPECT_GT(std::count(stream.Depth.begin(), stream.Depth.end(), 2.0), 0);
    for (int cell = 0; cell < 12; ++cell)
    {
      if (stream.Depth[cell] <= 2.0)
      {
        EXPECT_DOUBLE_EQ(
          stream.Priority[cell], (stream.Depth[cell] == 1.0 ? 1.0 : share) * priorities[cell]);
      }
    }
  }
}

// Depths that are given replace those of the hierarchy.
TEST(Carver, TakesGivenDepths)
{
  const Tetrahedralization mesh = small::Row(3);
  CarveOptions options = small::OneByOne();
  options.DepthExponent = 1.0;
  options.Depths = { 100.0, 10.0, 1.0 };
  const Stream stream = small::Carved(mesh, options);
  EXPECT_EQ(stream.Step, (std::vector<int>{ 3, 2, 1 }));
  EXPECT_EQ(stream.Depth, options.Depths);
}

// Priorities are finite numbers whatever equation (2) is given: a volume that rounds to 0 by an
// infinite power of a tiny depth, or a power beyond what a double holds.
TEST(Carver, KeepsPrioritiesFinite)
{
  // The first has a volume of 0, the second one that is none.
  const std::vector<Point> points = { { 0, 0, 0 }, { 1e-200, 0, 0 }, { 0, 1e-200, 0 },
    { 0, 0, 1e-200 }, { 1, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 }, { 1, 0, 1 } };
  const Tetrahedralization mesh = small::Assemble(points, { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } }, {});
  CarveOptions options;
  options.Measure = PriorityMeasure::Volume;
  options.Depths = { 1e-10, 1e-10 };
  options.DepthExponent = 1e300;
  const Stream stream = small::Carved(mesh, options);
  EXPECT_EQ(stream.Priority[0], 0.0);
  EXPECT_TRUE(std::isfinite(stream.Priority[1]));
  EXPECT_EQ(stream.Step, (std::vector<int>{ 2, 1 }));
}

// A step takes along what lies within the breadth radius on either side, and nothing that lies
// farther.
TEST(Carver, CarvesWithinTheBreadthRadius)
{
  const Tetrahedralization mesh = small::EvenRow(12); // centroids are 1 apart
  CarveOptions options = small::OneByOne();
  options.DepthExponent = 1.0;
  options.Depths.assign(12, 2.0);
  options.Depths[5] = 1.0; // the first, then by index
  options.BreadthRadius = 2.0;
  EXPECT_EQ(
    small::Carved(mesh, options).Step, (std::vector<int>{ 2, 2, 2, 1, 1, 1, 1, 1, 3, 3, 3, 4 }));
  options.BreadthRadius = 1.99;
  EXPECT_EQ(
    small::Carved(mesh, options).Step, (std::vector<int>{ 2, 2, 3, 3, 1, 1, 1, 4, 4, 5, 5, 6 }));
}

// A radius larger than the mesh carves in one step all that can be reached, but not through M.
TEST(Carver, DoesNotWalkThroughConstrainingFaces)
{
  // The face between the cells 5 and 6.
  const Tetrahedralization mesh = small::EvenRow(12, { { 6, 7, 8 } });
  CarveOptions options;
  options.BreadthRadius = 100.0;
  for (const bool exposed : { false, true })
  {
    options.CarveExposed = exposed;
    const Stream stream = small::Carved(mesh, options);
    EXPECT_EQ(stream.Step, (std::vector<int>{ 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2 }));
  }
}

// Voids can be left closed.
TEST(Carver, LeavesVoidsIfWanted)
{
  const Tetrahedralization mesh = small::HollowTetrahedron();
  CarveOptions options;
  options.CarveVoids = false;
  const Stream stream = small::Carved(mesh, options);
  EXPECT_EQ(stream.LastStep(), 0);
  EXPECT_EQ(stream.Step[12], Stream::Never);
}
