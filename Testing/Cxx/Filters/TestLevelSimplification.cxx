// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Levels that are carved first and decimated then. What decimated surfaces have to obey is tested
 * with the helper.
 */
#include "Core/Mesh/Box.h"
#include "FilterTesting.h"
#include "RandomModels.h"
#include "Shapes.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkEnclosingDecimation.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkFeatureEdges.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTopologyCarver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace
{

/** Two tori, of 200 points each, with a gap between them. */
vtkSmartPointer<vtkPolyData> TwoTori()
{
  const auto torus = models::Torus(1.0, 0.3, 20, 10);
  return ToPolyData(models::Joined(torus, models::Moved(torus, { 0.0, 0.0, 1.0 })));
}

int CountEdgesOfOpenSurface(vtkPolyData* surface)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return static_cast<int>(edges->GetOutput()->GetNumberOfCells());
}

/** Eight plates in a row, all of whose corners lie on the convex hull, and the widest gap. */
vtkSmartPointer<vtkPolyData> Plates(double& gap)
{
  carving::TriangleMesh all;
  double x = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    gap = i == 0 ? 0.0 : 0.4 * i - 0.1;
    const double size = 0.5 + 0.5 * i;
    const auto plate = models::Box({ x + gap, 0.0, 0.0 }, { x + gap + size, size, 0.2 });
    all = i == 0 ? plate : models::Joined(all, plate);
    x += gap + size;
  }
  return ToPolyData(all);
}

void CarveSimplified(vtkTopologyCarver* carver, int type, const std::vector<double>& targets,
  vtkPolyData* input = TwoTori())
{
  carver->SetLevelSimplification(vtkTopologyCarver::ENCLOSING_COLLAPSE);
  carver->SetLevelTargetType(type);
  for (const double target : targets)
  {
    carver->AddLevelTarget(target);
  }
  Carve(carver, input);
}

} // namespace

// Trials that run beside each other give the same levels as trials that run one after the other.
TEST(LevelSimplification, GivesTheSameForAnyNumberOfThreads)
{
  const std::pair<int, std::vector<double>> cases[] = {
    { vtkTopologyCarver::VERTICES, { 30, 60, 150 } },
    { vtkTopologyCarver::ERROR_BOUND, { 0.2, 0.05 } },
  };
  for (const auto& [type, targets] : cases)
  {
    vtkNew<vtkTopologyCarver> one, several;
    one->SetNumberOfThreads(1);
    several->SetNumberOfThreads(3);
    CarveSimplified(one, type, targets);
    CarveSimplified(several, type, targets);
    for (int port = 0; port < 3; ++port)
    {
      ExpectEqualData(one->GetOutputDataObject(port), several->GetOutputDataObject(port));
    }
  }
}

// Levels have the numbers of vertices or triangles that are asked for, and are closed.
TEST(LevelSimplification, ReachesNumbers)
{
  for (const int type : { vtkTopologyCarver::VERTICES, vtkTopologyCarver::TRIANGLES })
  {
    vtkNew<vtkTopologyCarver> carver;
    CarveSimplified(carver, type, { 240, 40, 120 });
    ASSERT_EQ(CountLevels(carver), 3);
    for (int i = 0; i < 3; ++i)
    {
      vtkPolyData* level = GetLevel(carver, i);
      const vtkIdType count = type == vtkTopologyCarver::VERTICES ? level->GetNumberOfPoints()
                                                                  : level->GetNumberOfPolys();
      EXPECT_LE(count, i == 0 ? 40 : i == 1 ? 120 : 240);
      EXPECT_EQ(GetFieldValue(level, "Vertices"), level->GetNumberOfPoints());
      EXPECT_EQ(GetFieldValue(level, "Triangles"), level->GetNumberOfPolys());
      EXPECT_EQ(GetFieldText(level, "Kind"), "simplified");
      EXPECT_EQ(CountEdgesOfOpenSurface(level), 0);
    }
  }
}

// A simplified level is closer to the mesh than a level of the carving with as many vertices.
TEST(LevelSimplification, IsCloserThanASubset)
{
  vtkNew<vtkTopologyCarver> simplified, subset;
  CarveSimplified(simplified, vtkTopologyCarver::VERTICES, { 120 });
  subset->ComputeErrorOn();
  subset->SetInputData(TwoTori());
  CarveTo(subset, vtkTopologyCarver::VERTICES, 120);
  EXPECT_LT(
    GetFieldValue(LastLevel(simplified), "Error"), GetFieldValue(LastLevel(subset), "Error"));
}

// A level with more vertices is not farther from the mesh, by more than the accuracy of distances,
// also where parts of the surface touch.
TEST(LevelSimplification, IsNotFartherWithMoreVertices)
{
  constexpr double accuracy = 1.021;
  std::mt19937_64 random(18);
  int compared = 0;
  for (int i = 0; i < 3; ++i)
  {
    const std::vector<double> targets = { 60, 90, 130, 200, 300 };
    vtkNew<vtkTopologyCarver> carver;
    CarveSimplified(
      carver, vtkTopologyCarver::VERTICES, targets, ToPolyData(models::Soup(25, random)));
    double least = HUGE_VAL;
    for (int level = 0; level < CountLevels(carver); ++level)
    {
      const double error = GetFieldValue(GetLevel(carver, level), "Error");
      if (GetFieldValue(GetLevel(carver, level), "Vertices") <= targets[level])
      {
        EXPECT_LE(error, accuracy * least) << "soup " << i << ", level " << level;
        least = std::min(least, error);
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 9);
}

// No level is farther from the mesh than the mesh, decimated to the same number of vertices and
// brought closer by bounds: that is one of the trials.
TEST(LevelSimplification, IsAsCloseAsADecimationOfTheMesh)
{
  const std::vector<double> targets = { 100, 200, 300 };
  const carving::TriangleMesh torus = models::Torus(1.0, 0.3, 32, 16);
  const auto mesh = ToPolyData(torus);
  vtkNew<vtkTopologyCarver> carver;
  CarveSimplified(carver, vtkTopologyCarver::VERTICES, targets, mesh);
  const std::vector<double> unbounded = ErrorsOfOneRun(torus, { 300, 200, 100 });
  vtkNew<vtkEnclosingDecimation> decimation;
  decimation->SetInputData(mesh);
  for (const double target : targets)
  {
    decimation->AddTarget(target);
  }
  decimation->Update();
  auto* surfaces = vtkMultiBlockDataSet::SafeDownCast(decimation->GetOutputDataObject(1));
  int closer = 0;
  for (int level = 0; level < 3; ++level)
  {
    const double error = GetFieldValue(GetLevel(carver, level), "Error");
    auto* surface = vtkPolyData::SafeDownCast(surfaces->GetBlock(level)); // the coarsest first
    const double other = GetFieldValue(surface, "Error");
    EXPECT_EQ(surface->GetNumberOfPoints(), targets[level]);
    EXPECT_LE(error, 1.01 * other);
    closer += error < 0.97 * unbounded[2 - level];
  }
  EXPECT_GT(closer, 0); // by bounds
}

// Numbers below that of the convex hull are reached, too.
TEST(LevelSimplification, GoesBelowTheHull)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  CarveSimplified(carver, vtkTopologyCarver::VERTICES, { 10 });
  EXPECT_EQ(LastLevel(carver)->GetNumberOfPoints(), 10);
  EXPECT_TRUE(messages.Warnings.empty());
}

// Where all vertices lie on the hull, components tell which step a level comes from. A surface that
// bridges a gap has a point in the middle of the gap.
TEST(LevelSimplification, FindsStepsWhereAllHaveTheSameVertices)
{
  double widestGap = 0.0;
  const auto plates = Plates(widestGap);
  vtkNew<vtkTopologyCarver> carver;
  CarveSimplified(carver, vtkTopologyCarver::VERTICES, { 20 }, plates);
  EXPECT_LE(LastLevel(carver)->GetNumberOfPoints(), 20);
  EXPECT_LT(GetFieldValue(LastLevel(carver), "Error"), widestGap / 2.0);
}

// A number of tunnels and one of vertices can be limited at the same time.
TEST(LevelSimplification, LimitsTunnelsAndVertices)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetMaximumVertices(50);
  CarveSimplified(carver, vtkTopologyCarver::TUNNELS, { 0, 2 });
  ASSERT_EQ(CountLevels(carver), 2);
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_LE(GetLevel(carver, i)->GetNumberOfPoints(), 50);
    EXPECT_LE(GetFieldValue(GetLevel(carver, i), "SurfaceGenus"), 2 * i);
  }
}

// Within an error bound, no level of the carving has as few vertices.
TEST(LevelSimplification, StaysWithinAnErrorBound)
{
  vtkNew<vtkTopologyCarver> simplified, subset;
  CarveSimplified(simplified, vtkTopologyCarver::ERROR_BOUND, { 0.1 });
  subset->SetInputData(TwoTori());
  CarveTo(subset, vtkTopologyCarver::ERROR_BOUND, 0.1);
  EXPECT_LE(GetFieldValue(LastLevel(simplified), "Error"), 0.1);
  EXPECT_LT(LastLevel(simplified)->GetNumberOfPoints(), LastLevel(subset)->GetNumberOfPoints());
}

// Where a budget keeps all steps farther from the mesh than an error bound, the level is about as
// close as the closest step, with the error's accuracy.
TEST(LevelSimplification, IsCloseWhereAnErrorBoundIsOutOfReach)
{
  vtkNew<vtkTopologyCarver> simplified, subset;
  for (vtkTopologyCarver* carver : { simplified.Get(), subset.Get() })
  {
    carver->SetInputData(ToPolyData(models::Torus(2.0, 0.8, 12, 8)));
    carver->SetMaximumTunnels(0);
    carver->ComputeErrorOn();
  }
  subset->SetNumberOfLevels(1);
  subset->Update();
  const double closest = GetFieldValue(LastLevel(subset), "Error");
  ASSERT_GT(closest, 0.1);
  simplified->SetLevelSimplification(vtkTopologyCarver::ENCLOSING_COLLAPSE);
  CarveTo(simplified, vtkTopologyCarver::ERROR_BOUND, 1e-6);
  EXPECT_LE(GetFieldValue(LastLevel(simplified), "Error"), 1.01 * closest);
}

// Without targets, levels have the vertex counts of those of a carving by the same measure, and end
// in the same level.
TEST(LevelSimplification, SpreadsLevelsAsBefore)
{
  vtkNew<vtkTopologyCarver> simplified, subset;
  simplified->SetNumberOfLevels(5);
  CarveSimplified(simplified, vtkTopologyCarver::VERTICES, {});
  subset->SetNumberOfLevels(5);
  subset->SetPriorityMeasure(vtkTopologyCarver::EDGE_DISTANCE);
  Carve(subset, TwoTori());
  ASSERT_EQ(CountLevels(simplified), CountLevels(subset));
  for (int i = 0; i < CountLevels(subset); ++i)
  {
    EXPECT_LE(GetFieldValue(GetLevel(simplified, i), "Vertices"),
      GetFieldValue(GetLevel(subset, i), "Vertices"));
    EXPECT_TRUE(i == 0 || GetLevelStep(simplified, i) >= GetLevelStep(simplified, i - 1));
  }
  ExpectEqualData(LastLevel(simplified), LastLevel(subset));
}

// Open steps cannot be decimated: one warning says so and why, once, and a coarser step that is
// closed takes their place.
TEST(LevelSimplification, PassesOverOpenSteps)
{
  const auto sheet = models::Sheet(3);
  const auto sheets = ToPolyData(models::Joined(sheet, models::Moved(sheet, { 0.1, 0.2, 1.0 })));
  vtkNew<vtkTopologyCarver> carver;
  carver->SetLevelSimplification(vtkTopologyCarver::ENCLOSING_COLLAPSE);
  carver->KeepBothFoldSidesOff();
  carver->AddLevelTarget(20);
  Messages messages(carver);
  Carve(carver, sheets);
  ASSERT_EQ(messages.Warnings.size(), 1u);
  const std::string& warning = messages.Warnings[0];
  EXPECT_TRUE(Has(warning, "of the stream cannot be simplified. The surface is open"));
  EXPECT_EQ(warning.find("The surface is open"), warning.rfind("The surface is open"));
  EXPECT_EQ(CountEdgesOfOpenSurface(LastLevel(carver)), 0);
  EXPECT_LE(GetFieldValue(LastLevel(carver), "Vertices"), 20);
}

// What a stream does not store gives the closest level, and a warning says so: numbers below the
// coarsest level, smaller errors than those of all levels, and any target without simplified
// levels.
TEST(LevelSimplification, WarnsOfWhatIsNotStored)
{
  vtkNew<vtkTopologyCarver> simplified, subset;
  CarveSimplified(simplified, vtkTopologyCarver::VERTICES, { 80 });
  Carve(subset, TwoTori());
  const std::tuple<vtkTopologyCarver*, int, double, const char*> all[] = {
    { simplified, vtkExtractCarvedLOD::VERTICES, 10.0, "out of reach" },
    { simplified, vtkExtractCarvedLOD::ERROR_BOUND, 1e-6, "No stored simplified level is within" },
    { subset, vtkExtractCarvedLOD::VERTICES, 300.0, "Carve with LevelSimplification" }
  };
  for (const auto& [carver, type, target, warning] : all)
  {
    vtkNew<vtkExtractCarvedLOD> extract;
    Messages messages(extract);
    extract->SetInputData(carver->GetOutputDataObject(1));
    extract->SetLevelSimplification(vtkExtractCarvedLOD::ENCLOSING_COLLAPSE);
    extract->SetLevelTargetType(type);
    extract->SetLevelTarget(target);
    extract->Update();
    const bool isSimplified = GetFieldText(extract->GetOutput(), "Kind") == "simplified";
    EXPECT_EQ(isSimplified, carver == simplified);
    EXPECT_TRUE(!isSimplified || extract->GetOutput()->GetNumberOfPoints() == 80);
    ASSERT_EQ(messages.Warnings.size(), 1u);
    EXPECT_TRUE(Has(messages.Warnings[0], warning)) << messages.Warnings[0];
  }
}

// An abort gives empty output without an error, and the next update works.
TEST(LevelSimplification, CanBeAborted)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  {
    const Aborter aborter(carver, "simplify");
    CarveSimplified(carver, vtkTopologyCarver::VERTICES, { 200 });
  }
  EXPECT_EQ(CountLevels(carver), 0);
  carver->Modified();
  carver->Update();
  EXPECT_EQ(CountLevels(carver), 1);
  EXPECT_TRUE(messages.Errors.empty());
}

// New vertices have the point data of the closest point of the input, and triangles of the input
// keep their cells.
TEST(LevelSimplification, PassesAttributesOn)
{
  const vtkSmartPointer<vtkPolyData> tori = TwoTori();
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Height");
  for (vtkIdType i = 0; i < tori->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(static_cast<float>(tori->GetPoint(i)[2]));
  }
  tori->GetPointData()->AddArray(heights);
  vtkNew<vtkTopologyCarver> carver;
  carver->SetLevelSimplification(vtkTopologyCarver::ENCLOSING_COLLAPSE);
  carver->AddLevelTarget(200);
  Carve(carver, tori);
  vtkPolyData* level = LastLevel(carver);
  vtkDataArray* passed = level->GetPointData()->GetArray("Height");
  ASSERT_TRUE(passed && level->GetCellData()->GetArray("vtkOriginalCellIds"));
  for (vtkIdType i = 0; i < level->GetNumberOfPoints(); ++i)
  {
    // The closest point cannot be farther than the error of the level.
    EXPECT_NEAR(passed->GetTuple1(i), level->GetPoint(i)[2], GetFieldValue(level, "Error") + 1e-6);
  }
}
