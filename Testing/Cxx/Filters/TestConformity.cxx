// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/ArrayTools.h"
#include "Core/Mesh/Box.h"
#include "FilterTesting.h"

#include "RandomModels.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkTriangle.h"

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
  AddFieldArray<vtkIntArray>(data->GetCellData(), "Color", std::vector<int>{ 7, 8, 9 });
  return data;
}

/** Adds point data that are linear in space. */
void AddHeights(const carving::TriangleMesh& mesh, vtkPolyData* data)
{
  std::vector<double> heights;
  for (const carving::Point& p : mesh.Points)
  {
    heights.push_back(p[2]);
  }
  AddFieldArray<vtkDoubleArray>(data->GetPointData(), "Height", heights);
}

} // namespace

// The field data of streams and levels name the strategy as the documentation does.
TEST(Conformity, IsSaidInTheFieldData)
{
  const auto carver = Carve(Crossing());
  const auto expectStrategy = [&](const char* expected)
  {
    EXPECT_EQ(GetFieldText(carver->GetOutputDataObject(1), "Strategy"), expected);
    for (int i = 0; i < CountLevels(carver); ++i)
    {
      EXPECT_EQ(GetFieldText(GetLevel(carver, i), "Strategy"), expected);
    }
  };
  expectStrategy("TetGen -pcY");
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->Update();
  expectStrategy("Delaunay, enclosing");
}

// In enclosing mode without tolerance, no vertex is new, and a stored stream gives the same levels.
TEST(Conformity, EnclosingKeepsVerticesAndStreams)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->SetEnclosingTolerance(0.0);
  carver->SetSolidRule(vtkTopologyCarver::SURFACE_ONLY);
  Carve(carver, Crossing());
  ASSERT_GT(CountLevels(carver), 1);
  for (int i = 0; i < CountLevels(carver); ++i)
  {
    EXPECT_EQ(GetFieldValue(GetLevel(carver, i), "NewVertices"), 0);
  }
  ExpectSameLevelsFromStream(carver);
}

// Vertices that snapping moved keep their ids, are new, and have the distance; on levels of the
// stored stream, too.
TEST(Conformity, SnappedVerticesAreSaidToBeNew)
{
  std::mt19937_64 random(3);
  auto input = ToPolyData(models::Doubled(models::Sphere(1), 1e-13, random));
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(input);
  carver->SetConformity(vtkTopologyCarver::EXACT);
  carver->SetSnapTolerance(0.0);
  {
    Messages messages(carver);
    carver->Update();
    messages.TakeError(); // a change of these properties runs the helper program again
  }
  carver->SetSnapTolerance(2e-13); // too little to join all that should touch
  carver->Update();
  vtkPolyData* level = LastLevel(carver);
  ASSERT_TRUE(level);
  EXPECT_EQ(GetFieldText(level, "Strategy").find("TetGen -pcY, snapped"), 0u);
  const double farthest = GetFieldValue(level, "SnapDistance");
  EXPECT_GT(farthest, 0.0);
  EXPECT_TRUE(Has(GetNotes(carver), "An attempt failed."));
  EXPECT_TRUE(Has(GetNotes(carver), "The mesh was snapped"));
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
  EXPECT_EQ(GetFieldValue(level, "NewVertices"), moved);
  ExpectSameLevelsFromStream(carver);
}

// By default, a surface that is there twice, but for roundings, is met as one.
TEST(Conformity, RemovesRoundingsByDefault)
{
  std::mt19937_64 random(1);
  const carving::TriangleMesh sphere = models::Sphere(1);
  vtkNew<vtkTopologyCarver> carver;
  Carve(carver, ToPolyData(models::Doubled(sphere, 1e-13, random)));
  vtkPolyData* level = LastLevel(carver);
  ASSERT_TRUE(level);
  EXPECT_EQ(GetFieldText(level, "Strategy").find("TetGen -pcY, snapped"), 0u);
  EXPECT_LT(GetFieldValue(level, "SnapDistance"), 1e-12 * carving::Diagonal(sphere.Points));
  EXPECT_EQ(level->GetNumberOfPoints(), static_cast<vtkIdType>(sphere.Points.size()));
  EXPECT_EQ(level->GetNumberOfCells(), static_cast<vtkIdType>(sphere.Triangles.size()));
  carver->SetSnapTolerance(0.0);
  carver->Update();
  EXPECT_EQ(GetFieldText(LastLevel(carver), "Strategy"), "Delaunay, enclosing");
}

// If all attempts fail, a note describes each of them, including snapping.
TEST(Conformity, NotesEveryAttempt)
{
  std::mt19937_64 random(1);
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ToPolyData(models::Doubled(models::Sphere(1), 1e-13, random)));
  carver->SetSnapTolerance(1e-30); // smaller than the spacing of doubles near 1
  carver->Update();
  EXPECT_EQ(GetFieldText(GetLevel(carver, 0), "Strategy"), "Delaunay, enclosing");
  EXPECT_TRUE(Has(GetNotes(carver), "An attempt failed. Snapping on a grid of"));
}

// ENCLOSING meets a mesh without crossings as a whole, and no note calls it only enclosed.
TEST(Conformity, EnclosingMeetsACleanMesh)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  const auto torus = ToPolyData(models::Torus(1.0, 0.4, 12, 8));
  Carve(carver, torus);
  EXPECT_EQ(GetFieldValue(LastLevel(carver), "MetShare"), 1.0);
  EXPECT_EQ(GetFieldValue(LastLevel(carver), "KeptDistance"), 0.0);
  EXPECT_EQ(LastLevel(carver)->GetNumberOfPolys(), torus->GetNumberOfPolys());
  EXPECT_FALSE(Has(GetNotes(carver), "The mesh is only enclosed"));
}

// A note says that a mesh is only enclosed if its triangles are covered by faces with other edges.
TEST(Conformity, NotesCoveredTriangles)
{
  carving::TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  const auto first = static_cast<int>(box.Points.size());
  box.Points.insert(box.Points.end(), { { 0.2, 0.3, 1 }, { 0.8, 0.4, 1 }, { 0.4, 0.8, 1 } });
  box.Triangles.push_back({ first, first + 1, first + 2 });
  vtkNew<vtkTopologyCarver> carver;
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->SetEnclosingTolerance(0.0);
  Carve(carver, ToPolyData(box));
  EXPECT_LT(GetFieldValue(LastLevel(carver), "MetShare"), 1.0);
  EXPECT_TRUE(Has(GetNotes(carver), "The mesh is only enclosed"));
}

// With AppendInput, a mesh that is only enclosed follows as given, with its data.
TEST(Conformity, AppendsTheInputOnRequest)
{
  vtkNew<vtkTopologyCarver> carver;
  auto input = Crossing();
  carver->AppendInputOn();
  Carve(carver, input);
  EXPECT_EQ(GetFieldText(LastLevel(carver), "Kind"), "carved");
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->SetEnclosingTolerance(0.0); // no vertices at the crossing, which is not met then
  carver->Update();
  const int last = CountLevels(carver) - 1;
  vtkPolyData* level = GetLevel(carver, last);
  EXPECT_EQ(GetFieldText(level, "Kind"), "input");
  EXPECT_EQ(GetFieldText(GetLevel(carver, last - 1), "Kind"), "carved");
  EXPECT_EQ(GetTriangles(level), GetTriangles(input));
  EXPECT_TRUE(Has(GetNotes(carver), "The mesh is only enclosed"));
  for (vtkIdType i = 0; i < level->GetNumberOfCells(); ++i)
  {
    const double cell = level->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(i);
    EXPECT_EQ(level->GetCellData()->GetArray("Color")->GetTuple1(i), 7 + cell);
    EXPECT_TRUE(std::isnan(level->GetCellData()->GetArray("Priority")->GetTuple1(i)));
  }
}

// The appended input has interpolated data at the points that were made where it crosses itself.
TEST(Conformity, AppendsTheResolvedInputWithItsPointData)
{
  const carving::TriangleMesh torus = models::Torus(1.0, 0.4, 40, 24);
  const carving::TriangleMesh mesh = models::Joined(torus, models::Moved(torus, { 1.2, 0.1, 0.2 }));
  vtkSmartPointer<vtkPolyData> input = ToPolyData(mesh);
  AddHeights(mesh, input);
  vtkNew<vtkTopologyCarver> carver;
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->AppendInputOn();
  Carve(carver, input);
  vtkPolyData* level = LastLevel(carver);
  ASSERT_EQ(GetFieldText(level, "Kind"), "input");
  const vtkIdType made = level->GetNumberOfPoints() - input->GetNumberOfPoints();
  ASSERT_GT(made, 0);
  EXPECT_EQ(GetFieldValue(level, "NewVertices"), made);
  vtkDataArray* heights = level->GetPointData()->GetArray("Height");
  ASSERT_TRUE(heights);
  for (vtkIdType i = 0; i < level->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(heights->GetTuple1(i), level->GetPoint(i)[2], 1e-12);
  }
}

// The appended input says how much of each triangle is met, which adds up to the share of the mesh.
TEST(Conformity, TellsWhichTrianglesAreMet)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->SetEnclosingTolerance(0.0); // no vertices at the crossing, which is not met then
  carver->AppendInputOn();
  Carve(carver, Crossing());
  vtkPolyData* level = LastLevel(carver);
  vtkDataArray* shares = level->GetCellData()->GetArray("MetShare");
  ASSERT_TRUE(shares);
  double met = 0.0, all = 0.0;
  for (vtkIdType i = 0; i < level->GetNumberOfCells(); ++i)
  {
    const double share = shares->GetTuple1(i);
    EXPECT_TRUE(share >= 0.0 && share <= 1.0) << share;
    const double area = vtkTriangle::SafeDownCast(level->GetCell(i))->ComputeArea();
    met += share * area;
    all += area;
  }
  EXPECT_NEAR(met / all, GetFieldValue(level, "MetShare"), 1e-9);
  EXPECT_LT(shares->GetRange()[0], 1.0); // at the crossing
  EXPECT_FALSE(GetLevel(carver, 0)->GetCellData()->HasArray("MetShare"));
}

// A change of the solid rule runs the helper program again only if triangles inside the solid may
// have been left out.
TEST(Conformity, RunsAgainForAnotherSolidOnlyWhereThatMatters)
{
  std::mt19937_64 random(2);
  for (const bool matters : { false, true })
  {
    const auto carver = Carve(matters ? ToPolyData(models::Assembly(12, random)) : TwoBoxes());
    ASSERT_GT(CountLevels(carver), 0);
    EXPECT_EQ(GetFieldText(GetLevel(carver, 0), "Strategy"),
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
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  Carve(carver, TwoBoxes());
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
