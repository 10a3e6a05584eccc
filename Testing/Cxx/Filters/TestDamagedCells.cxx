// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Streams with damaged cells and points: each is refused with a single error that names the damage.
 */
#include "FilterTesting.h"
#include "StreamTesting.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <limits>

// A cell with a corner that does not exist is named.
TEST(DamagedCells, AreRefusedForCornersThatAreNoPoints)
{
  for (const double corner : { -1.0, 1e6, 9e18 })
  {
    const auto stream = MakeStream();
    stream->GetCells()->GetConnectivityArray()->SetTuple1(5, corner);
    ExpectError(stream, "cell 1 has the point ");
  }
}

// A cell with too few or too many corners is named, whatever its type.
TEST(DamagedCells, AreRefusedForCellsOfOtherCorners)
{
  for (const int type : { VTK_TETRA, VTK_TRIANGLE, VTK_LINE })
  {
    for (const int corners : { 0, 1, 5, 50 })
    {
      const auto stream = MakeStream(type == VTK_LINE);
      vtkNew<vtkUnsignedCharArray> types;
      types->DeepCopy(stream->GetCellTypesArray());
      types->InsertNextValue(static_cast<unsigned char>(type));
      vtkNew<vtkCellArray> cells;
      cells->DeepCopy(stream->GetCells());
      cells->InsertNextCell(corners);
      for (int i = 0; i < corners; ++i)
      {
        cells->InsertCellPoint(i % 4);
      }
      stream->SetCells(types, cells);
      for (int i = 0; i < stream->GetCellData()->GetNumberOfArrays(); ++i)
      {
        stream->GetCellData()->GetAbstractArray(i)->InsertNextTuple(
          cells->GetNumberOfCells() - 2, stream->GetCellData()->GetAbstractArray(i));
      }
      ExpectError(stream, "cell " + std::to_string(cells->GetNumberOfCells() - 1) + " is ");
    }
  }
}

// Types, offsets and corners of cells that contradict each other are refused before they are used.
TEST(DamagedCells, AreRefusedForArraysOfCellsThatContradictEachOther)
{
  const char* text = "the types, offsets and corners of its cells contradict each other";
  const auto fewTypes = MakeStream();
  fewTypes->GetCellTypesArray()->SetNumberOfTuples(3);
  ExpectError(fewTypes, text);
  for (const double offset : { -4.0, 1e6, 9e18 })
  {
    const auto offsets = MakeStream();
    offsets->GetCells()->GetOffsetsArray()->SetTuple1(2, offset);
    ExpectError(offsets, text);
  }
  const auto fewCorners = MakeStream();
  fewCorners->GetCells()->GetConnectivityArray()->SetNumberOfTuples(10);
  ExpectError(fewCorners, text);
}

// A grid without points, or with points that are not finite, is refused.
TEST(DamagedCells, AreRefusedForTheirPoints)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double value : { std::numeric_limits<double>::quiet_NaN(), infinity, -infinity })
  {
    const auto stream = MakeStream();
    stream->GetPoints()->SetPoint(3, 0.0, value, 0.0);
    ExpectError(stream, "the coordinates of point 3 are not finite");
  }
  const auto pointless = MakeStream();
  pointless->SetPoints(nullptr);
  pointless->GetPointData()->Initialize();
  ExpectError(pointless, "there are 0 points");
}

// A tetrahedron with a repeated corner, or the third one at a face, is refused.
TEST(DamagedCells, AreRefusedForCellsThatDoNotFit)
{
  const auto twice = MakeStream();
  vtkDataArray* corners = twice->GetCells()->GetConnectivityArray();
  corners->SetTuple1(0, corners->GetTuple1(1));
  ExpectError(twice, "its cells do not fit together");
  const auto three = MakeStream();
  corners = three->GetCells()->GetConnectivityArray();
  for (int i = 4; i < 12; ++i)
  {
    corners->SetTuple1(i, corners->GetTuple1(i % 4));
  }
  ExpectError(three, "its cells do not fit together");
}

// A foreign tetrahedron is refused; the stream of a convex mesh, which has triangles only, is
// accepted.
TEST(DamagedCells, MayHaveNoCellsOfTheComplement)
{
  vtkNew<vtkUnstructuredGrid> foreign;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(i == 1, i == 2, i == 3);
  }
  foreign->SetPoints(points);
  const vtkIdType tetrahedron[] = { 0, 1, 2, 3 };
  foreign->InsertNextCell(VTK_TETRA, 4, tetrahedron);
  ExpectError(foreign, "is missing");
  const auto carver = Carve(ToPolyData(models::Tetrahedron()));
  vtkNew<vtkUnstructuredGrid> convex;
  convex->DeepCopy(carver->GetOutputDataObject(1));
  EXPECT_EQ(convex->GetNumberOfCells(), 4);
  EXPECT_EQ(ErrorOf(convex), "");
}
