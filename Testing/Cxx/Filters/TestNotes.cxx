// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Vector.h"
#include "CrackedModels.h"
#include "FilterTesting.h"
#include "RandomModels.h"
#include "Session/CarverNotes.h"

#include <vtkMassProperties.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

namespace
{

/**
 * A mesh with its first triangles turned. A fin at each edge between turned triangles and others
 * hides which triangles belong together.
 */
carving::TriangleMesh WithTurned(carving::TriangleMesh mesh, std::size_t count)
{
  std::map<std::array<int, 2>, int> turned; // by edge: how many of its two triangles are
  for (std::size_t t = 0; t < count; ++t)
  {
    carving::Triangle& corners = mesh.Triangles[t];
    std::swap(corners[0], corners[1]);
    for (int i = 0; i < 3; ++i)
    {
      const auto [lower, upper] = std::minmax(corners[i], corners[(i + 1) % 3]);
      ++turned[{ lower, upper }];
    }
  }
  for (const auto& [edge, triangles] : turned)
  {
    if (triangles == 1)
    {
      const carving::Point outward =
        carving::Between(mesh.Points[edge[0]], mesh.Points[edge[1]], 0.5);
      mesh.Triangles.push_back({ edge[0], edge[1], static_cast<int>(mesh.Points.size()) });
      mesh.Points.push_back({ 2.0 * outward[0], 2.0 * outward[1], 2.0 * outward[2] });
    }
  }
  return mesh;
}

} // namespace

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
  // One turned triangle of eighty changes the winding number by 1/40: too little for a guess.
  EXPECT_FALSE(Has(GetNotes(Carve(ToPolyData(WithTurned(models::Sphere(1), 1)))), "guess"));
  EXPECT_TRUE(Has(GetNotes(Carve(ToPolyData(WithTurned(models::Sphere(1), 12)))), "guess"));
}

// Cracks where vertices lie on edges of other triangles do not hollow out a box in single
// precision; a note says how many triangles close them.
TEST(CarverNotes, SaysThatCracksWereSealed)
{
  std::mt19937_64 random(2);
  const auto carver = Carve(ToPolyData(models::InSinglePrecision(
    models::Rotated(models::PatchedBox({ 3, 2, 1 }, { 3, 1, 1, 1, 1, 1 }), random))));
  EXPECT_TRUE(Has(GetNotes(carver), "triangles were added to close its solid")) << GetNotes(carver);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(GetLevel(carver, CountLevels(carver) - 1));
  EXPECT_NEAR(mass->GetVolume(), 6.0, 1e-5);
}

// Where edges lead through cracks however many are split, a note says so, and what to do. Some of
// the prisms have such cracks; their sides are joined within a larger tolerance.
TEST(CarverNotes, SaysThatCracksStayOpen)
{
  constexpr int most = 12;
  vtkSmartPointer<vtkPolyData> input;
  std::string notes;
  for (int i = 0; i < most && !Has(notes, "cracks that cannot be closed"); ++i)
  {
    std::mt19937_64 random(i);
    input = ToPolyData(models::WithHangingNodes(
      models::InSinglePrecision(models::Rotated(models::Prism(24, 0.0, 0.1), random)), 3, random));
    vtkNew<vtkTopologyCarver> carver;
    carver->SetConformity(vtkTopologyCarver::ENCLOSING);
    Carve(carver, input);
    notes = GetNotes(carver);
  }
  EXPECT_TRUE(Has(notes, "cracks that cannot be closed"));
  vtkNew<vtkTopologyCarver> carver;
  carver->SetSnapTolerance(1e-6);
  Carve(carver, input);
  EXPECT_FALSE(Has(GetNotes(carver), "cracks that cannot be closed")) << GetNotes(carver);
}

// Joining what touches within a large tolerance can move points farther than that, from one to the
// next. Then it is not used, and a note says so.
TEST(CarverNotes, SaysThatPointsWouldMoveTooFar)
{
  const carving::TriangleMesh box = models::PatchedBox({ 1, 1, 1 }, { 20, 20, 20, 20, 20, 20 });
  vtkNew<vtkTopologyCarver> carver;
  carver->SetSnapTolerance(0.5);
  Carve(carver, ToPolyData(models::Joined(box, models::Moved(box, { 3e-13, 0, 0 }))));
  EXPECT_TRUE(Has(GetNotes(carver), "points move farther than SnapTolerance")) << GetNotes(carver);
}

// If a limit ended an attempt, a note names the limit.
TEST(CarverNotes, NamesTheLimit)
{
  carving::Reply reply;
  reply.Limits = "TetGen took longer than 2 s\n";
  std::vector<std::string> notes;
  DescribeDecomposition(reply, 3, notes);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
    "The result depends on a limit: TetGen took longer than 2 s. With a higher limit, the result "
    "might differ.");
}
