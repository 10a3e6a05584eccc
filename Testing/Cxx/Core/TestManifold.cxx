// SPDX-License-Identifier: BSD-3-Clause
#include "Manifold.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace carving;

namespace
{

/** A stream in which nothing has been carved, with the solid between the given faces. */
StoredStream<3> Uncarved(const std::vector<Point>& points,
  const std::vector<std::array<int, 4>>& cells, const std::vector<Triangle>& facets)
{
  return small::StoreOneByOne(small::Assemble(points, cells, facets));
}

/** How many faces use each edge, as the vertices' numbers have it. */
std::map<std::pair<int, int>, int> CountEdges(const ManifoldLevel<3>& level)
{
  std::map<std::pair<int, int>, int> edges;
  for (const Triangle& t : level.Faces)
  {
    for (int i = 0; i < 3; ++i)
    {
      ++edges[std::minmax(t[i], t[(i + 1) % 3])];
    }
  }
  return edges;
}

int MostFacesOnAnEdge(const ManifoldLevel<3>& level)
{
  int most = 0;
  for (const auto& [edge, count] : CountEdges(level))
  {
    most = std::max(most, count);
  }
  return most;
}

bool IsClosedManifold(const ManifoldLevel<3>& level)
{
  const auto edges = CountEdges(level);
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 2; });
}

/** All four faces of a tetrahedron, oriented outward. */
std::vector<Triangle> FacesOf(const std::vector<Point>& points, const std::array<int, 4>& cell)
{
  const Tetrahedralization mesh = small::Assemble(points, { cell }, {});
  return { mesh.OutwardFace(0, 0), mesh.OutwardFace(0, 1), mesh.OutwardFace(0, 2),
    mesh.OutwardFace(0, 3) };
}

/** Two solid tetrahedra, whatever they have in common. */
StoredStream<3> TwoSolids(
  const std::vector<Point>& points, const std::array<int, 4>& a, const std::array<int, 4>& b)
{
  return Uncarved(points, { a, b }, small::Joined(FacesOf(points, a), FacesOf(points, b)));
}

} // namespace

// Two solids that touch in a vertex get one copy of it each.
TEST(Manifold, CutsAtAVertex)
{
  const StoredStream<3> stream = TwoSolids({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                                             { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } },
    { 0, 1, 2, 3 }, { 0, 4, 5, 6 });
  const Level<3> level = ExtractLevel(stream, 0);
  EXPECT_EQ(KeepUncut(level).Points.size(), 7u);
  const ManifoldLevel<3> cut = CutIntoManifold(stream, level);
  EXPECT_EQ(cut.Points, (std::vector<int>{ 0, 0, 1, 2, 3, 4, 5, 6 }));
  EXPECT_TRUE(IsClosedManifold(cut));
}

// Two solids that touch in an edge are cut apart there: the faces of each stay joined with each other.
TEST(Manifold, CutsAlongAnEdge)
{
  const StoredStream<3> stream =
    TwoSolids({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0 } },
      { 0, 1, 2, 3 }, { 0, 1, 4, 5 });
  const Level<3> level = ExtractLevel(stream, 0);
  EXPECT_EQ(MostFacesOnAnEdge(KeepUncut(level)), 4);
  const ManifoldLevel<3> cut = CutIntoManifold(stream, level);
  EXPECT_EQ(cut.Points.size(), 8u);
  EXPECT_TRUE(IsClosedManifold(cut));
  // No triangle of one tetrahedron shares a vertex with one of the other.
  std::map<bool, std::set<int>> vertices;
  for (std::size_t i = 0; i < cut.Faces.size(); ++i)
  {
    const Triangle& corners = level.Faces[i].Corners;
    const bool second = std::any_of(corners.begin(), corners.end(), [](int v) { return v >= 4; });
    vertices[second].insert(cut.Faces[i].begin(), cut.Faces[i].end());
  }
  EXPECT_EQ(vertices[false].size(), 4u);
  EXPECT_EQ(vertices[true].size(), 4u);
}

// Two wedges that meet in an edge and are one piece around both of its ends are joined across the
// exterior: no edge has four triangles, no vertex is added that is not a copy.
TEST(Manifold, JoinsWedgesThatAreOneAroundBothEnds)
{
  // Around the edge 0-1, a ring of six tetrahedra, of which two that are opposite are missing; below
  // and above, the ring is closed by tetrahedra to the points 8 and 9.
  std::vector<Point> points = { { 0, 0, -1 }, { 0, 0, 1 } };
  for (int i = 0; i < 6; ++i)
  {
    points.push_back({ std::cos(i * M_PI / 3), std::sin(i * M_PI / 3), 0.0 });
  }
  points.push_back({ 0, 0, -2 });
  points.push_back({ 0, 0, 2 });
  std::vector<std::array<int, 4>> cells;
  std::map<Triangle, Triangle> boundary; // by sorted corners; faces inside cancel
  for (int i = 0; i < 6; ++i)
  {
    const int a = 2 + i, b = 2 + (i + 1) % 6;
    if (i % 3 != 0)
    {
      cells.push_back({ 0, 1, a, b });
    }
    cells.push_back({ 8, 0, a, b });
    cells.push_back({ 1, 9, a, b });
  }
  for (const std::array<int, 4>& cell : cells)
  {
    for (const Triangle& face : FacesOf(points, cell))
    {
      Triangle key = face;
      std::sort(key.begin(), key.end());
      if (!boundary.emplace(key, face).second)
      {
        boundary.erase(key);
      }
    }
  }
  std::vector<Triangle> facets;
  for (const auto& [key, face] : boundary)
  {
    facets.push_back(face);
  }
  const StoredStream<3> stream = Uncarved(points, cells, facets);
  const Level<3> level = ExtractLevel(stream, 0);
  EXPECT_EQ(level.Faces.size(), facets.size());
  EXPECT_EQ(MostFacesOnAnEdge(KeepUncut(level)), 4);
  const ManifoldLevel<3> cut = CutIntoManifold(stream, level);
  EXPECT_TRUE(IsClosedManifold(cut));
}

// Of three sheets at an edge none is joined with another; each stays whole.
TEST(Manifold, CutsThreeSheetsApart)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 },
    { -1, -1, 0 } };
  const StoredStream<3> stream = Uncarved(points,
    { { 0, 1, 2, 3 }, { 0, 1, 3, 4 }, { 0, 1, 4, 2 } }, { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } });
  const Level<3> level = ExtractLevel(stream, stream.Order.LastStep());
  ASSERT_EQ(level.Faces.size(), 3u);
  EXPECT_EQ(CutIntoManifold(stream, level).Points.size(), 9u);
}

// With both of their sides, three sheets at an edge become one closed surface around them.
TEST(Manifold, ClosesThreeSheetsWithBothSides)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 },
    { -1, -1, 0 } };
  StoredStream<3> stream = Uncarved(points, { { 0, 1, 2, 3 }, { 0, 1, 3, 4 }, { 0, 1, 4, 2 } },
    { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } });
  stream.Folds = FoldSides::Both;
  const Level<3> level = ExtractLevel(stream, stream.Order.LastStep());
  ASSERT_EQ(level.Faces.size(), 6u);
  EXPECT_TRUE(IsClosedManifold(CutIntoManifold(stream, level)));
}

// A sheet of two triangles that are oriented alike stays joined, one that is not is cut.
TEST(Manifold, JoinsFoldsThatAreOrientedAlike)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 },
    { -1, -1, 0 } };
  const std::vector<std::array<int, 4>> cells = { { 0, 1, 2, 3 }, { 0, 1, 3, 4 }, { 0, 1, 4, 2 } };
  for (const bool alike : { true, false })
  {
    const Triangle second = alike ? Triangle{ 1, 0, 3 } : Triangle{ 0, 1, 3 };
    const StoredStream<3> stream = Uncarved(points, cells, { { 0, 1, 2 }, second });
    const Level<3> level = ExtractLevel(stream, stream.Order.LastStep());
    EXPECT_EQ(CutIntoManifold(stream, level).Points.size(), alike ? 4u : 6u);
  }
}
