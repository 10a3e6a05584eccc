// SPDX-License-Identifier: BSD-3-Clause
#include "Level.h"
#include "SmallMeshes.h"
#include "Vector.h"

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

double SixVolume(const Tetrahedralization& mesh, const Level& level)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : level.Triangles)
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
  const Level level = ExtractLevel(mesh, small::CarveOneByOne(mesh), 0);
  EXPECT_EQ(Canonical(level.Triangles), Canonical(small::OuterFaces()));
  EXPECT_EQ(level.Constraints, std::vector<int>(4, -1));
}

// The last level is M, oriented outward even where M is inside out.
TEST(Level, LastIsTheInputOrientedOutward)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(small::Flipped(small::InnerFaces()));
  const Stream stream = small::CarveOneByOne(mesh);
  const Level level = ExtractLevel(mesh, stream, stream.LastStep());
  EXPECT_EQ(Canonical(level.Triangles), Canonical(small::InnerFaces()));
  EXPECT_EQ(level.CellsBehind, std::vector<int>(4, 12));
}

// Every level between bounds a volume that shrinks by that of the tetrahedra carved.
TEST(Level, LosesTheVolumeOfWhatIsCarved)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(small::InnerFaces());
  const Stream stream = small::CarveOneByOne(mesh);
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
    EXPECT_NEAR(SixVolume(mesh, ExtractLevel(mesh, stream, step)), expected, 1e-9);
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
    const Stream stream = small::CarveOneByOne(mesh);
    const Level level = ExtractLevel(mesh, stream, stream.LastStep());
    ASSERT_EQ(level.Triangles.size(), 1u);
    EXPECT_EQ(level.Triangles[0], sheet);
    EXPECT_EQ(level.Constraints[0], 0);
    EXPECT_EQ(level.CellsBehind[0], -1);
  }
}

// A triangle of M with solid on both sides never shows.
TEST(Level, HidesWhatLiesWithinTheSolid)
{
  const Tetrahedralization mesh =
    small::NestedTetrahedra(small::Joined(small::OuterFaces(), small::InnerFaces()));
  const Level level = ExtractLevel(mesh, small::CarveOneByOne(mesh), 0);
  EXPECT_EQ(Canonical(level.Triangles), Canonical(small::OuterFaces()));
}

// The wall of an opened void faces into the void.
TEST(Level, OrientsTheWallOfAVoidIntoIt)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(
    small::Joined(small::OuterFaces(), small::Flipped(small::InnerFaces())));
  const Stream stream = small::CarveOneByOne(mesh);
  EXPECT_EQ(Canonical(ExtractLevel(mesh, stream, stream.LastStep()).Triangles),
    Canonical(small::Joined(small::OuterFaces(), small::Flipped(small::InnerFaces()))));
}

// The tetrahedron behind a carved face is the one that carving there would remove next.
TEST(Level, NamesTheTetrahedronBehindACarvedFace)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(small::InnerFaces());
  const Stream stream = small::CarveOneByOne(mesh);
  const Level level = ExtractLevel(mesh, stream, 3);
  for (std::size_t i = 0; i < level.Triangles.size(); ++i)
  {
    EXPECT_GT(stream.Step[level.CellsBehind[i]], 3);
  }
}
