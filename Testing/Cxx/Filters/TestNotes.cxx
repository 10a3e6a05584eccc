// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "vtkMultiBlockDataSet.h"

#include <gtest/gtest.h>

#include <cmath>

// A convex mesh has nothing to carve: one level, no error, and a note that says so.
TEST(CarverNotes, SaysThatAConvexMeshHasNothingToCarve)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  auto input = ToPolyData(models::Sphere(1));
  carver->SetInputData(input);
  carver->Update();
  ASSERT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 1u);
  EXPECT_EQ(GetTriangles(GetLevel(carver, 0)), GetTriangles(input));
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_NE(GetNotes(carver).find("nothing to carve"), std::string::npos);
}

// Crossing triangles are split, and a note gives the number of pairs.
TEST(CarverNotes, NotesThatItResolvedCrossings)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ReadReal("bones.off"));
  carver->Update();
  EXPECT_NE(GetNotes(carver).find("366 pairs"), std::string::npos);
}

// Where the mesh encloses a region but is not consistently oriented, a note says that solid is a guess.
TEST(CarverNotes, NotesThatSolidIsAGuess)
{
  auto mesh = models::Joined(models::Sphere(1), models::Moved(models::Sphere(1), { 3, 0, 0 }));
  std::swap(mesh.Triangles[0][0], mesh.Triangles[0][1]);
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ToPolyData(mesh));
  carver->Update();
  // One flipped triangle of eighty takes 1/40 of the winding number: less than a guess.
  EXPECT_EQ(GetNotes(carver).find("guess"), std::string::npos);
  for (int i = 1; i < 12; ++i)
  {
    std::swap(mesh.Triangles[i][0], mesh.Triangles[i][1]);
  }
  carver->SetInputData(ToPolyData(mesh));
  carver->Update();
  EXPECT_NE(GetNotes(carver).find("guess"), std::string::npos);
}
