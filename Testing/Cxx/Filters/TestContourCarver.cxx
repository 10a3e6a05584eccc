// SPDX-License-Identifier: BSD-3-Clause
#include "ContourTesting.h"
#include "Convert/ArrayTools.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkLine.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkTriangle.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using EdgeSet = std::multiset<std::pair<carving::Point, carving::Point>>;

/** A level for every step. */
void AskForAllSteps(vtkContourCarver* carver, vtkPolyData* input)
{
  Carve(carver, input);
  carver->SetLevelTargetType(vtkContourCarver::STEP);
  for (int step = 0; step <= GetFieldValue(LastLevel(carver), "Step"); ++step)
  {
    carver->AddLevelTarget(step);
  }
  carver->Update();
}

/** A star with a hole, next to a square. */
vtkSmartPointer<vtkPolyData> Medley()
{
  return MakePolygons({ Star(), Reversed(Rectangle(-0.2, -0.2, 0.2, 0.2)), Rectangle(3, 1, 4, 2) });
}

double DistanceToEdges(vtkPolyData* contours, const double p[3])
{
  double nearest = HUGE_VAL; // squared
  for (const auto& [a, b] : Edges(contours))
  {
    double t, closest[3];
    nearest = std::min(nearest, vtkLine::DistanceToLine(p, a.data(), b.data(), t, closest));
  }
  return std::sqrt(nearest);
}

} // namespace

// LevelSimplification, which is for meshes, changes nothing.
TEST(ContourCarver, DoesNotSimplify)
{
  const auto carver = Carve<vtkContourCarver>(Medley());
  vtkNew<vtkContourCarver> other;
  other->SetLevelSimplification(vtkContourCarver::ENCLOSING_COLLAPSE);
  Carve(other, Medley());
  ASSERT_EQ(CountLevels(other), CountLevels(carver));
  for (int i = 0; i < CountLevels(carver); ++i)
  {
    EXPECT_EQ(Edges(GetLevel(other, i)), Edges(GetLevel(carver, i)));
  }
}

// A note tells the number of points in which lines cross, however many lines do so in one point.
TEST(ContourCarver, CountsCrossings)
{
  const auto carver = Carve<vtkContourCarver>(Polylines({ { { -1, 0, 0 }, { 1, 0, 0 } },
    { { 0, -1, 0 }, { 0, 1, 0 } }, { { -1, -1, 0 }, { 1, 1, 0 } } }));
  EXPECT_TRUE(Has(GetNotes(carver), "Edges cross or touch others in 1 points"));
}

// The first level of a U is its hull, the last the U itself.
TEST(ContourCarver, GoesFromTheHullToTheInput)
{
  auto input = MakePolygons({ LetterU() });
  const auto carver = Carve<vtkContourCarver>(input);
  // The upper side of the hull passes through the four upper corners of the arms.
  const EdgeSet hull = Edges(MakePolygons(
    { { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 2, 0 }, { 2, 2, 0 }, { 1, 2, 0 }, { 0, 2, 0 } } }));
  EXPECT_EQ(Edges(GetLevel(carver, 0)), hull);
  EXPECT_EQ(Edges(LastLevel(carver)), Edges(input));
}

// Whatever the direction of a polygon, its inside is solid and on the left of the edges.
TEST(ContourCarver, OrientsLevelsOutward)
{
  const auto carver = Carve<vtkContourCarver>(MakePolygons({ Reversed(LetterU()) }));
  EXPECT_EQ(Edges(LastLevel(carver)), Edges(MakePolygons({ LetterU() })));
}

// The hole of a square is carved, and stays filled without CarveVoids.
TEST(ContourCarver, CarvesHoles)
{
  auto input = MakePolygons({ Rectangle(0, 0, 4, 4), Reversed(Rectangle(1, 1, 2, 2)) });
  const auto carver = Carve<vtkContourCarver>(input);
  EXPECT_EQ(Edges(GetLevel(carver, 0)), Edges(MakePolygons({ Rectangle(0, 0, 4, 4) })));
  EXPECT_EQ(Edges(LastLevel(carver)), Edges(input));
  carver->CarveVoidsOff();
  carver->Update();
  EXPECT_EQ(Edges(LastLevel(carver)), Edges(MakePolygons({ Rectangle(0, 0, 4, 4) })));
}

// With a budget of one component, two squares stay joined; without tunnels, the hole of a frame
// stays filled.
TEST(ContourCarver, KeepsToBudgets)
{
  auto input = MakePolygons({ Rectangle(0, 0, 1, 1), Rectangle(3, 0, 4, 1) });
  const auto carver = Carve<vtkContourCarver>(input);
  EXPECT_EQ(Edges(LastLevel(carver)), Edges(input));
  carver->SetMaximumComponents(1);
  carver->Update();
  EXPECT_GT(Area(LastLevel(carver)), 2.0);
  auto frame = MakePolygons({ Rectangle(0, 0, 4, 4), Reversed(Rectangle(1, 1, 2, 2)) });
  carver->SetMaximumTunnels(0);
  Carve(carver, frame);
  EXPECT_EQ(Edges(LastLevel(carver)), Edges(MakePolygons({ Rectangle(0, 0, 4, 4) })));
}

// A square within a square of the same direction is solid by winding, a hole by parity, and carved
// as a surface.
TEST(ContourCarver, FollowsTheSolidRule)
{
  const auto carver =
    Carve<vtkContourCarver>(MakePolygons({ Rectangle(0, 0, 4, 4), Rectangle(1, 1, 2, 2) }));
  EXPECT_EQ(Area(LastLevel(carver)), 16.0);
  carver->SetSolidRule(vtkContourCarver::EVEN_ODD);
  carver->Update();
  EXPECT_EQ(Area(LastLevel(carver)), 15.0);
  carver->SetSolidRule(vtkContourCarver::SURFACE_ONLY);
  carver->KeepBothFoldSidesOn();
  carver->Update();
  EXPECT_EQ(Area(LastLevel(carver)), 0.0);
  EXPECT_EQ(LastLevel(carver)->GetNumberOfLines(), 2 * 8);
}

// Two crossing polylines are split at a new vertex with interpolated data.
TEST(ContourCarver, ResolvesCrossings)
{
  auto input = Polylines({ { { 0, 0, 0 }, { 2, 2, 0 } }, { { 0, 2, 0 }, { 2, 0, 0 } } });
  AddFieldArray<vtkDoubleArray>(input->GetPointData(), "Height", std::vector<double>{ 1, 3, 2, 2 });
  vtkNew<vtkContourCarver> carver;
  carver->ManifoldOutputOff();
  Carve(carver, input);
  EXPECT_EQ(Edges(GetLevel(carver, 0)), Edges(MakePolygons({ Rectangle(0, 0, 2, 2) })));
  vtkPolyData* last = LastLevel(carver);
  EXPECT_EQ(Edges(last),
    Edges(Polylines(
      { { { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } }, { { 0, 2, 0 }, { 1, 1, 0 }, { 2, 0, 0 } } })));
  EXPECT_EQ(GetFieldValue(last, "NewVertices"), 1);
  EXPECT_EQ(last->GetNumberOfPoints(), 5);
  for (vtkIdType i = 0; i < 5; ++i)
  {
    if (last->GetPointData()->GetArray("vtkOriginalPointIds")->GetTuple1(i) < 0)
    {
      EXPECT_EQ(last->GetPointData()->GetArray("Height")->GetTuple1(i), 2.0);
    }
  }
  std::multiset<double> cells;
  for (vtkIdType i = 0; i < 4; ++i)
  {
    cells.insert(last->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(i));
  }
  EXPECT_EQ(cells, (std::multiset<double>{ 0, 0, 1, 1 }));
}

// The area falls from step to step, from that of the hull to that of the input, and no vertex of
// the input is outside.
TEST(ContourCarver, ShrinksToTheInput)
{
  vtkNew<vtkContourCarver> carver;
  auto input = Medley();
  AskForAllSteps(carver, input);
  double before = Area(GetLevel(carver, 0));
  const int levels = CountLevels(carver);
  ASSERT_GT(levels, 20);
  for (int i = 1; i < levels; ++i)
  {
    const double area = Area(GetLevel(carver, i));
    EXPECT_LT(area, before);
    before = area;
  }
  EXPECT_NEAR(before, Area(input), 1e-12);
  EXPECT_EQ(Edges(LastLevel(carver)), Edges(input));
}

// Every level has the numbers of vertices and edges of its row of the profile.
TEST(ContourCarver, AgreesWithItsProfile)
{
  vtkNew<vtkContourCarver> carver;
  carver->ManifoldOutputOff();
  AskForAllSteps(carver, Medley());
  const int levels = CountLevels(carver);
  ASSERT_EQ(GetProfile(carver)->GetNumberOfRows(), levels);
  for (int i = 0; i < levels; ++i)
  {
    vtkPolyData* level = GetLevel(carver, i);
    EXPECT_EQ(GetProfileValue(carver, i, "Vertices"), level->GetNumberOfPoints());
    EXPECT_EQ(GetProfileValue(carver, i, "Triangles"), level->GetNumberOfLines());
  }
}

// With manifold output, one edge begins and one edge ends at every point of every level.
TEST(ContourCarver, CutsIntoClosedLoops)
{
  vtkNew<vtkContourCarver> carver;
  AskForAllSteps(carver, Medley());
  for (int i = 0; i < CountLevels(carver); ++i)
  {
    for (const auto& degrees : Degrees(GetLevel(carver, i)))
    {
      ASSERT_EQ(degrees, std::pair(1, 1)) << "step " << i;
    }
  }
}

// With manifold output, two squares that share a corner are cut apart, each with a copy of the
// corner.
TEST(ContourCarver, CutsTouchingSquaresApart)
{
  const auto carver =
    Carve<vtkContourCarver>(MakePolygons({ Rectangle(0, 0, 1, 1), Rectangle(1, 1, 2, 2) }));
  EXPECT_EQ(LastLevel(carver)->GetNumberOfPoints(), 8);
  EXPECT_EQ(GetFieldValue(LastLevel(carver), "Vertices"), 7);
  EXPECT_EQ(GetFieldValue(LastLevel(carver), "SurfaceComponents"), 2);
  for (const auto& degrees : Degrees(LastLevel(carver)))
  {
    EXPECT_EQ(degrees, std::pair(1, 1));
  }
  carver->ManifoldOutputOff();
  carver->Update();
  EXPECT_EQ(LastLevel(carver)->GetNumberOfPoints(), 7);
}

// vtkExtractCarvedLOD gives every level from the stream, bit for bit.
TEST(ContourCarver, StreamsToTheExtractor)
{
  const auto carver = Carve<vtkContourCarver>(Medley());
  EXPECT_EQ(CountLevels(carver), 8);
  ExpectSameLevelsFromStream(carver);
}

// A priority is the measure of the triangle, divided by a power of the distance of its centroid
// from the first level.
TEST(ContourCarver, TakesMeasuresAndDepth)
{
  for (const int measure :
    { vtkContourCarver::LONGEST_EDGE, vtkContourCarver::VOLUME, vtkContourCarver::CIRCUMRADIUS,
      vtkContourCarver::EDGE_VOLUME, vtkContourCarver::EDGE_DISTANCE })
  {
    vtkNew<vtkContourCarver> carver;
    carver->SetPriorityMeasure(measure);
    carver->SetDepthExponent(2.0);
    carver->SetDepthMeasure(vtkContourCarver::DISTANCE);
    auto input = Medley();
    Carve(carver, input);
    vtkUnstructuredGrid* stream = GetStream(carver);
    int carved = 0;
    for (vtkIdType cell = 0; cell < stream->GetNumberOfCells(); ++cell)
    {
      vtkCellData* data = stream->GetCellData();
      if (stream->GetCellType(cell) != VTK_TRIANGLE || data->GetArray("Step")->GetTuple1(cell) < 1)
      {
        continue;
      }
      ++carved;
      auto* triangle = vtkTriangle::SafeDownCast(stream->GetCell(cell));
      double p[3][3], center[2];
      for (int i = 0; i < 3; ++i)
      {
        triangle->GetPoints()->GetPoint(i, p[i]);
      }
      const double longest = std::sqrt(std::max(
        { vtkMath::Distance2BetweenPoints(p[0], p[1]), vtkMath::Distance2BetweenPoints(p[1], p[2]),
          vtkMath::Distance2BetweenPoints(p[2], p[0]) }));
      const double area = triangle->ComputeArea();
      // At most the diagonal of the input.
      const double radius = std::min(
        std::sqrt(vtkTriangle::Circumcircle(p[0], p[1], p[2], center)), input->GetLength());
      double centroid[3];
      vtkTriangle::TriangleCenter(p[0], p[1], p[2], centroid);
      const double distance = DistanceToEdges(LastLevel(carver), centroid);
      const double measures[] = { longest, area, radius, std::sqrt(longest * std::sqrt(area)),
        std::cbrt(longest * distance * distance) };
      const double depth = DistanceToEdges(GetLevel(carver, 0), centroid);
      EXPECT_NEAR(data->GetArray("Depth")->GetTuple1(cell), depth, 1e-12);
      const double expected = measures[measure] / (depth * depth);
      EXPECT_NEAR(data->GetArray("Priority")->GetTuple1(cell), expected, 1e-9 * expected);
    }
    EXPECT_GT(carved, 20);
  }
}

// With a breadth radius, a stream has fewer steps and still ends at the input.
TEST(ContourCarver, TakesFewerStepsWithBreadth)
{
  vtkNew<vtkContourCarver> carver;
  auto input = Medley();
  double steps = 0;
  for (const double radius : { 1.0, 0.3, 0.0 })
  {
    carver->SetBreadthRadius(radius);
    Carve(carver, input);
    EXPECT_GT(GetFieldValue(LastLevel(carver), "Step"), steps);
    steps = GetFieldValue(LastLevel(carver), "Step");
    EXPECT_EQ(Edges(LastLevel(carver)), Edges(input));
  }
}
