// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace
{

/**
 * The number of triangles of a level by the documentation of the stream: the triangles of M with a
 * step up to the level's, and the other faces of remaining tetrahedra that have the exterior on
 * their other side.
 */
vtkIdType CountTriangles(vtkUnstructuredGrid* stream, int level)
{
  vtkDataArray* steps = stream->GetCellData()->GetArray("Step");
  std::map<std::array<vtkIdType, 3>, int> tetrahedraLeft;
  vtkIdType count = 0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < stream->GetNumberOfCells(); ++cell)
  {
    stream->GetCellPoints(cell, corners);
    const double step = steps->GetTuple1(cell);
    std::sort(corners->begin(), corners->end());
    if (stream->GetCellType(cell) == VTK_TETRA && step > level)
    {
      for (int i = 0; i < 4; ++i)
      {
        std::array<vtkIdType, 3> face;
        std::copy_if(corners->begin(), corners->end(), face.begin(),
          [&](vtkIdType corner) { return corner != corners->GetId(i); });
        ++tetrahedraLeft[face];
      }
    }
  }
  for (vtkIdType cell = 0; cell < stream->GetNumberOfCells(); ++cell)
  {
    if (stream->GetCellType(cell) == VTK_TRIANGLE)
    {
      stream->GetCellPoints(cell, corners);
      std::sort(corners->begin(), corners->end());
      tetrahedraLeft.erase({ corners->GetId(0), corners->GetId(1), corners->GetId(2) });
      const double step = steps->GetTuple1(cell);
      count += step >= 0 && step <= level;
    }
  }
  return count +
    std::count_if(tetrahedraLeft.begin(), tetrahedraLeft.end(),
      [](const auto& face) { return face.second == 1; });
}

} // namespace

// The stream has the tetrahedra of the complement and the triangles of M, and their steps give the
// size of any level.
TEST(StreamOutput, WritesTheStream)
{
  auto input = ReadReal("elephant.off");
  const auto carver = Carve(input);
  vtkUnstructuredGrid* stream = GetStream(carver);
  ASSERT_NE(stream, nullptr);
  vtkDataArray* steps = stream->GetCellData()->GetArray("Step");
  vtkDataArray* priorities = stream->GetCellData()->GetArray("Priority");
  vtkDataArray* depths = stream->GetCellData()->GetArray("Depth");
  vtkDataArray* regions = stream->GetCellData()->GetArray("Region");
  vtkIdType tetrahedra = 0, triangles = 0, onHull = 0;
  for (vtkIdType i = 0; i < stream->GetNumberOfCells(); ++i)
  {
    if (stream->GetCellType(i) == VTK_TETRA)
    {
      ++tetrahedra;
      EXPECT_GE(steps->GetTuple1(i), 1);
      EXPECT_GT(priorities->GetTuple1(i), 0.0);
      EXPECT_GE(depths->GetTuple1(i), 1);
      EXPECT_GE(regions->GetTuple1(i), 0);
    }
    else
    {
      ASSERT_EQ(stream->GetCellType(i), VTK_TRIANGLE);
      ++triangles;
      onHull += steps->GetTuple1(i) == 0;
      EXPECT_TRUE(std::isnan(priorities->GetTuple1(i)));
      EXPECT_EQ(regions->GetTuple1(i), -1);
    }
  }
  EXPECT_GT(tetrahedra, 0);
  EXPECT_EQ(triangles, input->GetNumberOfPolys());
  vtkDataArray* original = GetLevel(carver, 0)->GetCellData()->GetArray("vtkOriginalCellIds");
  vtkIdType inputFacesOnHull = 0;
  for (vtkIdType i = 0; i < original->GetNumberOfTuples(); ++i)
  {
    inputFacesOnHull += original->GetTuple1(i) >= 0;
  }
  EXPECT_EQ(onHull, inputFacesOnHull);
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_EQ(
      CountTriangles(stream, GetLevelStep(carver, i)), GetLevel(carver, i)->GetNumberOfPolys());
  }
}

// The profile has a row per step with the counts of the level before it is cut into manifolds.
TEST(StreamOutput, WritesTheProfile)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->ManifoldOutputOff();
  Carve(carver, ReadReal("elephant.off"));
  ASSERT_TRUE(GetProfile(carver));
  for (int i = 0; i < 8; ++i)
  {
    const int step = GetLevelStep(carver, i);
    EXPECT_EQ(GetProfileValue(carver, step, "Step"), step);
    EXPECT_EQ(GetProfileValue(carver, step, "Vertices"), GetLevel(carver, i)->GetNumberOfPoints());
    EXPECT_EQ(GetProfileValue(carver, step, "Triangles"), GetLevel(carver, i)->GetNumberOfPolys());
  }
  EXPECT_EQ(GetProfile(carver)->GetNumberOfRows(), GetLevelStep(carver, 7) + 1);
  EXPECT_TRUE(std::isnan(GetProfileValue(carver, 0, "Priority")));
}
