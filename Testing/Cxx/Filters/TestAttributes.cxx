// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/ArrayTools.h"
#include "FilterTesting.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace
{

/** x + 2 y + 3 z, which interpolation within a triangle preserves. */
double Linear(const double p[3])
{
  return p[0] + 2.0 * p[1] + 3.0 * p[2];
}

void AddLinearPointData(vtkPolyData* mesh)
{
  vtkNew<vtkDoubleArray> linear;
  linear->SetName("Linear");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    linear->InsertNextValue(Linear(mesh->GetPoint(i)));
  }
  mesh->GetPointData()->AddArray(linear);
}

} // namespace

// Level points have the point data of the input; points of the input have exact values.
TEST(Attributes, CarriesPointData)
{
  auto input = TwoBoxes();
  AddLinearPointData(input);
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    names->InsertNextValue("point " + std::to_string(i));
  }
  input->GetPointData()->AddArray(names);
  const auto carver = Carve(input);
  for (int l = 0; l < CountLevels(carver); ++l)
  {
    vtkPolyData* level = GetLevel(carver, l);
    vtkDataArray* ids = level->GetPointData()->GetArray("vtkOriginalPointIds");
    vtkDataArray* linear = level->GetPointData()->GetArray("Linear");
    auto* levelNames =
      vtkStringArray::SafeDownCast(level->GetPointData()->GetAbstractArray("Name"));
    for (vtkIdType i = 0; i < level->GetNumberOfPoints(); ++i)
    {
      const vtkIdType source = static_cast<vtkIdType>(ids->GetTuple1(i));
      double p[3], q[3];
      level->GetPoint(i, p);
      input->GetPoint(source, q);
      EXPECT_TRUE(std::equal(p, p + 3, q));
      EXPECT_EQ(linear->GetTuple1(i), Linear(p));
      EXPECT_EQ(levelNames->GetValue(i), "point " + std::to_string(source));
    }
  }
}

// Points that resolving made have interpolated point data and the original id -1.
TEST(Attributes, InterpolatesPointDataAtNewPoints)
{
  auto input = ToPolyData(
    models::Joined(models::Sphere(1), models::Moved(models::Sphere(1), { 0.7, 0.31, 0.17 })));
  AddLinearPointData(input);
  const auto carver = Carve(input, 1);
  vtkPolyData* level = GetLevel(carver, 0);
  vtkDataArray* ids = level->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* linear = level->GetPointData()->GetArray("Linear");
  vtkIdType newPoints = 0;
  for (vtkIdType i = 0; i < level->GetNumberOfPoints(); ++i)
  {
    newPoints += ids->GetTuple1(i) < 0;
    EXPECT_NEAR(linear->GetTuple1(i), Linear(level->GetPoint(i)), 1e-9);
  }
  EXPECT_GT(newPoints, 0);
  EXPECT_EQ(GetFieldValue(level, "NewVertices"), newPoints);
}

// A face of the input has the data of its cell; a carved face has the priority and depth of the
// tetrahedron behind it.
TEST(Attributes, CarriesCellData)
{
  auto input = TwoBoxes();
  std::vector<int> parts(input->GetNumberOfCells());
  std::iota(parts.begin(), parts.end(), 100);
  AddFieldArray<vtkIntArray>(input->GetCellData(), "Part", parts);
  const auto carver = Carve(input, 2);
  for (int l = 0; l < 2; ++l)
  {
    vtkCellData* data = GetLevel(carver, l)->GetCellData();
    int carved = 0;
    for (vtkIdType i = 0; i < GetLevel(carver, l)->GetNumberOfCells(); ++i)
    {
      const double original = data->GetArray("vtkOriginalCellIds")->GetTuple1(i);
      const bool isInput = original >= 0;
      carved += !isInput;
      EXPECT_EQ(data->GetArray("Part")->GetTuple1(i), isInput ? 100 + original : 0);
      EXPECT_EQ(std::isnan(data->GetArray("Priority")->GetTuple1(i)), isInput);
      EXPECT_EQ(data->GetArray("Depth")->GetTuple1(i) == 0, isInput);
    }
    // The four sides of the gap have two triangles each until they are carved.
    EXPECT_EQ(carved, l == 0 ? 8 : 0);
  }
}

// Faces of triangulated polygons and strips have the id of their cell of the input; vertices and
// lines count, too.
TEST(Attributes, CountsCellsAsTheInputDoes)
{
  const carving::TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  auto input = ToPolyData({ box.Points, {} });
  vtkNew<vtkCellArray> verts, lines, polys, strips;
  verts->InsertNextCell({ 0 });
  lines->InsertNextCell({ 0, 7 });
  lines->InsertNextCell({ 1, 6 });
  polys->InsertNextCell({ 0, 2, 3, 1 });                    // cell 3, z = 0
  polys->InsertNextCell({ 4, 5, 7, 6 });                    // cell 4, z = 1
  strips->InsertNextCell({ 0, 4, 1, 5, 3, 7, 2, 6, 0, 4 }); // cell 5, around
  input->SetVerts(verts);
  input->SetLines(lines);
  input->SetPolys(polys);
  input->SetStrips(strips);
  const auto carver = Carve(input, 1);
  vtkPolyData* level = GetLevel(carver, 0);
  vtkDataArray* ids = level->GetCellData()->GetArray("vtkOriginalCellIds");
  int found[6] = {};
  for (vtkIdType i = 0; i < level->GetNumberOfCells(); ++i)
  {
    const int id = static_cast<int>(ids->GetTuple1(i));
    ASSERT_LT(id, 6);
    if (id >= 0)
    {
      ++found[id];
      double bounds[6];
      level->GetCellBounds(i, bounds);
      EXPECT_EQ(id == 3, bounds[5] == 0.0);
      EXPECT_EQ(id == 4, bounds[4] == 1.0);
    }
  }
  EXPECT_EQ(found[0] + found[1] + found[2], 0);
  EXPECT_EQ(found[3], 2);
  EXPECT_EQ(found[4], 2);
  EXPECT_EQ(found[5], 8);
  EXPECT_NE(carver->GetOutput()->GetFieldData()->GetAbstractArray("Notes"), nullptr);
}

// Ghost cells are ignored.
TEST(Attributes, SkipsGhostCells)
{
  auto input = TwoBoxes();
  SetGhosts(input, [](vtkIdType i) { return i < 12 ? 0 : vtkDataSetAttributes::DUPLICATECELL; });
  const auto carver = Carve(input, 1);
  EXPECT_EQ(GetLevel(carver, 0)->GetNumberOfPolys(), 12);
  EXPECT_EQ(GetLevel(carver, 0)->GetBounds()[1], 1.0);
}

// A mesh that has ghost cells alone is empty, and no error.
TEST(Attributes, TakesGhostCellsAloneForNothing)
{
  auto input = TwoBoxes();
  SetGhosts(input, [](vtkIdType) { return vtkDataSetAttributes::DUPLICATECELL; });
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(input);
  Messages messages(carver);
  carver->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_EQ(CountLevels(carver), 0);
}

// The field data of every level describe the level.
TEST(Attributes, DescribesLevels)
{
  const auto carver = Carve(TwoBoxes(), 2);
  for (int l = 0; l < 2; ++l)
  {
    vtkPolyData* level = GetLevel(carver, l);
    EXPECT_EQ(GetFieldValue(level, "Vertices"), level->GetNumberOfPoints());
    EXPECT_EQ(GetFieldValue(level, "Triangles"), level->GetNumberOfPolys());
    EXPECT_EQ(GetFieldValue(level, "NewVertices"), 0);
    EXPECT_EQ(GetFieldText(level, "Kind"), "carved");
    EXPECT_NE(GetFieldText(level, "Strategy"), "");
  }
  EXPECT_TRUE(std::isinf(GetFieldValue(GetLevel(carver, 0), "FeatureSize")));
  // The longest edge of each tetrahedron in the gap is at least a diagonal of a side, at most of
  // the gap.
  const double size = GetFieldValue(GetLevel(carver, 1), "FeatureSize");
  EXPECT_GE(size, std::sqrt(2.0));
  EXPECT_LE(size, std::sqrt(3.0));
}
