// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Simplified levels from the stored stream.
 */
#include "Checks.h"
#include "FilterTesting.h"
#include "Shapes.h"
#include "StreamTesting.h"

#include "vtkDoubleArray.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTopologyCarver.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace
{

/** Two linked tori of 200 points each. */
carving::TriangleMesh Links()
{
  const auto torus = models::Torus(1.0, 0.3, 20, 10);
  auto other = models::Moved(torus, { 1.0, 0.0, 0.0 });
  for (carving::Point& p : other.Points)
  {
    p = { p[0], p[2], -p[1] };
  }
  return models::Joined(torus, other);
}

void CarveLinks(vtkTopologyCarver* carver, int type, const std::vector<double>& targets)
{
  carver->SetLevelSimplification(vtkTopologyCarver::ENCLOSING_COLLAPSE);
  carver->SetLevelTargetType(type);
  for (const double target : targets)
  {
    carver->AddLevelTarget(target);
  }
  Carve(carver, ToPolyData(Links()));
}

/** The stream as from a file, without its filter. */
vtkSmartPointer<vtkUnstructuredGrid> CopyStream(vtkTopologyCarver* carver)
{
  auto stream = vtkSmartPointer<vtkUnstructuredGrid>::New();
  stream->DeepCopy(carver->GetOutputDataObject(1));
  return stream;
}

vtkSmartPointer<vtkExtractCarvedLOD> MakeExtractor(vtkUnstructuredGrid* stream, int type)
{
  auto extract = vtkSmartPointer<vtkExtractCarvedLOD>::New();
  extract->SetInputData(stream);
  extract->SetLevelSimplification(vtkExtractCarvedLOD::ENCLOSING_COLLAPSE);
  extract->SetLevelTargetType(type);
  return extract;
}

/** Expects a closed surface around the links that does not cross itself, but may touch itself. */
void ExpectAroundLinks(vtkPolyData* level)
{
  carving::TriangleMesh surface;
  for (vtkIdType i = 0; i < level->GetNumberOfPoints(); ++i)
  {
    level->GetPoint(i, surface.Points.emplace_back().data());
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < level->GetNumberOfCells(); ++i)
  {
    level->GetCellPoints(i, corners);
    std::copy(corners->begin(), corners->end(), surface.Triangles.emplace_back().begin());
  }
  EXPECT_TRUE(checks::IsClosed(surface.Triangles));
  EXPECT_EQ(checks::CountCrossings(
              surface.Points, checks::WithPointsMerged(surface.Points, surface.Triangles)),
    0);
  for (const carving::Point& p : Links().Points)
  {
    EXPECT_TRUE(checks::Encloses(surface.Points, surface.Triangles, p));
  }
}

} // namespace

// For the carver's targets, the levels are bit for bit the carver's.
TEST(SimplifiedLevels, AreTheCarversLevels)
{
  using Carver = vtkTopologyCarver;
  const std::pair<int, std::vector<double>> all[] = { { Carver::VERTICES, { 30, 90, 250 } },
    { Carver::TRIANGLES, { 100, 301 } }, { Carver::ERROR_BOUND, { 0.3, 0.05 } },
    { Carver::TUNNELS, { 0, 2 } }, { Carver::COMPONENTS, { 1 } } };
  for (const auto& [type, targets] : all)
  {
    vtkNew<vtkTopologyCarver> carver;
    carver->SetMaximumVertices(60);
    CarveLinks(carver, type, targets);
    const auto extract = MakeExtractor(CopyStream(carver), type);
    extract->SetMaximumVertices(60);
    for (std::size_t i = 0; i < targets.size(); ++i) // from coarse to fine
    {
      extract->SetLevelTarget(targets[i]);
      extract->Update();
      ExpectEqualData(extract->GetOutput(), GetLevel(carver, static_cast<int>(i)));
    }
  }
}

// Without targets, the times of an animation give the levels of the carver.
TEST(SimplifiedLevels, FollowTheTime)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetNumberOfLevels(5);
  CarveLinks(carver, vtkTopologyCarver::VERTICES, {});
  const auto extract = MakeExtractor(CopyStream(carver), vtkTopologyCarver::VERTICES);
  extract->SetNumberOfTimeSteps(5);
  for (int i = 0; i < 5; ++i)
  {
    extract->UpdateTimeStep(i);
    ExpectEqualData(extract->GetOutput(), GetLevel(carver, i));
  }
}

// Numbers between the targets are reached, each by a surface around the mesh; steps stay in order.
TEST(SimplifiedLevels, ReachNumbersBetweenTargets)
{
  vtkNew<vtkTopologyCarver> carver;
  CarveLinks(carver, vtkTopologyCarver::VERTICES, { 20, 80 });
  const auto extract = MakeExtractor(CopyStream(carver), vtkTopologyCarver::VERTICES);
  double lastStep = 0.0;
  for (const int number : { 20, 27, 40, 63, 80, 111, 170, 260, 399 })
  {
    extract->SetLevelTarget(number);
    extract->Update();
    vtkPolyData* level = extract->GetOutput();
    EXPECT_LE(level->GetNumberOfPoints(), number);
    EXPECT_GE(level->GetNumberOfPoints(), 0.9 * number);
    EXPECT_EQ(GetFieldText(level, "Kind"), "simplified");
    EXPECT_GE(GetFieldValue(level, "Step"), lastStep);
    lastStep = GetFieldValue(level, "Step");
    ExpectAroundLinks(level);
  }
}

// The range of numbers begins at the coarsest level that is stored, below or above the number of
// the hull, and that of error bounds at the closest one.
TEST(SimplifiedLevels, HaveARange)
{
  for (const double number : { 20.0, 300.0 })
  {
    vtkNew<vtkTopologyCarver> carver;
    CarveLinks(carver, vtkTopologyCarver::VERTICES, { number });
    const auto extract = MakeExtractor(CopyStream(carver), vtkTopologyCarver::VERTICES);
    const Messages messages(extract);
    double range[2];
    ASSERT_TRUE(extract->GetLevelTargetRange(vtkExtractCarvedLOD::VERTICES, range));
    EXPECT_EQ(range[0], number);
    EXPECT_EQ(range[1], 400.0);
    ASSERT_TRUE(extract->GetLevelTargetRange(vtkExtractCarvedLOD::ERROR_BOUND, range));
    extract->SetLevelTargetType(vtkExtractCarvedLOD::ERROR_BOUND);
    extract->SetLevelTarget(range[0]);
    extract->Update();
    EXPECT_TRUE(messages.Warnings.empty());
    EXPECT_EQ(extract->GetOutput()->GetFieldData()->GetArray("Error")->GetTuple1(0), range[0]);
  }
}

// Damaged arrays are refused with an error that names the array.
TEST(SimplifiedLevels, AreRefusedIfDamaged)
{
  vtkNew<vtkTopologyCarver> carver;
  CarveLinks(carver, vtkTopologyCarver::VERTICES, { 80 });
  const auto whole = CopyStream(carver);
  EXPECT_EQ(ErrorOf(whole), "");
  constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
  const std::tuple<const char*, vtkIdType, double> values[] = { { "SimplifiedType", 0, 3.0 },
    { "SimplifiedType", 0, NaN }, { "SimplifiedSteps", 0, 1e6 }, { "SimplifiedSteps", 1, -1.0 },
    { "SimplifiedSteps", 3, -1.0 }, { "SimplifiedPoints", 0, 1e6 }, { "SimplifiedPoints", 1, -1.0 },
    { "SimplifiedFaces", 0, 1e6 }, { "SimplifiedFaces", 3, 1e6 }, { "SimplifiedFaces", 4, 1e6 },
    { "SimplifiedFaces", 5, 0.0 }, { "SimplifiedFaces", 2, 0.5 }, { "SimplifiedLevels", 0, 5.0 },
    { "SimplifiedLevels", 1, 0.5 }, { "SimplifiedLevels", 1, 1e6 }, { "SimplifiedLevels", 2, NaN },
    { "SimplifiedLevels", 3, 1e6 } };
  for (const auto& [name, at, value] : values)
  {
    vtkNew<vtkUnstructuredGrid> stream;
    stream->DeepCopy(whole);
    vtkNew<vtkDoubleArray> changed;
    changed->DeepCopy(stream->GetFieldData()->GetArray(name));
    changed->SetValue(at, value);
    changed->SetName(name);
    stream->GetFieldData()->AddArray(changed);
    ExpectError(stream, "the array \"" + std::string(name) + "\" ");
  }
  for (const char* name :
    { "SimplifiedSteps", "SimplifiedPoints", "SimplifiedFaces", "SimplifiedLevels" })
  {
    vtkNew<vtkUnstructuredGrid> stream;
    stream->DeepCopy(whole);
    stream->GetFieldData()->RemoveArray(name);
    ExpectError(stream, "the array \"" + std::string(name) + "\" is missing");
  }
}
