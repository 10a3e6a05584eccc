// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "RandomModels.h"
#include "Shapes.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

/** Two triangles that cross each other, above a third. */
vtkSmartPointer<vtkPolyData> Crossing()
{
  carving::TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, -1 }, { 1, 1, 3 }, { 3, 3, 1 },
    { -2, -2, -3 }, { 6, -2, -3 }, { -2, 6, -3 } };
  mesh.Triangles = { { 0, 1, 2 }, { 3, 4, 5 }, { 6, 7, 8 } };
  vtkSmartPointer<vtkPolyData> data = ToPolyData(mesh);
  vtkNew<vtkIntArray> colors;
  colors->SetName("Color");
  for (const int color : { 7, 8, 9 })
  {
    colors->InsertNextValue(color);
  }
  data->GetCellData()->AddArray(colors);
  return data;
}

std::string GetText(vtkDataObject* data, const char* name)
{
  return vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name))->GetValue(0);
}

} // namespace

// The field data of streams and levels name the strategy as the documentation does.
TEST(Conformity, IsSaidInTheFieldData)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(Crossing());
  carver->Update();
  const auto expectRung = [&](const char* expected)
  {
    EXPECT_EQ(GetText(carver->GetOutputDataObject(1), "Strategy"), expected);
    for (unsigned int i = 0; i < carver->GetOutput()->GetNumberOfBlocks(); ++i)
    {
      EXPECT_EQ(GetText(GetLevel(carver, static_cast<int>(i)), "Strategy"), expected);
    }
  };
  expectRung("TetGen -pcY");
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->Update();
  expectRung("Delaunay, enclosing");
}

// In enclosing mode without tolerance, no vertex is new, and a stored stream gives the same levels.
TEST(Conformity, EnclosingKeepsVerticesAndStreams)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(Crossing());
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->SetEnclosingTolerance(0.0);
  carver->SetSolidRule(vtkTopologyCarver::SURFACE_ONLY);
  carver->Update();
  vtkNew<vtkExtractCarvedLOD> extract;
  extract->SetInputDataObject(0, carver->GetOutputDataObject(1));
  extract->SetLevelTargetType(vtkExtractCarvedLOD::STEP);
  const int count = static_cast<int>(carver->GetOutput()->GetNumberOfBlocks());
  ASSERT_GT(count, 1);
  for (int i = 0; i < count; ++i)
  {
    vtkPolyData* level = GetLevel(carver, i);
    EXPECT_EQ(level->GetFieldData()->GetArray("NewVertices")->GetTuple1(0), 0);
    extract->SetLevelTarget(GetLevelStep(carver, i));
    extract->Update();
    ExpectEqualData(extract->GetOutput(), level);
  }
}

// Vertices that snapping moved keep their ids, are new, and have the distance; on levels of the
// stored stream, too.
TEST(Conformity, SnappedVerticesAreSaidToBeNew)
{
  std::mt19937_64 random(1);
  auto input = ToPolyData(models::Doubled(models::Sphere(1), 1e-13, random));
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(input);
  carver->SetConformity(vtkTopologyCarver::EXACT);
  {
    Messages messages(carver);
    carver->Update();
    EXPECT_EQ(
      messages.Errors.size(), 1u); // a change of these properties runs the helper program again
  }
  carver->SetSnapTolerance(1e-6);
  carver->Update();
  const int last = static_cast<int>(carver->GetOutput()->GetNumberOfBlocks()) - 1;
  ASSERT_GE(last, 0);
  vtkPolyData* level = GetLevel(carver, last);
  EXPECT_EQ(GetText(level, "Strategy").find("TetGen -pcY, snapped"), 0u);
  const double farthest = level->GetFieldData()->GetArray("SnapDistance")->GetTuple1(0);
  EXPECT_GT(farthest, 0.0);
  EXPECT_NE(GetNotes(carver).find("An attempt failed."), std::string::npos);
  EXPECT_NE(GetNotes(carver).find("The mesh was snapped"), std::string::npos);
  int moved = 0;
  for (vtkIdType i = 0; i < level->GetNumberOfPoints(); ++i)
  {
    const auto id =
      static_cast<vtkIdType>(level->GetPointData()->GetArray("vtkOriginalPointIds")->GetTuple1(i));
    ASSERT_GE(id, 0);
    double from[3], to[3];
    input->GetPoint(id, from);
    level->GetPoint(i, to);
    const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(from, to));
    EXPECT_EQ(level->GetPointData()->GetArray("SnapDistance")->GetTuple1(i), distance);
    EXPECT_LE(distance, farthest);
    moved += distance > 0.0;
  }
  EXPECT_GT(moved, 0);
  EXPECT_LT(moved, level->GetNumberOfPoints()); // points at 0 and 1 are on every grid
  EXPECT_EQ(level->GetFieldData()->GetArray("NewVertices")->GetTuple1(0), moved);
  vtkNew<vtkExtractCarvedLOD> extract;
  extract->SetInputDataObject(0, carver->GetOutputDataObject(1));
  extract->SetLevelTargetType(vtkExtractCarvedLOD::STEP);
  extract->SetLevelTarget(GetLevelStep(carver, last));
  extract->Update();
  ExpectEqualData(extract->GetOutput(), level);
}

// If all attempts fail, a note describes each of them, including snapping.
TEST(Conformity, NotesEveryAttempt)
{
  std::mt19937_64 random(1);
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ToPolyData(models::Doubled(models::Sphere(1), 1e-13, random)));
  carver->SetSnapTolerance(1e-30); // smaller than the spacing of doubles near 1
  carver->Update();
  EXPECT_EQ(GetText(GetLevel(carver, 0), "Strategy"), "Delaunay, enclosing");
  const std::string notes = GetNotes(carver);
  EXPECT_NE(notes.find("An attempt failed. Snapping: on a grid of"), std::string::npos) << notes;
}

// With AppendInput, a mesh that is only enclosed follows as given, with its data.
TEST(Conformity, AppendsTheInputOnRequest)
{
  vtkNew<vtkTopologyCarver> carver;
  auto input = Crossing();
  carver->SetInputData(input);
  carver->AppendInputOn();
  carver->Update();
  const unsigned int exact = carver->GetOutput()->GetNumberOfBlocks();
  EXPECT_EQ(GetText(GetLevel(carver, static_cast<int>(exact) - 1), "Kind"), "carved");
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->Update();
  const int last = static_cast<int>(carver->GetOutput()->GetNumberOfBlocks()) - 1;
  vtkPolyData* level = GetLevel(carver, last);
  EXPECT_EQ(GetText(level, "Kind"), "input");
  EXPECT_EQ(GetText(GetLevel(carver, last - 1), "Kind"), "carved");
  EXPECT_EQ(GetTriangles(level), GetTriangles(input));
  EXPECT_NE(GetNotes(carver).find("The mesh is only enclosed"), std::string::npos);
  for (vtkIdType i = 0; i < level->GetNumberOfCells(); ++i)
  {
    const double cell = level->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(i);
    EXPECT_EQ(level->GetCellData()->GetArray("Color")->GetTuple1(i), 7 + cell);
    EXPECT_TRUE(std::isnan(level->GetCellData()->GetArray("Priority")->GetTuple1(i)));
  }
}

// A change of the solid rule runs the helper program again only if triangles inside the solid may
// have been left out.
TEST(Conformity, RunsAgainForAnotherSolidOnlyWhereThatMatters)
{
  std::mt19937_64 random(2);
  for (const bool matters : { false, true })
  {
    vtkNew<vtkTopologyCarver> carver;
    carver->SetInputData(matters ? ToPolyData(models::Assembly(12, random)) : TwoBoxes());
    carver->Update();
    ASSERT_GT(carver->GetOutput()->GetNumberOfBlocks(), 0u);
    EXPECT_EQ(GetText(GetLevel(carver, 0), "Strategy"),
      matters ? "TetGen -pcY, without interior" : "TetGen -pcY");
    EXPECT_EQ(GetNotes(carver).find("inside the solid") != std::string::npos, matters);
    const OtherHelper broken("/bin/false");
    carver->SetSolidRule(vtkTopologyCarver::SURFACE_ONLY);
    Messages messages(carver);
    carver->Update();
    EXPECT_EQ(messages.Errors.size(), matters ? 1u : 0u);
  }
}

// A change of Conformity runs the helper program again; a change of the levels or of AppendInput
// does not.
TEST(Conformity, IsCachedLikeTheOtherSettings)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(TwoBoxes());
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->Update();
  const OtherHelper broken("/bin/false");
  carver->SetNumberOfLevels(3);
  carver->AppendInputOn();
  Messages messages(carver);
  carver->Update();
  EXPECT_TRUE(messages.Errors.empty());
  carver->SetConformity(vtkTopologyCarver::EXACT);
  carver->Update();
  EXPECT_EQ(messages.Errors.size(), 1u);
}
