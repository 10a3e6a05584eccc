// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Measure/Profile.h"
#include "Core/Mesh/Vector.h"
#include "Core/Stream/Level.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace carving;

namespace
{

/** Corners in a canonical rotation, triangles sorted: equal for equal oriented surfaces. */
std::vector<Triangle> Canonical(std::vector<Triangle> triangles)
{
  for (Triangle& t : triangles)
  {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

double SixVolume(const Tetrahedralization& mesh, const Level<3>& level)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : small::Triangles(level))
  {
    const std::vector<Point>& p = mesh.Surface.Points;
    sum += Dot(p[a], Cross(p[b], p[c]));
  }
  return sum;
}

} // namespace

// Level 0 is the initial approximation, oriented outward.
TEST(Level, ZeroIsTheHull)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(small::InnerFaces());
  const Level<3> level = ExtractLevel(small::StoreOneByOne(mesh), 0);
  EXPECT_EQ(Canonical(small::Triangles(level)), Canonical(small::OuterFaces()));
  for (const FaceLife<3>& face : level.Faces)
  {
    EXPECT_EQ(face.Constraint, -1);
  }
}

// The last level is M, oriented outward even where M is inside out.
TEST(Level, LastIsTheInputOrientedOutward)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(small::Flipped(small::InnerFaces()));
  const StoredStream<3> stream = small::StoreOneByOne(mesh);
  const Level<3> level = ExtractLevel(stream, stream.Order.LastStep());
  EXPECT_EQ(Canonical(small::Triangles(level)), Canonical(small::InnerFaces()));
  for (const FaceLife<3>& face : level.Faces)
  {
    EXPECT_EQ(face.Behind, Solid);
  }
}

// Every level between bounds a volume that shrinks by that of the tetrahedra carved.
TEST(Level, LosesTheVolumeOfWhatIsCarved)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(small::InnerFaces());
  const Stream stream = small::Carved(mesh, small::OneByOne());
  const StoredStream<3> stored = small::StoreOneByOne(mesh);
  double expected = 8.0 * 8.0 * 8.0; // six times the volume of the outer tetrahedron
  for (int step = 0; step <= stream.LastStep(); ++step)
  {
    for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
    {
      if (stream.Step[cell] == step)
      {
        const auto& [a, b, c, d] = mesh.Cells[cell];
        const std::vector<Point>& p = mesh.Surface.Points;
        expected -= carving::SixVolume(p[a], p[b], p[c], p[d]);
      }
    }
    EXPECT_NEAR(SixVolume(mesh, ExtractLevel(stored, step)), expected, 1e-9);
  }
  EXPECT_NEAR(expected, 2.0 * 2.0 * 2.0, 1e-9); // of the inner one
}

// A triangle of M with the exterior on both sides appears once, oriented as M has it.
TEST(Level, ShowsAFoldOnce)
{
  for (const Triangle& sheet : { Triangle{ 1, 2, 3 }, Triangle{ 1, 3, 2 } })
  {
    const Tetrahedralization mesh =
      small::Assemble({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
        { { 0, 1, 2, 3 }, { 4, 1, 2, 3 } }, { sheet });
    const StoredStream<3> stream = small::StoreOneByOne(mesh);
    const Level<3> level = ExtractLevel(stream, stream.Order.LastStep());
    ASSERT_EQ(level.Faces.size(), 1u);
    EXPECT_EQ(level.Faces[0].Corners, sheet);
    EXPECT_EQ(level.Faces[0].Constraint, 0);
    EXPECT_TRUE(level.Faces[0].Fold);
  }
}

// A triangle of M with solid on both sides never shows.
TEST(Level, HidesWhatLiesWithinTheSolid)
{
  const Tetrahedralization mesh =
    small::NestedTetrahedra(small::Joined(small::OuterFaces(), small::InnerFaces()));
  const Level<3> level = ExtractLevel(small::StoreOneByOne(mesh), 0);
  EXPECT_EQ(Canonical(small::Triangles(level)), Canonical(small::OuterFaces()));
}

// The wall of an opened void faces into the void.
TEST(Level, OrientsTheWallOfAVoidIntoIt)
{
  const Tetrahedralization mesh = small::HollowTetrahedron();
  const StoredStream<3> stream = small::StoreOneByOne(mesh);
  EXPECT_EQ(Canonical(small::Triangles(ExtractLevel(stream, stream.Order.LastStep()))),
    Canonical(small::Joined(small::OuterFaces(), small::Flipped(small::InnerFaces()))));
}

// The tetrahedron behind a carved face is the one that carving there would remove next: the face is
// its face, and it is the only remaining tetrahedron that has this face.
TEST(Level, NamesTheTetrahedronBehindACarvedFace)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(small::InnerFaces());
  const StoredStream<3> stream = small::StoreOneByOne(mesh);
  int carvedFaces = 0;
  const Level<3> level = ExtractLevel(stream, 3);
  for (const FaceLife<3>& face : level.Faces)
  {
    if (face.Constraint >= 0)
    {
      continue;
    }
    ++carvedFaces;
    for (int cell = 0; cell < static_cast<int>(stream.Mesh.Cells.size()); ++cell)
    {
      const auto& corners = stream.Mesh.Cells[cell];
      const bool hasFace = std::all_of(face.Corners.begin(), face.Corners.end(),
        [&](int p) { return std::find(corners.begin(), corners.end(), p) != corners.end(); });
      const bool remains = StepAt(stream, HalfFace<3>::Of(cell, 0)) > 3;
      EXPECT_EQ(cell == HalfFace<3>::Cell(face.Behind), hasFace && remains);
    }
  }
  EXPECT_GT(carvedFaces, 0);
}

// With both sides of folds, a triangle of M with the exterior on both sides appears with its copy.
TEST(Level, ShowsBothSidesOfAFoldIfAsked)
{
  const Tetrahedralization mesh =
    small::Assemble({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
      { { 0, 1, 2, 3 }, { 4, 1, 2, 3 } }, { { 1, 2, 3 } });
  StoredStream<3> stream = small::StoreOneByOne(mesh);
  stream.Folds = FoldSides::Both;
  EXPECT_EQ(Canonical(small::Triangles(ExtractLevel(stream, stream.Order.LastStep()))),
    Canonical({ { 1, 2, 3 }, { 1, 3, 2 } }));
}

// Several levels at once, equal steps among them, are what each is by itself, face by face.
TEST(Level, IsTheSameAmongSeveral)
{
  const StoredStream<3> stream = small::StoreOneByOne(small::NestedTetrahedra(small::InnerFaces()));
  std::vector<int> steps = { 0 };
  for (int step = 0; step <= stream.Order.LastStep(); step += 2)
  {
    steps.push_back(step);
  }
  const std::vector<Level<3>> levels =
    ExtractLevels(stream, steps, ComputeProfile(stream).Triangles);
  ASSERT_EQ(levels.size(), steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const Level<3> alone = ExtractLevel(stream, steps[i]);
    EXPECT_EQ(levels[i].Step, steps[i]);
    ASSERT_EQ(levels[i].Faces.size(), alone.Faces.size());
    EXPECT_EQ(levels[i].Faces.capacity(), alone.Faces.size()); // as much memory as needed
    for (std::size_t face = 0; face < alone.Faces.size(); ++face)
    {
      EXPECT_EQ(levels[i].Faces[face].Corners, alone.Faces[face].Corners);
      EXPECT_EQ(levels[i].Faces[face].Behind, alone.Faces[face].Behind);
    }
  }
  EXPECT_TRUE(ExtractLevels(stream, {}).empty());
}
