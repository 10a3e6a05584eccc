// SPDX-License-Identifier: BSD-3-Clause
// The inputs that vtkContourCarver accepts and rejects.
#include "ContourTesting.h"

#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

Loop Mapped(const Loop& loop, const carving::Point& u, const carving::Point& v)
{
  Loop result;
  for (const carving::Point& p : loop)
  {
    carving::Point& q = result.emplace_back();
    for (int i = 0; i < 3; ++i)
    {
      q[i] = 1.0 + p[0] * u[i] + p[1] * v[i];
    }
  }
  return result;
}

} // namespace

// In any plane, the first and last levels are those of the plane z = 0, with the vertices of the
// input.
TEST(ContourInput, WorksInAnyPlane)
{
  const carving::Point directions[][2] = { { { 0, 1, 0 }, { 0, 0, 1 } }, // facing x
    { { 0, 0, 1 }, { 1, 0, 0 } },                                        // facing y
    { { 0.8, 0.1, -0.3 }, { 0.1, 0.7, 0.35 } } };
  const Loop letterL = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 },
    { 0, 2, 0 } };
  const Loop hull = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 } };
  const Loop hole = Reversed(Rectangle(0.2, 0.3, 0.6, 0.7));
  for (const auto& [u, v] : directions)
  {
    auto input = MakePolygons({ Mapped(letterL, u, v), Mapped(hole, u, v) });
    const auto carver = Carve<vtkContourCarver>(input);
    EXPECT_EQ(Edges(GetLevel(carver, 0)), Edges(MakePolygons({ Mapped(hull, u, v) })));
    EXPECT_EQ(Edges(LastLevel(carver)), Edges(input));
  }
}

// BOUNDING_BOX: the first level is a rectangle of new vertices, a hundredth of the diagonal away.
TEST(ContourInput, StartsFromABox)
{
  vtkNew<vtkContourCarver> carver;
  carver->SetInitialApproximation(vtkContourCarver::BOUNDING_BOX);
  auto input = MakePolygons({ Rectangle(0, 0, 3, 4) });
  Carve(carver, input);
  double bounds[6];
  GetLevel(carver, 0)->GetBounds(bounds);
  EXPECT_EQ(GetLevel(carver, 0)->GetNumberOfLines(), 4);
  EXPECT_EQ(GetFieldValue(GetLevel(carver, 0), "NewVertices"), 4);
  const double expected[] = { -0.05, 3.05, -0.05, 4.05, 0.0, 0.0 };
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(bounds[i], expected[i], 1e-12);
  }
  EXPECT_EQ(Edges(LastLevel(carver)), Edges(input));
}

// CUSTOM: the given contour is the first level, and may touch the input.
TEST(ContourInput, StartsFromAGivenContour)
{
  vtkNew<vtkContourCarver> carver;
  carver->SetInitialApproximation(vtkContourCarver::CUSTOM);
  // Not convex, clockwise, and touching the input at (0, 0).
  auto initial =
    MakePolygons({ Reversed({ { 0, 0, 0 }, { 9, -1, 0 }, { 3, 3, 0 }, { -1, 9, 0 } }) });
  auto input = MakePolygons({ Rectangle(0, 0, 2, 2) });
  carver->SetInputData(1, initial);
  Carve(carver, input);
  EXPECT_EQ(Edges(GetLevel(carver, 0)),
    Edges(MakePolygons({ { { 0, 0, 0 }, { 9, -1, 0 }, { 3, 3, 0 }, { -1, 9, 0 } } })));
  EXPECT_EQ(GetFieldValue(GetLevel(carver, 0), "NewVertices"), 3);
  EXPECT_EQ(Edges(LastLevel(carver)), Edges(input));
}

// An unsuitable contour for CUSTOM is an error that names the missing condition.
TEST(ContourInput, NamesWhatAGivenContourLacks)
{
  const auto square = Rectangle(-9, -9, 9, 9);
  const std::pair<vtkSmartPointer<vtkPolyData>, const char*> cases[] = {
    { Polylines({ square }), "is not closed" },
    { MakePolygons({ square, Rectangle(20, 20, 30, 30) }), "is in 2 pieces" },
    { MakePolygons({ { { -9, -9, 0 }, { 9, 9, 0 }, { 9, -9, 0 }, { -9, 9, 0 } } }),
      "crosses or touches itself at (0, 0)" },
    { MakePolygons({ Rectangle(0.5, 0.5, 9, 9) }), "does not contain the input" },
    { MakePolygons({ Rectangle(5, 5, 9, 9) }), "does not contain the input" },
    { MakePolygons({ Rectangle(0, 0, 0, 0) }), "has no edge" },
    { MakePolygons({ { { -9, -9, 1 }, { 9, -9, 1 }, { 0, 9, 1 } } }), "plane of the input" },
  };
  for (const auto& [initial, expected] : cases)
  {
    vtkNew<vtkContourCarver> carver;
    carver->SetInitialApproximation(vtkContourCarver::CUSTOM);
    carver->SetInputData(1, initial);
    const std::string error = CarveWithError(carver, MakePolygons({ Rectangle(0, 0, 1, 1) }));
    EXPECT_TRUE(Has(error, "The initial approximation on port 1"));
    EXPECT_TRUE(Has(error, expected));
  }
}

// A point off the plane is an error that names the point and its distance.
TEST(ContourInput, NamesAPointOffThePlane)
{
  vtkNew<vtkContourCarver> carver;
  const auto input = MakePolygons({ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0.1 }, { 0, 1, 0 } } });
  // The distance from the plane of the three other points: 0.1 / sqrt(1.01).
  EXPECT_TRUE(Has(CarveWithError(carver, input), "Point 3 is 0.0995037 away"));
}

// Contours on one line and infinite points are errors; edges without length are empty input.
TEST(ContourInput, RejectsALineAPointAndInfinity)
{
  vtkNew<vtkContourCarver> carver;
  EXPECT_TRUE(Has(CarveWithError(carver, Polylines({ { { 0, 0, 0 }, { 1, 1, 0 }, { 3, 3, 0 } } })),
    "All points lie on one line"));
  EXPECT_TRUE(
    Has(CarveWithError(carver, Polylines({ { { 0, 0, 0 }, { 1, HUGE_VAL, 0 }, { 3, 3, 0 } } })),
      "Point 1 is (1, inf, 0)"));
  EXPECT_TRUE(Has(CarveWithError(carver, Polylines({ { { 1, 2, 3 }, { 1, 2, 3 } } })),
    "No edge of the contours has a length"));
}

// Vertices and strips are ignored with a note, ghost cells without.
TEST(ContourInput, PassesOverWhatIsNoContour)
{
  auto input = MakePolygons({ LetterU(), Rectangle(7, 7, 8, 8) });
  vtkNew<vtkCellArray> verts, strips;
  verts->InsertNextCell({ 0 });
  input->SetVerts(verts);
  strips->InsertNextCell({ 0, 1, 2, 3 });
  input->SetStrips(strips);
  SetGhosts(input, [](vtkIdType i) { return i == 2 ? vtkDataSetAttributes::DUPLICATECELL : 0; });
  const auto carver = Carve<vtkContourCarver>(input);
  EXPECT_EQ(Edges(LastLevel(carver)), Edges(MakePolygons({ LetterU() })));
  EXPECT_TRUE(Has(GetNotes(carver), "2 cells were ignored"));
}
