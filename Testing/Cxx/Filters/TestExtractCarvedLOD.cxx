// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkFieldData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

/** The stream as from a file, without its filter. */
vtkSmartPointer<vtkUnstructuredGrid> CopyStream(vtkTopologyCarver* carver)
{
  auto stream = vtkSmartPointer<vtkUnstructuredGrid>::New();
  stream->DeepCopy(carver->GetOutputDataObject(1));
  return stream;
}

} // namespace

// Every level is bit for bit the one that the carver gives, cut or not, with one or both sides of
// folds.
TEST(ExtractCarvedLOD, GivesTheCarversLevels)
{
  for (const char* mesh : { "bones.off", "elephant.off" })
  {
    for (const bool other : { false, true })
    {
      vtkNew<vtkTopologyCarver> carver;
      carver->SetManifoldOutput(!other);
      carver->SetKeepBothFoldSides(other);
      carver->SetSolidRule(
        other ? vtkTopologyCarver::SURFACE_ONLY : vtkTopologyCarver::NONZERO_WINDING);
      Carve(carver, ReadReal(mesh));
      EXPECT_EQ(CountLevels(carver), 8);
      ExpectSameLevelsFromStream(carver);
    }
  }
}

// Targets of each type pick the same step as in the carver.
TEST(ExtractCarvedLOD, PicksLevelsAsTheCarverDoes)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("bones.off"));
  const std::pair<int, double> targets[] = { { vtkTopologyCarver::VERTICES, 500 },
    { vtkTopologyCarver::TRIANGLES, 2000 }, { vtkTopologyCarver::FEATURE_SIZE, 0.7 },
    { vtkTopologyCarver::TUNNELS, 5 }, { vtkTopologyCarver::COMPONENTS, 3 },
    { vtkTopologyCarver::ERROR_BOUND, 0.3 }, { vtkTopologyCarver::STEP, 77 } };
  for (const auto& [type, target] : targets)
  {
    CarveTo(carver, type, target);
    vtkNew<vtkExtractCarvedLOD> extract;
    extract->SetInputData(CopyStream(carver));
    extract->SetLevelTargetType(type);
    extract->SetLevelTarget(target);
    extract->Update();
    ExpectEqualData(GetLevel(carver, 0), extract->GetOutput());
  }
}

// A feature size gives the step before the first pop with a priority of at most that size.
TEST(ExtractCarvedLOD, StopsBeforeAFeatureSize)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("bones.off"));
  CarveTo(carver, vtkTopologyCarver::FEATURE_SIZE, 1.0);
  EXPECT_GT(GetFieldValue(GetLevel(carver, 0), "FeatureSize"), 1.0);
  CarveTo(carver, vtkTopologyCarver::STEP, GetLevelStep(carver, 0) + 1);
  EXPECT_LE(GetFieldValue(GetLevel(carver, 0), "FeatureSize"), 1.0);
}

// A step beyond the last gives the last level and a warning.
TEST(ExtractCarvedLOD, WarnsOfAStepBeyondTheLast)
{
  const auto carver = Carve(TwoBoxes());
  vtkNew<vtkExtractCarvedLOD> extract;
  Messages messages(extract);
  extract->SetInputData(CopyStream(carver));
  extract->SetLevelTargetType(vtkExtractCarvedLOD::STEP);
  extract->SetLevelTarget(1e6);
  extract->Update();
  EXPECT_EQ(messages.Warnings.size(), 1u);
  EXPECT_EQ(extract->GetOutput()->GetNumberOfPolys(), 24);
}

// A target that is no number leaves the last one.
TEST(ExtractCarvedLOD, RefusesATargetThatIsNoNumber)
{
  vtkNew<vtkExtractCarvedLOD> extract;
  Messages messages(extract);
  extract->SetLevelTarget(7.0);
  extract->SetLevelTarget(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(messages.Errors.size(), 1u);
  EXPECT_EQ(extract->GetLevelTarget(), 7.0);
}

// A grid that is no stream, lacks an array, or has a cell with a repeated corner is refused with
// one error.
TEST(ExtractCarvedLOD, RefusesWhatIsNoStream)
{
  const auto carver = Carve(TwoBoxes());
  vtkSmartPointer<vtkUnstructuredGrid> grids[4];
  for (auto& grid : grids)
  {
    grid = CopyStream(carver);
  }
  grids[0]->GetCellData()->RemoveArray("Step");
  grids[1]->GetFieldData()->RemoveArray("ProfileVertices");
  grids[2]->GetCellData()->RemoveArray("SolidSides");
  vtkDataArray* corners = grids[3]->GetCells()->GetConnectivityArray();
  corners->SetTuple1(0, corners->GetTuple1(1));
  for (const auto& grid : grids)
  {
    vtkNew<vtkExtractCarvedLOD> extract;
    Messages messages(extract);
    extract->SetInputData(grid);
    extract->Update();
    EXPECT_EQ(messages.Errors.size(), 1u);
    EXPECT_EQ(extract->GetOutput()->GetNumberOfCells(), 0);
  }
}

// The profile of a stored stream is that of the carver; without a stream there is none.
TEST(ExtractCarvedLOD, GivesTheCarversProfile)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->ComputeErrorOn();
  Carve(carver, TwoBoxes());
  vtkNew<vtkExtractCarvedLOD> extract;
  vtkNew<vtkTable> profile;
  EXPECT_FALSE(extract->GetProfile(profile));
  extract->SetInputData(CopyStream(carver));
  EXPECT_TRUE(extract->GetProfile(profile));
  EXPECT_GT(profile->GetNumberOfRows(), 1);
  ExpectEqualData(carver->GetOutputDataObject(2), profile);
}

// A changed stream is read again.
TEST(ExtractCarvedLOD, FollowsAChangedStream)
{
  const auto carver = Carve(TwoBoxes());
  auto stream = CopyStream(carver);
  vtkNew<vtkExtractCarvedLOD> extract;
  extract->SetInputData(stream);
  extract->SetLevelTargetType(vtkExtractCarvedLOD::STEP);
  extract->SetLevelTarget(0);
  extract->Update();
  const vtkIdType before = extract->GetOutput()->GetNumberOfPolys();
  Carve(carver, ReadReal("elephant.off"));
  stream->DeepCopy(carver->GetOutputDataObject(1));
  extract->Update();
  EXPECT_NE(extract->GetOutput()->GetNumberOfPolys(), before);
}
