// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The components, tunnels, voids and errors of levels, the profile and the stored stream.
 */
#include "ContourTesting.h"
#include "RealMeshes.h"

#include "vtkDataArray.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkFieldData.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace
{

constexpr const char* Names[] = { "Components", "Tunnels", "Voids", "SurfaceComponents",
  "SurfaceGenus" };
using Numbers = std::array<int, 5>;

Numbers GetTopology(vtkPolyData* level)
{
  Numbers numbers;
  for (int i = 0; i < 5; ++i)
  {
    vtkDataArray* array = level->GetFieldData()->GetArray(Names[i]);
    numbers[i] = array ? static_cast<int>(array->GetTuple1(0)) : -99;
  }
  return numbers;
}

Numbers GetLastTopology(const carving::TriangleMesh& mesh)
{
  const auto carver = Carve(ToPolyData(mesh), 1);
  return GetTopology(GetLevel(carver, 0));
}

carving::TriangleMesh Box(double x, double y, double size = 1.0)
{
  return models::Box({ x, y, 0.0 }, { x + size, y + size, size });
}

} // namespace

// The last levels of two boxes, a torus and a shell have two components, a tunnel and a void; the
// first levels have one component.
TEST(LevelTopology, CountsPiecesTunnelsAndVoids)
{
  const auto carver = Carve(TwoBoxes(), 2);
  EXPECT_EQ(GetTopology(GetLevel(carver, 0)), (Numbers{ 1, 0, 0, 1, 0 }));
  EXPECT_EQ(GetTopology(GetLevel(carver, 1)), (Numbers{ 2, 0, 0, 2, 0 }));
  EXPECT_EQ(GetLastTopology(models::Torus(1.0, 0.3, 12, 8)), (Numbers{ 1, 1, 0, 1, 1 }));
  const auto hollow = models::Flipped(models::Moved(models::Sphere(1), { 0, 0, 0 }, 0.5));
  EXPECT_EQ(GetLastTopology(models::Joined(models::Sphere(1), hollow)), (Numbers{ 1, 0, 1, 2, 0 }));
}

// Boxes that touch in edges are one component of the closed complex, but several surfaces; a ring
// of them has a tunnel.
TEST(LevelTopology, TellsTouchingFromJoined)
{
  const auto row = models::Joined(Box(0, 0), Box(1, 1));
  EXPECT_EQ(GetLastTopology(row), (Numbers{ 1, 0, 0, 2, 0 }));
  const auto ring =
    models::Joined(models::Joined(Box(0, 1), Box(1, 0)), models::Joined(Box(1, 2), Box(2, 1)));
  EXPECT_EQ(GetLastTopology(ring), (Numbers{ 1, 1, 0, 4, 0 }));
}

// An open surface, or one that has not been cut, has components but no genus.
TEST(LevelTopology, HasNoGenusWhereOpenOrUncut)
{
  const auto carver = Carve(ToPolyData(models::Joined(models::Sheet(3), Box(0, 0.25, 0.5))), 1);
  EXPECT_EQ(GetTopology(GetLevel(carver, 0))[4], -1);
  carver->ManifoldOutputOff();
  Carve(carver, ToPolyData(models::Joined(Box(0, 0), Box(1, 1))));
  EXPECT_EQ(GetTopology(GetLevel(carver, 0)), (Numbers{ 1, 0, 0, 1, -1 }));
}

// Levels have the numbers of their row of the profile, from the carver and from the stored stream.
TEST(LevelTopology, AgreesWithTheProfile)
{
  const auto carver = Carve(ReadReal("elephant.off"));
  double volume = HUGE_VAL;
  for (int i = 0; i < 8; ++i)
  {
    vtkPolyData* level = GetLevel(carver, i);
    const int step = GetLevelStep(carver, i);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(GetProfileValue(carver, step, Names[k]), GetTopology(level)[k]);
    }
    EXPECT_LT(GetProfileValue(carver, step, "Volume"), volume);
    volume = GetProfileValue(carver, step, "Volume");
  }
  ExpectSameLevelsFromStream(carver);
  const int genus = GenusOf(ReadRealMesh("elephant.off"));
  EXPECT_EQ(GetTopology(GetLevel(carver, 7)), (Numbers{ 1, genus, 0, 1, genus }));
}

// An appended input has -1 for all numbers on topology.
TEST(LevelTopology, IsUnknownOfAnAppendedInput)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->AppendInputOn();
  carver->SetNumberOfLevels(1);
  Carve(carver, ToPolyData(models::Joined(Box(0, 0), Box(0.5, 0.5))));
  EXPECT_EQ(CountLevels(carver), 2);
  EXPECT_EQ(GetTopology(GetLevel(carver, 1)), (Numbers{ -1, -1, -1, -1, -1 }));
}

// Targets give the last level before one that has more tunnels or components.
TEST(LevelTopology, MeetsTargets)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("bones.off"));
  for (const auto& [type, name, target] : { std::tuple(vtkTopologyCarver::TUNNELS, "Tunnels", 3),
         std::tuple(vtkTopologyCarver::COMPONENTS, "Components", 4) })
  {
    CarveTo(carver, type, target);
    const int step = GetLevelStep(carver, 0);
    for (int i = 0; i <= step; ++i)
    {
      EXPECT_LE(GetProfileValue(carver, i, name), target);
    }
    EXPECT_GT(GetProfileValue(carver, step + 1, name), target);
  }
}

// The error of the hull of two boxes is half the width of their gap, the last error is 0; without a
// request there is none.
TEST(LevelTopology, ComputesTheErrorOnRequest)
{
  const auto carver =
    Carve(ToPolyData(models::Joined(Box(0, 0), models::Box({ 2, 0, 0 }, { 3, 1, 1 }))), 2);
  const auto error = [&](int level) { return GetFieldValue(GetLevel(carver, level), "Error"); };
  EXPECT_TRUE(std::isnan(error(0)));
  carver->ComputeErrorOn();
  carver->Update();
  EXPECT_GE(error(0), 0.5 * (1.0 - 1e-12));
  EXPECT_LE(error(0), 0.505);
  EXPECT_EQ(error(1), 0.0);
  EXPECT_EQ(GetProfileValue(carver, 0, "Error"), error(0));
}

// In a plane, the error of the hull of two squares is half the width of their gap.
TEST(LevelTopology, ComputesTheErrorOfContours)
{
  vtkNew<vtkContourCarver> carver;
  carver->ComputeErrorOn();
  Carve(carver, MakePolygons({ Rectangle(0, 0, 1, 1), Rectangle(2, 0, 3, 1) }));
  const vtkIdType last = GetProfile(carver)->GetNumberOfRows() - 1;
  EXPECT_GE(GetProfileValue(carver, 0, "Error"), 0.5 * (1.0 - 1e-12));
  EXPECT_LE(GetProfileValue(carver, 0, "Error"), 0.505);
  EXPECT_EQ(GetProfileValue(carver, last, "Error"), 0.0);
  EXPECT_EQ(GetProfileValue(carver, 0, "Volume"), 3.0);
  EXPECT_EQ(GetProfileValue(carver, last, "Volume"), 2.0);
  EXPECT_EQ(GetProfileValue(carver, last, "Components"), 2);
}

// In enclosing mode, the error is the distance from the mesh; a bound that no level meets gives the
// last level and a warning. Without new vertices, triangles that cross each other are not met.
TEST(LevelTopology, WarnsOfAnErrorBoundThatNoLevelMeets)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->SetEnclosingTolerance(0.0);
  carver->SetLevelTargetType(vtkTopologyCarver::ERROR_BOUND);
  carver->AddLevelTarget(1e-6);
  Carve(carver,
    ToPolyData(
      models::Joined(Box(0, 0), models::Moved(models::Torus(1.0, 0.3, 12, 8), { 0.4, 0.3, 0.5 }))));
  ASSERT_EQ(messages.Warnings.size(), 1u);
  const double last = GetProfileValue(carver, GetProfile(carver)->GetNumberOfRows() - 1, "Error");
  EXPECT_GT(last, 1e-6);
  EXPECT_EQ(GetLevelStep(carver, 0), GetProfile(carver)->GetNumberOfRows() - 1);
}

// For a stream without errors, a bound gives the last level and a warning.
TEST(LevelTopology, WarnsOfAStreamWithoutErrors)
{
  const auto carver = Carve(TwoBoxes());
  vtkNew<vtkExtractCarvedLOD> extract;
  Messages messages(extract);
  extract->SetInputData(carver->GetOutputDataObject(1));
  extract->SetLevelTargetType(vtkExtractCarvedLOD::ERROR_BOUND);
  extract->SetLevelTarget(10.0);
  extract->Update();
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_TRUE(Has(messages.Warnings[0], "ComputeError"));
  EXPECT_EQ(extract->GetOutput()->GetNumberOfPolys(), 24);
}
