// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

namespace
{

/** The triangles of a mesh by coordinates, rotated so that the smallest corner comes first. */
std::multiset<std::array<std::array<double, 3>, 3>> Triangles(vtkPolyData* mesh)
{
  std::multiset<std::array<std::array<double, 3>, 3>> result;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCellPoints(i, corners);
    std::array<std::array<double, 3>, 3> triangle;
    for (int k = 0; k < 3; ++k)
    {
      mesh->GetPoint(corners->GetId(k), triangle[k].data());
    }
    std::rotate(
      triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    result.insert(triangle);
  }
  return result;
}

std::string GetNotes(vtkTopologyCarver* carver)
{
  auto* notes =
    vtkStringArray::SafeDownCast(carver->GetOutput()->GetFieldData()->GetAbstractArray("Notes"));
  std::string text;
  for (vtkIdType i = 0; notes && i < notes->GetNumberOfValues(); ++i)
  {
    text += notes->GetValue(i) + "\n";
  }
  return text;
}

} // namespace

// Two boxes are carved out of their hull: the first level is the hull, the last the input itself.
TEST(TopologyCarver, GoesFromTheHullToTheInput)
{
  auto input = TwoBoxes();
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(input);
  carver->Update();
  const int levels = static_cast<int>(carver->GetOutput()->GetNumberOfBlocks());
  ASSERT_GE(levels, 2);
  EXPECT_EQ(GetLevelStep(carver, 0), 0);
  // The hull's ends are sides of the boxes, and each of the four sides between needs two triangles
  // for the gap next to the four of the boxes.
  EXPECT_EQ(GetLevel(carver, 0)->GetNumberOfPolys(), 4 + 4 * (4 + 2));
  EXPECT_EQ(Triangles(GetLevel(carver, levels - 1)), Triangles(input));
}

// The input's orientation does not matter for solids: an inside-out mesh gives outward levels.
TEST(TopologyCarver, OrientsLevelsOutward)
{
  auto input = ToPolyData(models::Flipped(
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 2, 0, 0 }, { 3, 1, 1 }))));
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(input);
  carver->SetNumberOfLevels(1);
  carver->Update();
  EXPECT_EQ(Triangles(GetLevel(carver, 0)), Triangles(TwoBoxes()));
}

// Levels are named and ordered from coarse to fine; their points are doubles.
TEST(TopologyCarver, NamesAndOrdersLevels)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("elephant.off"));
  carver->SetNumberOfLevels(5);
  carver->Update();
  vtkMultiBlockDataSet* levels = carver->GetOutput();
  ASSERT_EQ(levels->GetNumberOfBlocks(), 5u);
  for (unsigned int i = 0; i < 5; ++i)
  {
    EXPECT_EQ(levels->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()), "LOD " + std::to_string(i));
    EXPECT_EQ(GetLevel(carver, static_cast<int>(i))->GetPoints()->GetDataType(), VTK_DOUBLE);
    if (i > 0)
    {
      EXPECT_GT(GetLevel(carver, static_cast<int>(i))->GetNumberOfPoints(),
        GetLevel(carver, static_cast<int>(i) - 1)->GetNumberOfPoints());
    }
  }
}

// A target gives the last level that has no more vertices or triangles than wanted, coarsest first.
TEST(TopologyCarver, MeetsLevelTargets)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("elephant.off"));
  for (const int type : { vtkTopologyCarver::VERTICES, vtkTopologyCarver::TRIANGLES })
  {
    carver->SetLevelTargetType(type);
    carver->ClearLevelTargets();
    carver->AddLevelTarget(2000);
    carver->AddLevelTarget(1000);
    carver->Update();
    ASSERT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 2u);
    auto* profile = vtkTable::SafeDownCast(carver->GetOutputDataObject(2));
    for (int i = 0; i < 2; ++i)
    {
      const double target = 1000 * (i + 1);
      vtkPolyData* level = GetLevel(carver, i);
      EXPECT_LE(type == vtkTopologyCarver::VERTICES ? level->GetNumberOfPoints()
                                                    : level->GetNumberOfPolys(),
        target);
      // The next step would be too large.
      EXPECT_GT(profile
                  ->GetValueByName(GetLevelStep(carver, i) + 1,
                    type == vtkTopologyCarver::VERTICES ? "Vertices" : "Triangles")
                  .ToDouble(),
        target);
    }
  }
}

// A target that even the hull exceeds gives the hull, and a warning with both numbers.
TEST(TopologyCarver, WarnsOfATargetBelowTheHull)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInputData(ReadReal("elephant.off"));
  carver->AddLevelTarget(10);
  carver->Update();
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_NE(messages.Warnings[0].find("10 vertices"), std::string::npos);
  EXPECT_EQ(GetLevelStep(carver, 0), 0);
}

// The stream holds the complement's tetrahedra and M's triangles, and any level can be counted from
// their steps.
TEST(TopologyCarver, WritesTheStream)
{
  auto input = ReadReal("elephant.off");
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(input);
  carver->Update();
  auto* stream = vtkUnstructuredGrid::SafeDownCast(carver->GetOutputDataObject(1));
  ASSERT_NE(stream, nullptr);
  vtkDataArray* steps = stream->GetCellData()->GetArray("Step");
  vtkDataArray* priorities = stream->GetCellData()->GetArray("Priority");
  vtkDataArray* depths = stream->GetCellData()->GetArray("Depth");
  vtkDataArray* regions = stream->GetCellData()->GetArray("Region");
  vtkIdType tetrahedra = 0, triangles = 0, onHull = 0;
  for (vtkIdType i = 0; i < stream->GetNumberOfCells(); ++i)
  {
    if (stream->GetCellType(i) == VTK_TETRA)
    {
      ++tetrahedra;
      EXPECT_GE(steps->GetTuple1(i), 1);
      EXPECT_GT(priorities->GetTuple1(i), 0.0);
      EXPECT_GE(depths->GetTuple1(i), 1);
      EXPECT_GE(regions->GetTuple1(i), 0);
    }
    else
    {
      ASSERT_EQ(stream->GetCellType(i), VTK_TRIANGLE);
      ++triangles;
      onHull += steps->GetTuple1(i) == 0;
      EXPECT_TRUE(std::isnan(priorities->GetTuple1(i)));
      EXPECT_EQ(regions->GetTuple1(i), -1);
    }
  }
  EXPECT_GT(tetrahedra, 0);
  EXPECT_EQ(triangles, input->GetNumberOfPolys());
  vtkDataArray* original = GetLevel(carver, 0)->GetCellData()->GetArray("vtkOriginalCellIds");
  vtkIdType inputFacesOnHull = 0;
  for (vtkIdType i = 0; i < original->GetNumberOfTuples(); ++i)
  {
    inputFacesOnHull += original->GetTuple1(i) >= 0;
  }
  EXPECT_EQ(onHull, inputFacesOnHull);
}

// The profile has a row per step, whose counts are those of the levels.
TEST(TopologyCarver, WritesTheProfile)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("elephant.off"));
  carver->Update();
  auto* profile = vtkTable::SafeDownCast(carver->GetOutputDataObject(2));
  ASSERT_NE(profile, nullptr);
  for (int i = 0; i < 8; ++i)
  {
    const int step = GetLevelStep(carver, i);
    EXPECT_EQ(profile->GetValueByName(step, "Step").ToInt(), step);
    EXPECT_EQ(
      profile->GetValueByName(step, "Vertices").ToInt(), GetLevel(carver, i)->GetNumberOfPoints());
    EXPECT_EQ(
      profile->GetValueByName(step, "Triangles").ToInt(), GetLevel(carver, i)->GetNumberOfPolys());
  }
  EXPECT_EQ(profile->GetNumberOfRows(), GetLevelStep(carver, 7) + 1);
  EXPECT_TRUE(std::isnan(profile->GetValueByName(0, "Priority").ToDouble()));
}

// Changing a carving or level property, or nothing, does not run the helper program again.
TEST(TopologyCarver, KeepsTheTetrahedraBetweenUpdates)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInputData(TwoBoxes());
  carver->Update();
  const OtherHelper missing("/there/is/no/such/helper");
  carver->SetNumberOfLevels(2);
  carver->Update();
  EXPECT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 2u);
  carver->SetCarveExposed(false);
  carver->Update();
  carver->AddLevelTarget(16);
  carver->Update();
  EXPECT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 1u);
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_EQ(carver->GetStageSeconds(0), 0.0);
}

// A changed input does run it again.
TEST(TopologyCarver, TetrahedralizesAChangedInput)
{
  auto input = TwoBoxes();
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInputData(input);
  carver->Update();
  input->GetPoints()->SetPoint(0, -1, 0, 0);
  input->GetPoints()->Modified();
  carver->Update();
  EXPECT_EQ(GetLevel(carver, 0)->GetBounds()[0], -1.0);
}

// Carving exposed tetrahedra along saves triangles at the same number of vertices.
TEST(TopologyCarver, SavesTrianglesWithExposedTetrahedra)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("elephant.off"));
  carver->AddLevelTarget(1000);
  vtkIdType triangles[2];
  for (const bool exposed : { false, true })
  {
    carver->SetCarveExposed(exposed);
    carver->Update();
    EXPECT_EQ(GetLevel(carver, 0)->GetFieldData()->GetArray("Vertices")->GetTuple1(0), 1000);
    triangles[exposed] = GetLevel(carver, 0)->GetNumberOfPolys();
  }
  EXPECT_LT(triangles[true], triangles[false]);
}

// A convex mesh has nothing to carve: one level, no error, and a note that says so.
TEST(TopologyCarver, SaysThatAConvexMeshHasNothingToCarve)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  auto input = ToPolyData(models::Sphere(1));
  carver->SetInputData(input);
  carver->Update();
  ASSERT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 1u);
  EXPECT_EQ(Triangles(GetLevel(carver, 0)), Triangles(input));
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_NE(GetNotes(carver).find("nothing to carve"), std::string::npos);
}

// Empty input gives empty output and no error.
TEST(TopologyCarver, GivesNothingForNothing)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  vtkNew<vtkPolyData> nothing;
  carver->SetInputData(nothing);
  carver->Update();
  EXPECT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 0u);
  EXPECT_TRUE(messages.Errors.empty());
}

// Crossing triangles are split, and a note gives the number of pairs.
TEST(TopologyCarver, NotesThatItResolvedCrossings)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("bones.off"));
  carver->Update();
  EXPECT_NE(GetNotes(carver).find("366 pairs"), std::string::npos);
}

// Where the mesh encloses a region but is not consistently oriented, a note says that solid is a guess.
TEST(TopologyCarver, NotesThatSolidIsAGuess)
{
  auto mesh = models::Joined(models::Sphere(1), models::Moved(models::Sphere(1), { 3, 0, 0 }));
  std::swap(mesh.Triangles[0][0], mesh.Triangles[0][1]);
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ToPolyData(mesh));
  carver->Update();
  // One flipped triangle of eighty takes 1/40 of the winding number: less than a guess.
  EXPECT_EQ(GetNotes(carver).find("guess"), std::string::npos);
  for (int i = 1; i < 12; ++i)
  {
    std::swap(mesh.Triangles[i][0], mesh.Triangles[i][1]);
  }
  carver->SetInputData(ToPolyData(mesh));
  carver->Update();
  EXPECT_NE(GetNotes(carver).find("guess"), std::string::npos);
}

// Two updates of two filters give the same levels, bit for bit.
TEST(TopologyCarver, IsDeterministic)
{
  vtkNew<vtkTopologyCarver> carvers[2];
  for (auto& carver : carvers)
  {
    carver->SetInputData(ReadReal("bones.off"));
    carver->Update();
  }
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_EQ(Triangles(GetLevel(carvers[0], i)), Triangles(GetLevel(carvers[1], i)));
  }
}

// PrintSelf names every property and its value.
TEST(TopologyCarver, PrintsItself)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->AddLevelTarget(123);
  std::ostringstream text;
  carver->Print(text);
  for (const char* expected :
    { "InitialApproximation: CONVEX_HULL", "PriorityMeasure: LONGEST_EDGE", "DepthExponent: 0",
      "DepthMeasure: HIERARCHY", "BreadthRadius: 0", "CarveExposed: On", "CarveVoids: On",
      "SolidRule: NONZERO_WINDING", "KeepBothFoldSides: Off", "ManifoldOutput: On",
      "NumberOfLevels: 8", "LevelTargetType: VERTICES", "LevelTargets: 123" })
  {
    EXPECT_NE(text.str().find(expected), std::string::npos) << expected;
  }
}

// Progress runs through all stages, never falls, and ends at 1.
TEST(TopologyCarver, ReportsProgressThroughAllStages)
{
  struct Recorder
  {
    void Record()
    {
      this->Fractions.push_back(this->Carver->GetProgress());
      const char* stage = this->Carver->GetProgressText();
      this->Stages.insert(stage ? stage : "");
    }
    vtkNew<vtkTopologyCarver> Carver;
    std::vector<double> Fractions;
    std::set<std::string> Stages;
  } recorder;
  recorder.Carver->SetInputData(ReadReal("bones.off"));
  recorder.Carver->AddObserver(vtkCommand::ProgressEvent, &recorder, &Recorder::Record);
  recorder.Carver->Update();
  EXPECT_TRUE(std::is_sorted(recorder.Fractions.begin(), recorder.Fractions.end()));
  EXPECT_EQ(recorder.Fractions.back(), 1.0);
  for (const char* stage : { "clean", "resolve", "tetrahedralize", "classify", "carve", "output" })
  {
    EXPECT_TRUE(recorder.Stages.count(stage)) << stage;
  }
}
