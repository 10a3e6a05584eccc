// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"
#include "Session/CarverNotes.h"

#include <gtest/gtest.h>

// A convex mesh gives one level, no error, and a note that there is nothing to carve.
TEST(CarverNotes, SaysThatAConvexMeshHasNothingToCarve)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  auto input = ToPolyData(models::Sphere(1));
  Carve(carver, input);
  ASSERT_EQ(CountLevels(carver), 1);
  EXPECT_EQ(GetTriangles(GetLevel(carver, 0)), GetTriangles(input));
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_TRUE(Has(GetNotes(carver), "nothing to carve"));
}

// A note gives the number of crossing pairs: three for three triangles through a common point.
TEST(CarverNotes, NotesThatItResolvedCrossings)
{
  carving::TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = 3 * axis, u = (axis + 1) % 3, v = (axis + 2) % 3;
    mesh.Points.resize(first + 3, { 0, 0, 0 });
    mesh.Points[first][u] = 3;
    mesh.Points[first + 1][u] = mesh.Points[first + 2][u] = -2;
    mesh.Points[first + 1][v] = 3;
    mesh.Points[first + 2][v] = -3;
    mesh.Triangles.push_back({ first, first + 1, first + 2 });
  }
  const auto carver = Carve(ToPolyData(mesh));
  EXPECT_EQ(GetNotes(carver).find("3 pairs"), 0u) << GetNotes(carver);
}

// If an enclosing mesh is not consistently oriented, a note says that the solid is a guess.
TEST(CarverNotes, NotesThatSolidIsAGuess)
{
  auto mesh = models::Joined(models::Sphere(1), models::Moved(models::Sphere(1), { 3, 0, 0 }));
  std::swap(mesh.Triangles[0][0], mesh.Triangles[0][1]);
  const auto carver = Carve(ToPolyData(mesh));
  // One flipped triangle of eighty changes the winding number by 1/40: too little for a guess.
  EXPECT_FALSE(Has(GetNotes(carver), "guess"));
  for (int i = 1; i < 12; ++i)
  {
    std::swap(mesh.Triangles[i][0], mesh.Triangles[i][1]);
  }
  Carve(carver, ToPolyData(mesh));
  EXPECT_TRUE(Has(GetNotes(carver), "guess"));
}

// If a limit ended an attempt, a note names the limit.
TEST(CarverNotes, NamesTheLimit)
{
  carving::Reply reply;
  reply.Limits = "TetGen took longer than 2 s\n";
  std::vector<std::string> notes;
  DescribeDecomposition(reply, notes);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
    "The result depends on a limit: TetGen took longer than 2 s. With a higher limit, the result "
    "might be another.");
}
