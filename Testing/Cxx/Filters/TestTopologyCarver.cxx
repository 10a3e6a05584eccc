// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"
#include "RandomModels.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace
{

/** An array of doubles and one of strings. */
void AddNumbersAndNames(vtkDataSetAttributes* data, vtkIdType count)
{
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Number");
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (vtkIdType i = 0; i < count; ++i)
  {
    numbers->InsertNextValue(std::sin(static_cast<double>(i)));
    names->InsertNextValue(std::to_string(i));
  }
  data->AddArray(numbers);
  data->AddArray(names);
}

/** A carver, and the progress that it reports. */
struct ProgressRecorder
{
  ProgressRecorder()
  {
    this->Carver->AddObserver(vtkCommand::ProgressEvent, this, &ProgressRecorder::Record);
  }

  void Record()
  {
    const char* stage = this->Carver->GetProgressText();
    this->Fractions.push_back(this->Carver->GetProgress());
    this->OfStages[stage ? stage : ""].push_back(this->Carver->GetProgress());
  }

  vtkNew<vtkTopologyCarver> Carver;
  std::vector<double> Fractions;
  std::map<std::string, std::vector<double>> OfStages;
};

} // namespace

// The first level of two boxes is their hull, the last the input itself.
TEST(TopologyCarver, GoesFromTheHullToTheInput)
{
  auto input = TwoBoxes();
  const auto carver = Carve(input);
  const int levels = CountLevels(carver);
  ASSERT_GE(levels, 2);
  EXPECT_EQ(GetLevelStep(carver, 0), 0);
  // The ends of the hull are sides of the boxes. Each of the four other sides has two triangles for
  // the gap and four for the boxes.
  EXPECT_EQ(GetLevel(carver, 0)->GetNumberOfPolys(), 4 + 4 * (4 + 2));
  EXPECT_EQ(GetTriangles(GetLevel(carver, levels - 1)), GetTriangles(input));
}

// An inside-out solid gives outward levels.
TEST(TopologyCarver, OrientsLevelsOutward)
{
  auto input = ToPolyData(models::Flipped(
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 2, 0, 0 }, { 3, 1, 1 }))));
  const auto carver = Carve(input, 1);
  EXPECT_EQ(GetTriangles(GetLevel(carver, 0)), GetTriangles(TwoBoxes()));
}

// Levels are named and ordered from coarse to fine, and their points are doubles.
TEST(TopologyCarver, NamesAndOrdersLevels)
{
  const auto carver = Carve(ReadReal("elephant.off"), 5);
  ASSERT_EQ(CountLevels(carver), 5);
  vtkIdType points = 0;
  for (int i = 0; i < 5; ++i)
  {
    vtkInformation* info = carver->GetOutput()->GetMetaData(static_cast<unsigned int>(i));
    EXPECT_EQ(info->Get(vtkCompositeDataSet::NAME()), "LOD " + std::to_string(i));
    vtkPolyData* level = GetLevel(carver, i);
    EXPECT_EQ(level->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_GT(level->GetNumberOfPoints(), points);
    points = level->GetNumberOfPoints();
  }
}

// A target gives the last level with at most that many vertices or triangles, coarsest first.
TEST(TopologyCarver, MeetsLevelTargets)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("elephant.off"));
  for (const auto& [type, name] : { std::pair(vtkTopologyCarver::VERTICES, "Vertices"),
         std::pair(vtkTopologyCarver::TRIANGLES, "Triangles") })
  {
    carver->SetLevelTargetType(type);
    carver->ClearLevelTargets();
    carver->AddLevelTarget(2000);
    carver->AddLevelTarget(1000);
    carver->Update();
    ASSERT_EQ(CountLevels(carver), 2);
    for (int i = 0; i < 2; ++i)
    {
      const double target = 1000 * (i + 1);
      EXPECT_LE(GetFieldValue(GetLevel(carver, i), name), target);
      // The next step would be too large.
      EXPECT_GT(GetProfileValue(carver, GetLevelStep(carver, i) + 1, name), target);
    }
  }
}

// A target below the size of the hull gives the hull, and a warning with both numbers.
TEST(TopologyCarver, WarnsOfATargetBelowTheHull)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->AddLevelTarget(10);
  Carve(carver, ReadReal("elephant.off"));
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_TRUE(Has(messages.Warnings[0], "10 vertices"));
  EXPECT_EQ(GetLevelStep(carver, 0), 0);
}

// A change of a carving or level property, or none, does not run the helper program again.
TEST(TopologyCarver, KeepsTheTetrahedraBetweenUpdates)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  Carve(carver, TwoBoxes());
  const OtherHelper missing("/there/is/no/such/helper");
  carver->SetNumberOfLevels(2);
  carver->Update();
  EXPECT_EQ(CountLevels(carver), 2);
  carver->SetCarveExposed(false);
  carver->Update();
  carver->AddLevelTarget(16);
  carver->Update();
  EXPECT_EQ(CountLevels(carver), 1);
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_EQ(carver->GetStageSeconds(0), 0.0);
}

// A changed input runs the helper program again.
TEST(TopologyCarver, TetrahedralizesAChangedInput)
{
  auto input = TwoBoxes();
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  Carve(carver, input);
  input->GetPoints()->SetPoint(0, -1, 0, 0);
  input->GetPoints()->Modified();
  carver->Update();
  EXPECT_EQ(GetLevel(carver, 0)->GetBounds()[0], -1.0);
}

// Carving exposed tetrahedra saves triangles with the same number of vertices.
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
    EXPECT_EQ(GetFieldValue(GetLevel(carver, 0), "Vertices"), 1000);
    triangles[exposed] = GetLevel(carver, 0)->GetNumberOfPolys();
  }
  EXPECT_LT(triangles[true], triangles[false]);
}

// Empty input gives empty output and no error.
TEST(TopologyCarver, GivesNothingForNothing)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  vtkNew<vtkPolyData> nothing;
  Carve(carver, nothing);
  EXPECT_EQ(CountLevels(carver), 0);
  EXPECT_TRUE(messages.Errors.empty());
}

// A mesh whose triangles are points is an error, not an empty mesh.
TEST(TopologyCarver, RefusesTrianglesThatArePoints)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  Carve(carver, ToPolyData({ std::vector<carving::Point>(3, { 1.0, 2.0, 3.0 }), { { 0, 1, 2 } } }));
  EXPECT_EQ(CountLevels(carver), 0);
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_NE(messages.Errors[0].find("No triangle of the mesh has an area"), std::string::npos);
}

// Two filters give the same levels, stream and profile, bit for bit, whatever the number of
// threads.
TEST(TopologyCarver, IsDeterministic)
{
  vtkNew<vtkTopologyCarver> carvers[2];
  for (const int i : { 0, 1 })
  {
    auto input = ReadReal("bones.off");
    AddNumbersAndNames(input->GetPointData(), input->GetNumberOfPoints());
    AddNumbersAndNames(input->GetCellData(), input->GetNumberOfCells());
    carvers[i]->SetInputData(input);
    carvers[i]->ComputeErrorOn();
    vtkSMPTools::LocalScope(vtkSMPTools::Config(1 + i), [&] { carvers[i]->Update(); });
  }
  ASSERT_EQ(carvers[0]->GetOutput()->GetNumberOfBlocks(), 8u);
  for (int port = 0; port < 3; ++port)
  {
    SCOPED_TRACE("port " + std::to_string(port));
    ExpectEqualData(carvers[0]->GetOutputDataObject(port), carvers[1]->GetOutputDataObject(port));
  }
}

// So do other numbers of threads. Winding numbers of this mesh, which is open, are measured.
TEST(TopologyCarver, GivesTheSameForAnyNumberOfThreads)
{
  std::mt19937_64 random(7);
  auto mesh = models::BoxSoup(6, random);
  mesh.Triangles.resize(mesh.Triangles.size() - 5);
  vtkNew<vtkTopologyCarver> one, several;
  one->SetNumberOfThreads(1);
  one->SetConformity(vtkTopologyCarver::ENCLOSING);
  several->SetConformity(vtkTopologyCarver::ENCLOSING);
  Carve(one, ToPolyData(mesh));
  ASSERT_EQ(GetFieldText(GetLevel(one, 0), "Strategy"), "Delaunay, enclosing");
  ASSERT_GT(CountLevels(one), 1);
  for (const int threads : { 2, 5 })
  {
    several->SetNumberOfThreads(threads);
    Carve(several, ToPolyData(mesh));
    for (int port = 0; port < 3; ++port)
    {
      SCOPED_TRACE("port " + std::to_string(port));
      ExpectEqualData(one->GetOutputDataObject(port), several->GetOutputDataObject(port));
    }
  }
}

// CountIntersectingPairs counts the crossing triangles of any mesh, and gives -1 after an error.
TEST(TopologyCarver, CountsIntersectingPairs)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  EXPECT_EQ(carver->CountIntersectingPairs(TwoBoxes()), 0);
  const models::TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  const models::TriangleMesh sheet = models::Moved(models::Sheet(1), { 0.5, 0.25, 0.5 });
  EXPECT_GT(carver->CountIntersectingPairs(ToPolyData(models::Joined(box, sheet))), 0);
  EXPECT_TRUE(messages.Errors.empty());
  const OtherHelper missing("/there/is/no/such/helper");
  EXPECT_EQ(carver->CountIntersectingPairs(TwoBoxes()), -1);
  EXPECT_EQ(carver->CountIntersectingPairs(nullptr), -1);
  EXPECT_EQ(messages.Errors.size(), 2u);
}

// PrintSelf lists the level targets; a test in Python checks all other properties.
TEST(TopologyCarver, PrintsItsLevelTargets)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->AddLevelTarget(123);
  carver->AddLevelTarget(45);
  std::ostringstream text;
  carver->Print(text);
  EXPECT_TRUE(Has(text.str(), "LevelTargets: 123 45\n"));
}

// Progress passes through all stages, names the attempt, never falls, and ends at 1.
TEST(TopologyCarver, ReportsProgressThroughAllStages)
{
  ProgressRecorder recorder;
  recorder.Carver->SetInputData(ReadReal("bones.off"));
  recorder.Carver->Update();
  EXPECT_TRUE(std::is_sorted(recorder.Fractions.begin(), recorder.Fractions.end()));
  EXPECT_EQ(recorder.Fractions.back(), 1.0);
  for (const char* stage :
    { "clean", "resolve", "tetrahedralize: TetGen -pcY", "classify", "carve", "output" })
  {
    EXPECT_TRUE(recorder.OfStages.count(stage)) << stage;
  }
}

// Within a share of the progress of another filter, progress keeps to that share.
TEST(TopologyCarver, KeepsToItsShareOfTheProgress)
{
  ProgressRecorder whole, half;
  half.Carver->SetProgressShiftScale(0.5, 0.5);
  for (ProgressRecorder* recorder : { &whole, &half })
  {
    recorder->Carver->SetInputData(TwoBoxes());
    recorder->Carver->Update();
  }
  for (const char* stage : { "classify", "carve" })
  {
    EXPECT_DOUBLE_EQ(half.OfStages[stage].back(), 0.5 + 0.5 * whole.OfStages[stage].back())
      << stage;
  }
}

// Where levels are simplified, which takes longest, most of the progress is made meanwhile.
TEST(TopologyCarver, ReportsProgressWhileItSimplifies)
{
  ProgressRecorder recorder;
  recorder.Carver->SetInputData(ToPolyData(models::BumpyTorus(1000)));
  recorder.Carver->SetLevelSimplification(vtkTopologyCarver::ENCLOSING_COLLAPSE);
  recorder.Carver->AddLevelTarget(200);
  recorder.Carver->Update();
  EXPECT_TRUE(std::is_sorted(recorder.Fractions.begin(), recorder.Fractions.end()));
  EXPECT_EQ(recorder.Fractions.back(), 1.0);
  const std::vector<double>& fractions = recorder.OfStages["simplify"];
  ASSERT_FALSE(fractions.empty());
  EXPECT_GT(fractions.back() - fractions.front(), 0.5);
}
