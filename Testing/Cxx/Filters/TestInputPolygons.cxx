// SPDX-License-Identifier: BSD-3-Clause
#include "InputTesting.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using carving::Point;

namespace
{

/** Polygons that share no points. */
struct SeparatePolygons
{
  std::vector<Point> Points;
  Polygons Cells;

  void Begin()
  {
    this->Cells.emplace_back();
  }

  void Add(const Point& corner)
  {
    this->Cells.back().push_back(static_cast<vtkIdType>(this->Points.size()));
    this->Points.push_back(corner);
  }

  vtkSmartPointer<vtkPolyData> Make() const
  {
    return MakeMesh(this->Points, this->Cells);
  }
};

vtkSmartPointer<vtkPolyData> TriangulateByVtk(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(mesh);
  triangulate->Update();
  return triangulate->GetOutput();
}

} // namespace

// Polygons may have corners within straight sides, also as the first corner.
TEST(InputPolygons, MayHaveCollinearPoints)
{
  // A cube of side 2 with a point in the middle of every edge.
  std::vector<Point> points;
  Polygons polygons;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      const int around[8][2] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 2, 2 }, { 1, 2 },
        { 0, 2 }, { 0, 1 } };
      std::vector<vtkIdType> polygon;
      for (const auto& [u, v] : around)
      {
        Point p;
        p[axis] = 2.0 * side;
        p[(axis + 1) % 3] = side ? u : v;
        p[(axis + 2) % 3] = side ? v : u;
        polygon.push_back(static_cast<vtkIdType>(points.size()));
        points.push_back(p);
      }
      std::rotate(polygon.begin(), polygon.begin() + 3 * axis + side, polygon.end());
      polygons.push_back(polygon);
    }
  }
  const auto carver = Carve(MakeMesh(points, polygons));
  EXPECT_EQ(GetNotes(carver),
    "The input is its own initial approximation: there is nothing to "
    "carve.\n");
  EXPECT_EQ(GetLevel(carver, 0)->GetNumberOfPolys(), 36);
  EXPECT_DOUBLE_EQ(GetVolume(GetLevel(carver, 0)), 8.0);
}

// A polygon whose boundary follows a cut to a hole and back has that hole.
TEST(InputPolygons, MayHaveHoles)
{
  std::vector<Point> points;
  for (const double z : { 0.0, 1.0 })
  {
    for (const auto& [x, y] :
      { std::pair(0, 0), { 4, 0 }, { 4, 4 }, { 0, 4 }, { 1, 1 }, { 1, 3 }, { 3, 3 }, { 3, 1 } })
    {
      points.push_back({ double(x), double(y), z });
    }
  }
  Polygons polygons = { { 4, 7, 6, 5, 4, 0, 3, 2, 1, 0 }, { 8, 9, 10, 11, 8, 12, 13, 14, 15, 12 } };
  for (const vtkIdType first : { 0, 4 })
  {
    for (vtkIdType i = 0; i < 4; ++i)
    {
      const vtkIdType a = first + i, b = first + (i + 1) % 4;
      polygons.push_back({ a, b, b + 8, a + 8 });
    }
  }
  const auto carver = Carve(MakeMesh(points, polygons));
  EXPECT_DOUBLE_EQ(GetVolume(GetLevel(carver, 0)), 16.0);
  EXPECT_DOUBLE_EQ(GetVolume(LastLevel(carver)), 12.0);
}

// A polygon with repeated corners, or equal consecutive points, equals the polygon without them.
TEST(InputPolygons, MayHaveRepeatedCorners)
{
  auto boxes = TwoBoxes();
  std::vector<Point> points;
  Polygons polygons;
  for (vtkIdType cell = 0; cell < boxes->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    boxes->GetCellPoints(cell, ids);
    std::vector<vtkIdType> polygon;
    for (int corner = 0; corner < 3; ++corner)
    {
      Point p;
      boxes->GetPoint(ids->GetId(corner), p.data());
      points.push_back(p);
      polygon.push_back(static_cast<vtkIdType>(points.size()) - 1);
      if ((cell + corner) % 3 == 0)
      {
        polygon.push_back(polygon.back());
      }
      else if ((cell + corner) % 3 == 1)
      {
        points.push_back(p);
        polygon.push_back(static_cast<vtkIdType>(points.size()) - 1);
      }
    }
    polygons.push_back(polygon);
  }
  const auto carver = Carve(MakeMesh(points, polygons));
  EXPECT_EQ(GetNotes(carver), "");
  EXPECT_EQ(GetTriangles(LastLevel(carver)), GetTriangles(boxes));
}

// A polygon that crosses itself is kept: its corners are enclosed, and a note counts it.
TEST(InputPolygons, MayCrossThemselves)
{
  vtkSmartPointer<vtkPolyData> mesh = QuadBoxes();
  const vtkIdType first = mesh->GetNumberOfPoints();
  for (const Point& p :
    { Point{ 1.25, 0.25, 2 }, { 1.75, 0.75, 2 }, { 1.75, 0.25, 2 }, { 1.25, 0.75, 2 } })
  {
    mesh->GetPoints()->InsertNextPoint(p.data());
  }
  mesh->GetPolys()->InsertNextCell({ first, first + 1, first + 2, first + 3 });
  const auto carver = Carve(mesh);
  EXPECT_TRUE(Has(GetNotes(carver), "1 polygons cross themselves"));
  for (int i = 0; i < CountLevels(carver); ++i)
  {
    EXPECT_EQ(GetLevel(carver, i)->GetBounds()[5], 2.0);
  }
}

// The last level contains all that vtkTriangleFilter makes of random polygons, most of which cross
// themselves. Every other polygon is not flat.
TEST(InputPolygons, AreKeptAsVtkSeesThem)
{
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  SeparatePolygons polygons;
  for (int i = 0; i < 60; ++i)
  {
    polygons.Begin();
    const int size = 4 + i % 5;
    for (int corner = 0; corner < size; ++corner)
    {
      const double height = i % 2 * 0.1 * uniform(random);
      polygons.Add({ uniform(random), uniform(random), 0.25 * i + height });
    }
  }
  const vtkSmartPointer<vtkPolyData> mesh = polygons.Make();
  const vtkSmartPointer<vtkPolyData> triangles = TriangulateByVtk(mesh);
  vtkNew<vtkStaticCellLocator> locator;
  const auto carver = Carve(mesh);
  locator->SetDataSet(LastLevel(carver));
  locator->BuildLocator();
  ASSERT_GT(triangles->GetNumberOfCells(), 60);
  for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i)
  {
    double corners[3][3], closest[3], distance = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      triangles->GetPoint(triangles->GetCell(i)->GetPointId(k), corners[k]);
    }
    for (int sample = 0; sample < 10; ++sample)
    {
      const double u = uniform(random), v = (1.0 - u) * uniform(random);
      double p[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        p[axis] = (1.0 - u - v) * corners[0][axis] + u * corners[1][axis] + v * corners[2][axis];
      }
      vtkIdType cell;
      int part;
      locator->FindClosestPoint(p, closest, cell, part, distance);
      EXPECT_LT(distance, 1e-18) << "squared, polygon at " << p[2];
    }
  }
}

// Polygons that are not quite flat, with corners within their sides, become the triangles that
// vtkTriangleFilter makes of them.
TEST(InputPolygons, MayNotBeFlat)
{
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  SeparatePolygons polygons;
  for (int i = 0; i < 40; ++i)
  {
    polygons.Begin();
    const int inSide = 1 + i % 3; // corners within each side of a square
    for (int corner = 0; corner < 4 * (inSide + 1); ++corner)
    {
      const int side = corner / (inSide + 1);
      const double along = corner % (inSide + 1) / (inSide + 1.0);
      const double u = side % 2 ? 1.0 : along, v = side % 2 ? along : 0.0;
      polygons.Add({ side < 2 ? u : 1.0 - u, side < 2 ? v : 1.0 - v, i + 1e-3 * uniform(random) });
    }
  }
  const vtkSmartPointer<vtkPolyData> mesh = polygons.Make();
  const auto carver = Carve(mesh);
  EXPECT_EQ(GetNotes(carver), "");
  EXPECT_EQ(GetTriangles(LastLevel(carver)), GetTriangles(TriangulateByVtk(mesh)));
}

// A polygon that bends inward keeps its shape, although its corners are off a plane by roundings.
TEST(InputPolygons, MayBendInward)
{
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  SeparatePolygons polygons;
  double area = 0.0;
  constexpr int stairs = 300;
  for (int i = 0; i < stairs; ++i)
  {
    polygons.Begin();
    const auto add = [&](double x, double y) {
      polygons.Add({ x, y, 2.0 * i + 1e-6 * uniform(random) });
    };
    double x = 0.0, y = 0.0;
    for (int step = 0; step < 5; ++step)
    {
      const double wide = 0.1 + uniform(random), high = 0.1 + uniform(random);
      add(x, y);
      add(x + wide, y);
      x += wide;
      y += high;
      area += x * high;
    }
    add(x, y);
    add(0.0, y);
  }
  const auto carver = Carve(polygons.Make());
  EXPECT_EQ(GetNotes(carver), "");
  vtkNew<vtkMassProperties> properties;
  properties->SetInputData(LastLevel(carver));
  EXPECT_NEAR(properties->GetSurfaceArea(), area, 1e-6 * area);
}

// Strips keep their orientation, and may turn by repeated corners.
TEST(InputPolygons, MayBeStripsWithRepeatedCorners)
{
  const carving::TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  auto input = ToPolyData({ box.Points, {} });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 4, 1, 5, 3, 7, 2, 6, 0, 4 }); // around
  strips->InsertNextCell(
    { 0, 1, 2, 3, 3, 3, 4, 4, 5, 6, 7 }); // the bottom and, by triangles without area, the top
  input->SetStrips(strips);
  EXPECT_DOUBLE_EQ(std::abs(GetVolume(LastLevel(Carve(input)))), 1.0);
}

// Cells with fewer than three corners are ignored.
TEST(InputPolygons, MayHaveTooFewCorners)
{
  vtkSmartPointer<vtkPolyData> mesh = QuadBoxes();
  const auto expected = GetTriangles(LastLevel(Carve(mesh)));
  mesh->GetPolys()->InsertNextCell(0);
  mesh->GetPolys()->InsertNextCell({ 3 });
  mesh->GetPolys()->InsertNextCell({ 3, 12 });
  EXPECT_EQ(GetTriangles(LastLevel(Carve(mesh))), expected);
}

// Equal triangles of the same orientation count once; opposite ones make a fold, or join two
// solids.
TEST(InputPolygons, MayCoincide)
{
  const auto boxes =
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 1, 0, 0 }, { 2, 1, 1 }));
  const auto glued = Carve(ToPolyData(models::Joined(boxes, boxes)));
  EXPECT_DOUBLE_EQ(GetVolume(LastLevel(glued)), 2.0);
  EXPECT_EQ(LastLevel(glued)->GetNumberOfPolys(), 20);

  const auto sheet = models::Moved(models::Sheet(2), { 0, 0, 3 });
  const auto leaf = models::Joined(models::Joined(sheet, models::Flipped(sheet)), sheet);
  const auto carver =
    Carve(ToPolyData(models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), leaf)));
  EXPECT_EQ(LastLevel(carver)->GetNumberOfPolys(), 12 + 8);
}
