// SPDX-License-Identifier: BSD-3-Clause
#include "Carver.h"
#include "SmallMeshes.h"
#include "Vector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace carving;

namespace
{

Stream CarveAll(const Tetrahedralization& mesh, bool exposed)
{
  Stream stream;
  CarveOptions options;
  options.CarveExposed = exposed;
  EXPECT_TRUE(Carve(mesh, Classify(mesh), options, stream));
  return stream;
}

} // namespace

// Without the exposed cascade each step carves one tetrahedron, the one with the longest edge first.
TEST(Carver, CarvesTheLongestEdgeFirst)
{
  const Stream stream = CarveAll(small::Row(6), false);
  EXPECT_EQ(stream.Step, (std::vector<int>{ 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(stream.LastStep(), 6);
  EXPECT_TRUE(std::isnan(stream.StepPriority[0]));
  EXPECT_TRUE(std::is_sorted(
    stream.StepPriority.begin() + 1, stream.StepPriority.end(), std::greater<double>()));
}

// The priority of a tetrahedron is the length of its longest edge.
TEST(Carver, TakesTheLengthOfTheLongestEdgeForPriority)
{
  const Stream stream = CarveAll(
    small::Assemble({ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 }, { 0, 0, 1 } }, { { 0, 1, 2, 3 } }, {}),
    true);
  EXPECT_EQ(stream.Priority[0], 5.0);
  EXPECT_EQ(stream.StepPriority[1], 5.0);
}

// Of equal priorities the tetrahedron with the smaller index comes first.
TEST(Carver, BreaksTiesByIndex)
{
  // Two regular tetrahedra of the same size, apart from each other.
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 },
    { 4, 0, 0 }, { 5, 1, 0 }, { 5, 0, 1 }, { 4, 1, 1 } };
  EXPECT_EQ(CarveAll(small::Assemble(points, { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } }, {}), true).Step,
    (std::vector<int>{ 1, 2 }));
  EXPECT_EQ(CarveAll(small::Assemble(points, { { 4, 5, 6, 7 }, { 0, 1, 2, 3 } }, {}), true).Step,
    (std::vector<int>{ 1, 2 }));
}

// Exposed tetrahedra go along in the step that exposed them, and those that they expose in turn.
TEST(Carver, TakesExposedTetrahedraAlong)
{
  const Stream stream = CarveAll(small::Row(6), true);
  EXPECT_EQ(stream.LastStep(), 1);
  EXPECT_EQ(stream.Step, std::vector<int>(6, 1));
}

// Tetrahedra on the hull have depth 1; every other is one deeper than a neighbor carved before it.
TEST(Carver, CountsDepthFromTheHull)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(small::InnerFaces());
  const Stream stream = CarveAll(mesh, false);
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
  const Stream stream = CarveAll(small::NestedTetrahedra(small::InnerFaces()), true);
  EXPECT_EQ(stream.Step[12], Stream::Never);
  EXPECT_TRUE(std::isnan(stream.Priority[12]));
  EXPECT_EQ(stream.Depth[12], 0);
  EXPECT_EQ(std::count(stream.Step.begin(), stream.Step.end(), Stream::Never), 1);
}

// Carving does not pass through the triangles of M.
TEST(Carver, StopsAtConstrainingFaces)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(
    small::Joined(small::OuterFaces(), small::Flipped(small::InnerFaces())));
  const Stream stream = CarveAll(mesh, true);
  for (int cell = 0; cell < 12; ++cell)
  {
    EXPECT_EQ(stream.Step[cell], Stream::Never);
  }
}

// A void, which no path joins to the outside, is opened all the same; its depth begins at 1.
TEST(Carver, OpensVoids)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(
    small::Joined(small::OuterFaces(), small::Flipped(small::InnerFaces())));
  const Stream stream = CarveAll(mesh, true);
  EXPECT_EQ(stream.Step[12], 1);
  EXPECT_EQ(stream.Depth[12], 1);
}

// Where there is no complement there is no step.
TEST(Carver, HasNothingToDoForASolidThatFillsItsHull)
{
  EXPECT_EQ(CarveAll(small::NestedTetrahedra(small::OuterFaces()), true).LastStep(), 0);
}

// Carving stops when the caller wants it to.
TEST(Carver, StopsOnRequest)
{
  const Tetrahedralization mesh = small::Row(6);
  Stream stream;
  EXPECT_FALSE(Carve(mesh, Classify(mesh), {}, stream, [](double) { return false; }));
}

// Progress never falls, and ends at 1.
TEST(Carver, ReportsProgress)
{
  const Tetrahedralization mesh = small::Row(20);
  std::vector<double> reports;
  Stream stream;
  CarveOptions options;
  options.CarveExposed = false;
  Carve(mesh, Classify(mesh), options, stream,
    [&](double fraction)
    {
      reports.push_back(fraction);
      return true;
    });
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
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
  Stream stream;
  Carve(mesh, Classify(mesh), options, stream);
  EXPECT_EQ(stream.Step, (std::vector<int>{ 1, 2 }));
  options.Measure = PriorityMeasure::Volume;
  Carve(mesh, Classify(mesh), options, stream);
  EXPECT_EQ(stream.Step, (std::vector<int>{ 2, 1 }));
  EXPECT_NEAR(stream.StepPriority[1], 27.0 / 6.0, 1e-12);
}

// Equation (2): with dp = 1 a tetrahedron of depth 2 counts half.
TEST(Carver, DividesPriorityByAPowerOfDepth)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(small::InnerFaces());
  CarveOptions options;
  options.CarveExposed = false;
  Stream plain, deep;
  Carve(mesh, Classify(mesh), options, plain);
  options.DepthExponent = 2.0;
  Carve(mesh, Classify(mesh), options, deep);
  const std::vector<double> priorities = ComputePriorities(mesh, PriorityMeasure::LongestEdge);
  for (int cell = 0; cell < 12; ++cell)
  {
    EXPECT_EQ(plain.Priority[cell], priorities[cell]);
    EXPECT_NEAR(
      deep.Priority[cell], priorities[cell] / (deep.Depth[cell] * deep.Depth[cell]), 1e-12);
  }
}

// Depths that are given replace those of the hierarchy.
TEST(Carver, TakesGivenDepths)
{
  const Tetrahedralization mesh = small::Row(3);
  CarveOptions options;
  options.CarveExposed = false;
  options.DepthExponent = 1.0;
  options.Depths = { 100.0, 10.0, 1.0 };
  Stream stream;
  Carve(mesh, Classify(mesh), options, stream);
  EXPECT_EQ(stream.Step, (std::vector<int>{ 3, 2, 1 }));
  EXPECT_EQ(stream.Depth, options.Depths);
}

// Priorities are finite numbers whatever equation (2) is given: a volume that rounds to 0 by an infinite
// power of a tiny depth, or a power beyond what a double holds.
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
  Stream stream;
  Carve(mesh, Classify(mesh), options, stream);
  EXPECT_EQ(stream.Priority[0], 0.0);
  EXPECT_TRUE(std::isfinite(stream.Priority[1]));
  EXPECT_EQ(stream.Step, (std::vector<int>{ 2, 1 }));
}

// A step takes along what lies within the breadth radius, and nothing that lies farther.
TEST(Carver, CarvesWithinTheBreadthRadius)
{
  const Tetrahedralization mesh = small::Row(12);
  CarveOptions options;
  options.CarveExposed = false;
  options.BreadthRadius = 1.0;
  Stream stream;
  Carve(mesh, Classify(mesh), options, stream);
  // In a row the walk ends at the first tetrahedron that is too far away.
  int step = 1, first = 0;
  for (int cell = 0; cell < 12; ++cell)
  {
    if (Length(mesh.Centroid(cell) - mesh.Centroid(first)) > options.BreadthRadius)
    {
      ++step;
      first = cell;
    }
    EXPECT_EQ(stream.Step[cell], step);
  }
  EXPECT_GT(step, 1);
  EXPECT_LT(step, 12);
}

// A radius larger than the mesh carves all that can be reached in one step, but not through M.
TEST(Carver, DoesNotWalkThroughConstrainingFaces)
{
  const Tetrahedralization mesh =
    small::NestedTetrahedra(small::Joined(small::InnerFaces(), { { 0, 1, 4 }, { 1, 5, 4 } }));
  CarveOptions options;
  options.BreadthRadius = 100.0;
  Stream stream;
  Carve(mesh, Classify(mesh), options, stream);
  EXPECT_EQ(stream.LastStep(), 1);
  EXPECT_EQ(stream.Step[12], Stream::Never);
}

// Voids can be left closed.
TEST(Carver, LeavesVoidsIfWanted)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(
    small::Joined(small::OuterFaces(), small::Flipped(small::InnerFaces())));
  CarveOptions options;
  options.CarveVoids = false;
  Stream stream;
  Carve(mesh, Classify(mesh), options, stream);
  EXPECT_EQ(stream.LastStep(), 0);
  EXPECT_EQ(stream.Step[12], Stream::Never);
}
