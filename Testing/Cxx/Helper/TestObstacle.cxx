// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The contacts of moving faces with a mesh.
 */
#include "Core/Mesh/Vector.h"
#include "Helper/Decimation/Obstacle.h"
#include "Helper/Enclosing/Pierce.h"
#include "Helper/Resolve/Clean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

using namespace carving;
using helper::Vertex;

namespace
{

constexpr double Accuracy = 1e-6;

/** The unit cube, with 2 * n * n triangles in each wall. */
ResolvedMesh MakeCube(int n)
{
  TriangleMesh cube;
  for (int wall = 0; wall < 6; ++wall)
  {
    const auto add = [&](int i, int j)
    {
      Point p;
      p[wall % 3] = wall / 3;
      p[(wall + 1 + wall / 3) % 3] = static_cast<double>(j) / n;
      p[(wall + 2 - wall / 3) % 3] = static_cast<double>(i) / n;
      cube.Points.push_back(p);
      return static_cast<int>(cube.Points.size()) - 1;
    };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n; ++j)
      {
        const int a = add(i, j), b = add(i + 1, j), c = add(i + 1, j + 1), d = add(i, j + 1);
        cube.Triangles.push_back({ a, b, c });
        cube.Triangles.push_back({ a, c, d });
      }
    }
  }
  return helper::Clean(helper::AsResolved(cube));
}

/** A closed surface: faces between w, which is vertex 0, and a ring, and others far below. */
helper::SurfaceMesh MakeTent(const Point& w, const std::vector<Point>& ring)
{
  ResolvedMesh tent;
  tent.Points = { w, { 0.5, 0.5, -100.0 } };
  tent.Points.insert(tent.Points.end(), ring.begin(), ring.end());
  const int count = static_cast<int>(ring.size());
  for (int i = 0; i < count; ++i)
  {
    const int a = 2 + i, b = 2 + (i + 1) % count;
    tent.Facets.push_back({ 0, a, b });
    tent.Facets.push_back({ 1, b, a });
  }
  return helper::AsSurfaceMesh(tent);
}

/** When faces around w touch a mesh. */
double FindTime(
  const ResolvedMesh& mesh, const Point& w, const std::vector<Point>& ring, const Point& to)
{
  const FacetTree<3> tree(mesh);
  helper::Obstacle obstacle(tree);
  const helper::Star star(MakeTent(w, ring), Vertex(0));
  const auto contact = obstacle.FindContact(star, w, to);
  return contact ? contact->Time : HUGE_VAL;
}

/**
 * When an edge of moving faces touches the edge from (1, 0, 1) to (1, 1, 1) of a mesh below. They
 * meet at half of the time: then w is at a height of 0.75, and the edge goes through (1, 0.5, 1).
 */
double FindTimeOfValley(const ResolvedMesh& mesh)
{
  const std::vector<Point> ring = { { -1.0, 0.5, 1.5 }, { 2.0, -2.0, 3.0 }, { 4.0, 0.5, 3.0 },
    { 2.0, 3.0, 3.0 } };
  return FindTime(mesh, { 2.0, 0.5, 1.5 }, ring, { 2.0, 0.5, 0.0 });
}

/** A regular polygon in a plane at a height, as a fan around its center, which comes last. */
ResolvedMesh MakePolygon(int corners, double radius, double height)
{
  ResolvedMesh polygon;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * M_PI * i / corners;
    polygon.Points.push_back({ radius * std::cos(angle), radius * std::sin(angle), height });
    polygon.Facets.push_back({ i, (i + 1) % corners, corners });
  }
  polygon.Points.push_back({ 0.0, 0.0, height });
  return polygon;
}

} // namespace

// A vertex that moves down stops at a wall. The wall may have so many triangles that they are not
// copied.
TEST(Obstacle, StopsVertices)
{
  const std::vector<Point> ring = { { 0.2, 0.3, 1.5 }, { 0.7, 0.2, 1.5 }, { 0.6, 0.9, 1.5 } };
  for (const int n : { 1, 2, 9, 60 })
  {
    EXPECT_NEAR(FindTime(MakeCube(n), { 0.5, 0.5, 2.0 }, ring, { 0.5, 0.5, -2.0 }), 0.25, Accuracy)
      << n;
  }
}

// An edge that moves down stops at an edge of the cube, and passes over the edges in its walls.
TEST(Obstacle, StopsEdges)
{
  for (const int n : { 1, 3, 10, 30 })
  {
    EXPECT_NEAR(FindTimeOfValley(MakeCube(n)), 0.5, Accuracy) << n;
  }
}

// The same at the border of a sheet with two sides, though both lie in one plane.
TEST(Obstacle, StopsEdgesAtSheets)
{
  ResolvedMesh sheet;
  sheet.Points = { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  sheet.Facets = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 2, 1 }, { 0, 3, 2 } };
  EXPECT_NEAR(FindTimeOfValley(sheet), 0.5, Accuracy);
}

// Faces that move down stop at a corner of the cube: between w above a wall and a ring around it,
// which is lower, the height of the faces is least at a corner.
TEST(Obstacle, StopsFaces)
{
  constexpr double start = 9.0;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> share(0.1, 0.9), height(-1.0, 0.5), radius(4.0, 8.0);
  for (int run = 0; run < 100; ++run)
  {
    const double x = share(random), y = share(random), z = height(random);
    const double r = radius(random);
    const int count = 3 + run % 5;
    std::vector<Point> ring;
    for (int i = 0; i < count; ++i)
    {
      const double angle = 2.0 * M_PI * (i + 0.5 * share(random)) / count;
      ring.push_back({ x + r * std::cos(angle), y + r * std::sin(angle), z });
    }
    double highest = 1.0; // w touches the wall
    for (const auto& [cornerX, cornerY] : { std::pair(0, 0), { 0, 1 }, { 1, 0 }, { 1, 1 } })
    {
      double weight = 1.0; // of w at the corner: the ring is convex, so the least of all planes
      for (int i = 0; i < count; ++i)
      {
        const Point &a = ring[i], &b = ring[(i + 1) % count];
        const double all = (a[0] - x) * (b[1] - y) - (a[1] - y) * (b[0] - x);
        const double part =
          (a[0] - cornerX) * (b[1] - cornerY) - (a[1] - cornerY) * (b[0] - cornerX);
        weight = std::min(weight, part / all);
      }
      highest = std::max(highest, z + (1.0 - z) / weight);
    }
    ASSERT_LT(highest, start);
    const double expected = start - highest;
    const Point w = { x, y, start }, to = { x, y, start - 1.0 - expected };
    for (const int n : { 1, 4 })
    {
      EXPECT_NEAR(FindTime(MakeCube(n), w, ring, to) * (1.0 + expected), expected, Accuracy) << run;
    }
  }
}

// A corner of a sheet without thickness may move in the sheet's plane as long as a smaller sheet of
// the same shape stays inside, and never out of the plane: one side would cut the other's faces
// off.
TEST(Obstacle, StaysEnclosedBySheets)
{
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> anyShare(0.05, 0.95), anyRadius(0.05, 1.3),
    height(-5.0, 5.0);
  for (int run = 0; run < 200; ++run)
  {
    const int corners = 3 + run % 6;
    const double share = anyShare(random), radius = anyRadius(random), z = height(random);
    ResolvedMesh sides = MakePolygon(corners, 1.0, z);
    sides.Points.push_back(sides.Points.back()); // the center of the lower side
    for (int i = 0; i < corners; ++i)
    {
      sides.Facets.push_back({ (i + 1) % corners, i, corners + 1 });
    }
    const helper::Star star(helper::AsSurfaceMesh(sides), Vertex(0));
    const ResolvedMesh inside = MakePolygon(corners, share, z);
    const FacetTree<3> tree(inside);
    helper::Obstacle obstacle(tree);
    EXPECT_EQ(obstacle.StaysEnclosed(star, { radius, 0.0, z }), radius > share) << run;
    const ResolvedMesh same = MakePolygon(corners, 1.0, z);
    const FacetTree<3> treeOfSame(same);
    EXPECT_FALSE(helper::Obstacle(treeOfSame).StaysEnclosed(star, { radius, 0.0, z + 0.1 })) << run;
  }
}

// A triangle stays enclosed unless it pierces a tetrahedron between the new place of a vertex and a
// face around the old one that this place is behind, or overlaps a face of one in an area: at any
// scale, also where much lies in one plane.
TEST(Obstacle, LosesWhatRemovedTetrahedraContain)
{
  std::mt19937_64 random(23);
  int lost = 0, kept = 0;
  for (int run = 0; run < 20000; ++run)
  {
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 401) - 200);
    const auto draw = [&]
    {
      Point p;
      std::generate(p.begin(), p.end(), [&] { return scale * static_cast<double>(random() % 6); });
      return p;
    };
    const Point w = draw();
    std::vector<Point> ring(3 + run % 3);
    std::generate(ring.begin(), ring.end(), draw);
    const helper::Star star(MakeTent(draw(), ring), Vertex(0));
    ResolvedMesh mesh;
    mesh.Points = { draw(), draw(), draw() };
    mesh.Facets = { { 0, 1, 2 } };
    const auto triangle = helper::ToInexact(CornersOf<3>(mesh.Points, mesh.Facets[0]));
    if (CGAL::collinear(triangle[0], triangle[1], triangle[2]))
    {
      continue;
    }
    const helper::Piercer piercer(triangle);
    bool meets = false, isFlat = false;
    for (const auto& face : star.Corners)
    {
      const auto [a, b, c] = helper::ToInexact(face);
      const auto d = helper::ToInexact(w);
      const CGAL::Orientation side = CGAL::orientation(a, b, c, d);
      isFlat |= side == CGAL::COPLANAR;
      meets |= side == CGAL::NEGATIVE && piercer.FindContact({ a, c, b, d }).Exists();
    }
    if (!isFlat) // or a sheet might lose a part
    {
      const FacetTree<3> tree(mesh);
      ASSERT_EQ(helper::Obstacle(tree).StaysEnclosed(star, w), !meets) << run;
      ++(meets ? lost : kept);
    }
  }
  EXPECT_GT(lost, 1000);
  EXPECT_GT(kept, 1000);
}
