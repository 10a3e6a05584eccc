// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * vtkEnclosingDecimation as a filter. What its surfaces have to obey is tested with the helper.
 */
#include "Core/Mesh/Vector.h"
#include "FilterTesting.h"
#include "Shapes.h"

#include "vtkDoubleArray.h"
#include "vtkEnclosingDecimation.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace
{

/** A sphere of 642 points whose point data are their own coordinates. */
vtkSmartPointer<vtkPolyData> Sphere()
{
  vtkSmartPointer<vtkPolyData> sphere = ToPolyData(models::Sphere(3));
  vtkNew<vtkDoubleArray> places;
  places->SetName("Place");
  places->SetNumberOfComponents(3);
  places->DeepCopy(sphere->GetPoints()->GetData());
  places->SetName("Place");
  sphere->GetPointData()->AddArray(places);
  return sphere;
}

double GetValue(vtkPolyData* surface, const char* name)
{
  return surface->GetFieldData()->GetArray(name)->GetTuple1(0);
}

} // namespace

// Port 1 has a surface per target, coarsest first; port 0 has the coarsest.
TEST(EnclosingDecimation, GivesASurfacePerTarget)
{
  vtkNew<vtkEnclosingDecimation> filter;
  filter->SetInputData(Sphere());
  filter->SetTarget(300);
  filter->AddTarget(50);
  filter->AddTarget(100);
  filter->Update();
  auto* all = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(all->GetNumberOfBlocks(), 3u);
  for (int i = 0; i < 3; ++i)
  {
    auto* surface = vtkPolyData::SafeDownCast(all->GetBlock(i));
    EXPECT_EQ(surface->GetNumberOfPoints(), i == 0 ? 50 : i == 1 ? 100 : 300);
    EXPECT_EQ(surface->GetNumberOfPolys(), 2 * surface->GetNumberOfPoints() - 4); // a sphere
    EXPECT_EQ(GetValue(surface, "Vertices"), surface->GetNumberOfPoints());
    EXPECT_EQ(GetValue(surface, "Triangles"), surface->GetNumberOfPolys());
  }
  ExpectEqualData(filter->GetOutput(), all->GetBlock(0));
}

// Vertices of the input keep their data and name their point; new ones get the data of the closest.
TEST(EnclosingDecimation, PassesPointDataOn)
{
  const vtkSmartPointer<vtkPolyData> sphere = Sphere();
  vtkNew<vtkEnclosingDecimation> filter;
  filter->SetInputData(sphere);
  filter->SetTarget(600);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* places = output->GetPointData()->GetArray("Place");
  vtkDataArray* ids = output->GetPointData()->GetArray("vtkOriginalPointIds");
  ASSERT_TRUE(places && ids);
  int newVertices = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double point[3], place[3];
    output->GetPoint(i, point);
    places->GetTuple(i, place);
    const auto id = static_cast<vtkIdType>(ids->GetTuple1(i));
    newVertices += id < 0;
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(place[k], point[k], id < 0 ? GetValue(output, "Error") : 0.0);
      EXPECT_TRUE(id < 0 || sphere->GetPoint(id)[k] == point[k]);
    }
  }
  EXPECT_EQ(GetValue(output, "NewVertices"), newVertices);
  EXPECT_GT(newVertices, 0);
}

// An error bound is kept.
TEST(EnclosingDecimation, KeepsAnErrorBound)
{
  vtkNew<vtkEnclosingDecimation> filter;
  const auto sphere = Sphere();
  filter->SetInputData(sphere);
  filter->SetTargetType(vtkEnclosingDecimation::ERROR_BOUND);
  filter->SetTarget(0.05);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_LE(GetValue(output, "Error"), 0.05);
  EXPECT_LT(output->GetNumberOfPoints(), 300);
  vtkNew<vtkImplicitPolyDataDistance> distance;
  distance->SetInput(sphere);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_LE(distance->EvaluateFunction(output->GetPoint(i)), 0.05); // positive outside
  }
}

// Arrays without a value for each point are left out, and those with names of the filter's arrays
// are renamed, with notes.
TEST(EnclosingDecimation, PassesOnArraysAsTheCarverDoes)
{
  const auto sphere = Sphere();
  vtkNew<vtkStringArray> words;
  words->SetName("Short");
  words->InsertNextValue("one");
  sphere->GetPointData()->AddArray(words);
  vtkNew<vtkIntArray> ids;
  ids->SetName("vtkOriginalPointIds");
  ids->SetNumberOfTuples(sphere->GetNumberOfPoints());
  ids->Fill(7);
  sphere->GetPointData()->AddArray(ids);
  vtkNew<vtkEnclosingDecimation> filter;
  filter->SetInputData(sphere);
  filter->SetTarget(100);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_FALSE(output->GetPointData()->HasArray("Short"));
  EXPECT_EQ(output->GetPointData()->GetArray("InputvtkOriginalPointIds")->GetRange()[1], 7.0);
  auto* notes = vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("Notes"));
  ASSERT_TRUE(notes);
  EXPECT_EQ(notes->GetNumberOfValues(), 2);
}

// Points that no polygon uses, with any coordinates, change nothing.
TEST(EnclosingDecimation, IgnoresUnusedPoints)
{
  const carving::TriangleMesh sphere = models::Sphere(3);
  carving::TriangleMesh more = sphere;
  more.Points.resize(40000, { 1e6, NAN, 0.0 });
  vtkNew<vtkEnclosingDecimation> filter, other;
  filter->SetInputData(ToPolyData(sphere));
  other->SetInputData(ToPolyData(more));
  filter->SetTarget(100);
  other->SetTarget(100);
  filter->Update();
  other->Update();
  EXPECT_EQ(GetValue(other->GetOutput(), "Error"), GetValue(filter->GetOutput(), "Error"));
}

// A target out of reach gives the coarsest surface and a warning.
TEST(EnclosingDecimation, WarnsWhereItSticks)
{
  vtkNew<vtkEnclosingDecimation> filter;
  const Messages messages(filter);
  filter->SetInputData(ToPolyData(models::Torus(1.0, 0.3, 16, 8)));
  filter->SetTarget(3);
  filter->Update();
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_NE(messages.Warnings[0].find("is out of reach"), std::string::npos);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 6);
}

// Surfaces with a number of vertices are closer to the input than those of a single run.
TEST(EnclosingDecimation, BringsSurfacesCloserThanOneRun)
{
  const carving::TriangleMesh torus = models::Torus(1.0, 0.3, 48, 24);
  for (const bool nested : { false, true })
  {
    vtkNew<vtkEnclosingDecimation> filter;
    filter->SetInputData(ToPolyData(torus));
    filter->SetTarget(150);
    filter->SetNested(nested);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 150);
    EXPECT_LT(
      GetValue(filter->GetOutput(), "Error"), 0.9 * ErrorsOfOneRun(torus, { 150 }, nested)[0]);
  }
}

// Where one number is out of reach, others are brought closer, unless surfaces have to be nested.
TEST(EnclosingDecimation, BringsSurfacesCloserUnlessTheyWouldNotBeNested)
{
  const carving::TriangleMesh torus = models::Torus(1.0, 0.3, 48, 24);
  for (const bool nested : { false, true })
  {
    vtkNew<vtkEnclosingDecimation> filter;
    const Messages messages(filter);
    filter->SetInputData(ToPolyData(torus));
    filter->SetTarget(3);
    filter->AddTarget(150);
    filter->SetNested(nested);
    filter->Update();
    ASSERT_EQ(messages.Warnings.size(), 1u);
    EXPECT_NE(messages.Warnings[0].find("target of 3 is out of reach"), std::string::npos);
    auto* all = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1));
    ASSERT_EQ(all->GetNumberOfBlocks(), 2u);
    const std::vector<double> errors = ErrorsOfOneRun(torus, { 150, 3 }, nested);
    EXPECT_EQ(GetValue(vtkPolyData::SafeDownCast(all->GetBlock(0)), "Error"), errors[1]);
    const double error = GetValue(vtkPolyData::SafeDownCast(all->GetBlock(1)), "Error");
    EXPECT_TRUE(nested ? error == errors[0] : error < 0.9 * errors[0]) << error;
  }
}

// An abort gives empty outputs without an error, and the next update works.
TEST(EnclosingDecimation, CanBeAborted)
{
  vtkNew<vtkEnclosingDecimation> filter;
  Messages messages(filter);
  filter->SetInputData(ToPolyData(models::Torus(1.0, 0.3, 150, 75)));
  filter->SetTarget(100);
  {
    const Aborter aborter(filter);
    filter->Update();
  }
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetTarget(9000);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 9000);
  EXPECT_TRUE(messages.Errors.empty());
}

// An input that is not a closed surface without crossings is an error, after which the filter
// works.
TEST(EnclosingDecimation, RefusesWhatIsNoClosedSurface)
{
  carving::TriangleMesh twisted = models::Tetrahedron(), flat = models::Tetrahedron();
  std::swap(twisted.Triangles[0][0], twisted.Triangles[0][1]);
  flat.Points[2] = carving::Between(flat.Points[0], flat.Points[1], 0.5);
  flat.Triangles = { { 0, 1, 2 } };
  const carving::TriangleMesh crossing =
    models::Joined(models::Box({ 0, 0, 0 }, { 2, 2, 2 }), models::Box({ 1, 1, 1 }, { 3, 3, 3 }));
  vtkNew<vtkEnclosingDecimation> filter;
  Messages messages(filter);
  for (const auto& [mesh, error] :
    { std::pair(models::Sheet(2), "is open"), std::pair(twisted, "not an oriented manifold"),
      std::pair(crossing, "crosses itself"), std::pair(flat, "no triangle with an area") })
  {
    filter->SetInputData(ToPolyData(mesh));
    filter->Update();
    ASSERT_FALSE(messages.Errors.empty());
    EXPECT_NE(messages.Errors.back().find(error), std::string::npos) << messages.Errors.back();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
  EXPECT_EQ(messages.Errors.size(), 4u);
  filter->SetInputData(Sphere());
  filter->Update();
  EXPECT_EQ(messages.Errors.size(), 4u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 642);
}

// A block of composite input that is not polygonal is an error.
TEST(EnclosingDecimation, RefusesBlocksThatAreNotPolygonal)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkImageData>());
  vtkNew<vtkEnclosingDecimation> filter;
  Messages messages(filter);
  filter->SetInputDataObject(blocks);
  filter->Update();
  ASSERT_FALSE(messages.Errors.empty());
  EXPECT_NE(messages.Errors.front().find("without polygonal data"), std::string::npos);
}

// A second run of the helper program, which only makes surfaces tighter, may fail.
TEST(EnclosingDecimation, KeepsTheFirstRunIfTheSecondFails)
{
  const std::string mark = testing::TempDir() + "decimation-has-run";
  std::remove(mark.c_str());
  const auto failing = OtherHelper::Preceded("test ! -e " + mark + " || exit 1\ntouch " + mark);
  vtkNew<vtkEnclosingDecimation> filter;
  Messages messages(filter);
  filter->SetInputData(Sphere());
  filter->SetTarget(100.0);
  filter->Update();
  EXPECT_EQ(std::remove(mark.c_str()), 0);
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 100);
}

// An empty input gives empty outputs.
TEST(EnclosingDecimation, AcceptsEmptyInput)
{
  vtkNew<vtkEnclosingDecimation> filter;
  Messages messages(filter);
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(
    vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfBlocks(), 0u);
}

// Targets that are negative or no numbers are refused, and leave the others as they are.
TEST(EnclosingDecimation, RefusesBadTargets)
{
  vtkNew<vtkEnclosingDecimation> filter;
  Messages messages(filter);
  std::size_t errors = 0;
  for (const double target : { std::numeric_limits<double>::quiet_NaN(), -1.0 })
  {
    filter->AddTarget(target);
    filter->SetTarget(target);
    EXPECT_EQ(messages.Errors.size(), errors += 2);
  }
  ASSERT_EQ(filter->GetNumberOfTargets(), 1);
  EXPECT_EQ(filter->GetTarget(0), 1000.0);
}
