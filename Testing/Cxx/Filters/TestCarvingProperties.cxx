// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

/** A hollow box: an outer box and an inner one that faces the hollow. */
vtkSmartPointer<vtkPolyData> HollowBox()
{
  return ToPolyData(models::Joined(
    models::Box({ 0, 0, 0 }, { 3, 3, 3 }), models::Flipped(models::Box({ 1, 1, 1 }, { 2, 2, 2 }))));
}

/** The number of triangles of the last level. */
vtkIdType CountTriangles(vtkTopologyCarver* carver)
{
  carver->Update();
  return LastLevel(carver)->GetNumberOfPolys();
}

} // namespace

// BOUNDING_BOX: the first level is a box a hundredth of the diagonal away, with eight new vertices;
// the last is the input.
TEST(CarvingProperties, StartFromABoundingBox)
{
  vtkNew<vtkTopologyCarver> carver;
  auto sphere = ToPolyData(models::Sphere(2));
  carver->SetInitialApproximation(vtkTopologyCarver::BOUNDING_BOX);
  carver->SetNumberOfLevels(2);
  Carve(carver, sphere);
  vtkPolyData* box = GetLevel(carver, 0);
  double input[6], grown[6];
  GetLevel(carver, 1)->GetBounds(input);
  box->GetBounds(grown);
  const double margin = 0.01 * GetLevel(carver, 1)->GetLength();
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(grown[i], input[i] + (i % 2 ? margin : -margin), 1e-12);
  }
  EXPECT_EQ(box->GetNumberOfPolys(), 12);
  EXPECT_EQ(GetFieldValue(GetLevel(carver, 0), "NewVertices"), 8);
  EXPECT_EQ(GetFieldValue(GetLevel(carver, 1), "NewVertices"), 0);
  EXPECT_EQ(GetTriangles(GetLevel(carver, 1)), GetTriangles(sphere));
}

// Of all properties of the carving itself, only the initial approximation runs the helper program
// again.
TEST(CarvingProperties, NeedTheHelperForTheInitialApproximationAlone)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  Carve(carver, TwoBoxes());
  const OtherHelper missing("/there/is/no/such/helper");
  carver->SetPriorityMeasure(vtkTopologyCarver::VOLUME);
  carver->SetDepthExponent(2.0);
  carver->SetDepthMeasure(vtkTopologyCarver::DISTANCE);
  carver->SetBreadthRadius(0.5);
  carver->SetCarveVoids(false);
  carver->SetMaximumComponents(1);
  carver->SetMaximumTunnels(0);
  carver->SetMaximumVoids(0);
  carver->SetSolidRule(vtkTopologyCarver::EVEN_ODD);
  carver->Update();
  EXPECT_TRUE(messages.Errors.empty());
  carver->SetInitialApproximation(vtkTopologyCarver::BOUNDING_BOX);
  carver->Update();
  EXPECT_EQ(messages.Errors.size(), 1u);
}

// CUSTOM without a mesh on port 1 is an error that names the port.
TEST(CarvingProperties, NeedAMeshToStartFrom)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInitialApproximation(vtkTopologyCarver::CUSTOM);
  EXPECT_TRUE(Has(CarveWithError(carver, TwoBoxes()), "input port 1"));
}

// Depth by distance is the distance of the centroid from the hull, here from the sides of a box.
TEST(CarvingProperties, MeasureDepthAsDistance)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetDepthMeasure(vtkTopologyCarver::DISTANCE);
  carver->SetDepthExponent(1.0);
  Carve(carver, TwoBoxes()); // their hull is a box of 3 x 1 x 1
  vtkUnstructuredGrid* stream = GetStream(carver);
  for (vtkIdType i = 0; i < stream->GetNumberOfCells(); ++i)
  {
    if (stream->GetCellType(i) != VTK_TETRA)
    {
      continue;
    }
    double centroid[3] = {};
    vtkNew<vtkIdList> corners;
    stream->GetCellPoints(i, corners);
    for (int corner = 0; corner < 4; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        centroid[axis] += 0.25 * stream->GetPoint(corners->GetId(corner))[axis];
      }
    }
    double distance = 3.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double upper = axis == 0 ? 3.0 : 1.0;
      distance = std::min({ distance, centroid[axis], upper - centroid[axis] });
    }
    EXPECT_NEAR(stream->GetCellData()->GetArray("Depth")->GetTuple1(i), distance, 1e-12);
  }
}

// The feature size is the smallest priority popped so far, as a length, for every measure.
TEST(CarvingProperties, GiveFeatureSizeAsALength)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("elephant.off"));
  for (const int measure :
    { vtkTopologyCarver::LONGEST_EDGE, vtkTopologyCarver::VOLUME, vtkTopologyCarver::CIRCUMRADIUS,
      vtkTopologyCarver::EDGE_VOLUME, vtkTopologyCarver::EDGE_DISTANCE })
  {
    carver->SetPriorityMeasure(measure);
    carver->Update();
    double smallest = HUGE_VAL;
    for (int step = 1; step <= GetLevelStep(carver, 3); ++step)
    {
      smallest = std::min(smallest, GetProfileValue(carver, step, "Priority"));
    }
    const double length = measure == vtkTopologyCarver::VOLUME ? std::cbrt(smallest)
      : measure == vtkTopologyCarver::CIRCUMRADIUS             ? 2.0 * smallest
                                                               : smallest;
    EXPECT_NEAR(GetFieldValue(GetLevel(carver, 3), "FeatureSize"), length, 1e-12);
  }
}

// With a breadth radius, a stream has fewer steps and still ends at the input.
TEST(CarvingProperties, TakeFewerStepsWithBreadth)
{
  vtkNew<vtkTopologyCarver> carver;
  auto input = ReadReal("elephant.off");
  carver->SetInputData(input);
  int steps = 0;
  for (const double radius : { 0.1, 0.01, 0.0 })
  {
    carver->SetBreadthRadius(radius);
    carver->Update();
    EXPECT_GT(GetLevelStep(carver, 7), steps);
    steps = GetLevelStep(carver, 7);
    EXPECT_EQ(GetTriangles(GetLevel(carver, 7)), GetTriangles(input));
  }
}

// NONZERO_WINDING and EVEN_ODD both see a hollow as a void; without CarveVoids its wall does not
// show.
TEST(CarvingProperties, CarveVoidsOrNot)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(HollowBox());
  EXPECT_EQ(CountTriangles(carver), 24);
  carver->SetSolidRule(vtkTopologyCarver::EVEN_ODD);
  EXPECT_EQ(CountTriangles(carver), 24);
  carver->SetCarveVoids(false);
  EXPECT_EQ(CountTriangles(carver), 12);
}

// A box within a box is hidden with NONZERO_WINDING, and a hollow with EVEN_ODD.
TEST(CarvingProperties, FollowTheSolidRule)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ToPolyData(
    models::Joined(models::Box({ 0, 0, 0 }, { 3, 3, 3 }), models::Box({ 1, 1, 1 }, { 2, 2, 2 }))));
  EXPECT_EQ(CountTriangles(carver), 12);
  carver->SetSolidRule(vtkTopologyCarver::EVEN_ODD);
  EXPECT_EQ(CountTriangles(carver), 24);
  // With SURFACE_ONLY, both boxes are carved from inside: only their triangles remain.
  carver->SetSolidRule(vtkTopologyCarver::SURFACE_ONLY);
  EXPECT_EQ(CountTriangles(carver), 24);
  vtkDataArray* depth = LastLevel(carver)->GetCellData()->GetArray("Depth");
  EXPECT_EQ(depth->GetRange()[1], 0.0);
  EXPECT_EQ(GetStream(carver)->GetCellData()->GetArray("Step")->GetRange()[0], 0.0);
}

// Values out of range are clamped.
TEST(CarvingProperties, AreClamped)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetDepthExponent(-1.0);
  carver->SetBreadthRadius(-1.0);
  carver->SetPriorityMeasure(17);
  carver->SetNumberOfLevels(0);
  EXPECT_EQ(carver->GetDepthExponent(), 0.0);
  EXPECT_EQ(carver->GetBreadthRadius(), 0.0);
  EXPECT_EQ(carver->GetPriorityMeasure(), vtkTopologyCarver::AUTO_MEASURE);
  EXPECT_EQ(carver->GetNumberOfLevels(), 1);
}

// A number that is not finite is refused with an error that names the property, which keeps its
// value.
TEST(CarvingProperties, RefuseNumbersThatAreNotFinite)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  const double infinity = std::numeric_limits<double>::infinity();
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  struct Case
  {
    const char* Name;
    void (vtkTopologyCarver::*Set)(double);
    double (vtkTopologyCarver::*Get)();
  };
  const Case cases[] = {
    { "DepthExponent", &vtkTopologyCarver::SetDepthExponent, &vtkTopologyCarver::GetDepthExponent },
    { "BreadthRadius", &vtkTopologyCarver::SetBreadthRadius, &vtkTopologyCarver::GetBreadthRadius },
    { "EnclosingTolerance", &vtkTopologyCarver::SetEnclosingTolerance,
      &vtkTopologyCarver::GetEnclosingTolerance },
    { "SnapTolerance", &vtkTopologyCarver::SetSnapTolerance, &vtkTopologyCarver::GetSnapTolerance },
    { "TimeLimit", &vtkTopologyCarver::SetTimeLimit, &vtkTopologyCarver::GetTimeLimit },
    { "MemoryLimit", &vtkTopologyCarver::SetMemoryLimit, &vtkTopologyCarver::GetMemoryLimit },
  };
  for (const auto& [name, set, get] : cases)
  {
    (carver->*set)(0.5);
    for (const double bad : { notANumber, infinity, -infinity })
    {
      const vtkMTimeType before = carver->GetMTime();
      (carver->*set)(bad);
      EXPECT_EQ((carver->*get)(), 0.5) << name;
      EXPECT_EQ(carver->GetMTime(), before) << name;
      EXPECT_TRUE(Has(messages.TakeError(), name));
    }
  }
  carver->AddLevelTarget(notANumber);
  carver->AddLevelTarget(-1.0);
  EXPECT_EQ(messages.Errors.size(), 2u);
  EXPECT_EQ(carver->GetNumberOfLevelTargets(), 0);
}

// The number of levels is at most 1,000, and an abort ends their extraction.
TEST(CarvingProperties, LimitTheNumberOfLevels)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("bones.off"));
  carver->SetNumberOfLevels(10'000'000);
  EXPECT_EQ(carver->GetNumberOfLevels(), 1000);
  const Aborter aborter(carver, "output", 21);
  carver->Update();
  EXPECT_EQ(aborter.GetReportsLeft(), 0);
  EXPECT_EQ(CountLevels(carver), 0);
}
