// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/Manifold.h"
#include "Core/Surface/SurfaceTopology.h"
#include "Core/Surface/TouchingVertices.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace carving;

namespace
{

/** A stream in which all that is no solid can be carved, with the solid between the given faces. */
StoredStream<3> Carvable(const std::vector<Point>& points,
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

/** Solid tetrahedra, whatever they have in common, and others to be carved from between them. */
StoredStream<3> Solids(const std::vector<Point>& points,
  const std::vector<std::array<int, 4>>& solids, std::vector<std::array<int, 4>> between = {})
{
  std::map<Triangle, Triangle> boundary; // by sorted corners; faces inside cancel
  for (const std::array<int, 4>& cell : solids)
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
  between.insert(between.end(), solids.begin(), solids.end());
  return Carvable(points, between, facets);
}

/** Two solids that touch in point 0. */
StoredStream<3> SolidsAtAVertex()
{
  return Solids({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { 0, -1, 0 },
                  { 0, 0, -1 } },
    { { 0, 1, 2, 3 }, { 0, 4, 5, 6 } });
}

/** Two solids that touch in the edge from point 0 to 1. */
StoredStream<3> SolidsAtAnEdge()
{
  return Solids({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0 } },
    { { 0, 1, 2, 3 }, { 0, 1, 4, 5 } }, { { 0, 1, 3, 4 }, { 0, 1, 5, 2 } });
}

/** Two solids that touch in the edges from point 0 to 1 and on to 2. */
StoredStream<3> SolidsAlongTwoEdges()
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 0, 0, 1 }, { 0, 0, 2 }, { 1, 0, 1 },
    { 1, 1, 1 }, { -1, 0, 1 }, { -1, -1, 1 } };
  return Solids(points, { { 0, 1, 3, 4 }, { 1, 2, 3, 4 }, { 0, 1, 5, 6 }, { 1, 2, 5, 6 } },
    { { 0, 1, 4, 5 }, { 1, 2, 4, 5 }, { 0, 1, 6, 3 }, { 1, 2, 6, 3 } });
}

/** Sheets between three tetrahedra around an edge from point 0 to 1. */
StoredStream<3> Sheets(const std::vector<Triangle>& facets)
{
  return Carvable({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 }, { -1, -1, 0 } },
    { { 0, 1, 2, 3 }, { 0, 1, 3, 4 }, { 0, 1, 4, 2 } }, facets);
}

Level<3> LastLevel(const StoredStream<3>& stream)
{
  return ExtractLevel(stream, stream.Order.LastStep());
}

} // namespace

// Where solids touch in a vertex or an edge alone, none of its copies can move outward.
TEST(TouchingVertices, AreThoseOfSolidsInOneExterior)
{
  const StoredStream<3> atVertex = SolidsAtAVertex();
  const Level<3> first = ExtractLevel(atVertex, 0);
  EXPECT_EQ(CountTouchingVertices(atVertex, first, CutIntoManifold(atVertex, first)), 2);
  const StoredStream<3> atEdge = SolidsAtAnEdge();
  const Level<3> last = LastLevel(atEdge);
  EXPECT_EQ(CountTouchingVertices(atEdge, last, CutIntoManifold(atEdge, last)), 4);
}

// Where two pits touch, each copy can move into its own pit.
TEST(TouchingVertices, AreNotThoseOfPits)
{
  const StoredStream<3> stream = SolidsAlongTwoEdges();
  const Level<3> level = LastLevel(stream);
  const ManifoldLevel<3> cut = CutIntoManifold(stream, level);
  ASSERT_EQ(std::count(cut.Points.begin(), cut.Points.end(), 1), 2);
  EXPECT_EQ(CountTouchingVertices(stream, level, cut), 0);
}

// Two solids that touch in a vertex get one copy of it each.
TEST(Manifold, CutsAtAVertex)
{
  const StoredStream<3> stream = SolidsAtAVertex();
  const Level<3> level = ExtractLevel(stream, 0);
  EXPECT_EQ(KeepUncut(level).Points.size(), 7u);
  const ManifoldLevel<3> cut = CutIntoManifold(stream, level);
  EXPECT_EQ(cut.Points, (std::vector<int>{ 0, 0, 1, 2, 3, 4, 5, 6 }));
  EXPECT_TRUE(IsClosedManifold(cut));
}

// Two solids that touch in an edge alone are cut apart there.
TEST(Manifold, CutsAtASingleEdge)
{
  const StoredStream<3> stream = SolidsAtAnEdge();
  const Level<3> level = LastLevel(stream);
  ASSERT_EQ(level.Faces.size(), 8u);
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

// Ten thousand solids around an edge, all that they have in common, are cut apart without trying
// all pairs of them, which would take hours.
TEST(Manifold, CutsManyWedgesAroundAnEdgeApart)
{
  constexpr int count = 10000;
  StoredStream<3> stream;
  stream.Mesh.Surface.Points = { { 0, 0, 0 }, { 0, 0, 1 } };
  stream.Order.StepPriority = { 2.0, 1.0 };
  for (int i = 0; i < 2 * count; ++i) // every other one is carved
  {
    const double angle = 3.141592653589793 * i / count;
    stream.Mesh.Surface.Points.push_back({ std::cos(angle), std::sin(angle), 0.5 });
    stream.Mesh.Cells.push_back({ 0, 1, 2 + i, 2 + (i + 1) % (2 * count) });
    stream.Order.Step.push_back(i % 2 == 0 ? Stream::Never : 1);
  }
  ASSERT_TRUE(Connect(stream, {}));
  const ManifoldLevel<3> cut = CutIntoManifold(stream, ExtractLevel(stream, 1));
  EXPECT_EQ(cut.Points.size(), 4u * count);
  EXPECT_EQ(cut.Faces.size(), 4u * count);
  EXPECT_TRUE(IsClosedManifold(cut));
}

// Two solids that touch along two edges in a row stay joined, as a ball: the vertex between the
// edges has a copy on either side of them.
TEST(Manifold, StaysJoinedAlongSeveralEdges)
{
  const StoredStream<3> stream = SolidsAlongTwoEdges();
  const Level<3> level = LastLevel(stream);
  ASSERT_EQ(level.Faces.size(), 12u);
  EXPECT_EQ(MostFacesOnAnEdge(KeepUncut(level)), 4);
  const ManifoldLevel<3> cut = CutIntoManifold(stream, level);
  EXPECT_EQ(cut.Points, (std::vector<int>{ 0, 1, 1, 2, 3, 4, 5, 6 }));
  EXPECT_TRUE(IsClosedManifold(cut));
  const SurfaceTopology topology = MeasureSurface(cut);
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.Genus, 0);
}

// A lid that touches the rim of a hole in edges only stays there: what closes a tunnel of the
// closed set closes it on the surface too.
TEST(Manifold, KeepsALidThatIsHeldByEdges)
{
  // A ring of prisms whose inner edges are those of a triangle; the lid is a double pyramid on it.
  const double s = std::sqrt(3.0) / 2;
  std::vector<Point> points = { { 0, 0, 1 }, { 0, 0, -1 }, { 1, 0, 0 }, { -0.5, s, 0 },
    { -0.5, -s, 0 } };
  for (const double z : { 3.0, -3.0 })
  {
    for (int i = 2; i < 5; ++i)
    {
      points.push_back({ 5 * points[i][0], 5 * points[i][1], z });
    }
  }
  std::vector<std::array<int, 4>> solids = { { 0, 2, 3, 4 }, { 1, 4, 3, 2 } };
  std::vector<std::array<int, 4>> between;
  for (int i = 0; i < 3; ++i)
  {
    const int a = 2 + i, b = 2 + (i + 1) % 3, up = 5 + i, upNext = 5 + (i + 1) % 3;
    solids.push_back({ a, b, up + 3, up });
    solids.push_back({ b, up + 3, up, upNext });
    solids.push_back({ b, up + 3, upNext, upNext + 3 });
    between.push_back({ 0, a, b, up });
    between.push_back({ 0, b, up, upNext });
    between.push_back({ 1, a, b, up + 3 });
    between.push_back({ 1, b, up + 3, upNext + 3 });
  }
  between.push_back({ 0, 5, 6, 7 });
  between.push_back({ 1, 8, 9, 10 });
  const StoredStream<3> stream = Solids(points, solids, between);
  const Level<3> level = LastLevel(stream);
  EXPECT_EQ(MostFacesOnAnEdge(KeepUncut(level)), 4);
  const ManifoldLevel<3> cut = CutIntoManifold(stream, level);
  EXPECT_TRUE(IsClosedManifold(cut));
  EXPECT_EQ(MeasureSurface(cut).Components, 1);
  EXPECT_EQ(MeasureSurface(cut).Genus, 0);
}

// Of three sheets at an edge none is joined with another; each stays whole.
TEST(Manifold, CutsThreeSheetsApart)
{
  const StoredStream<3> stream = Sheets({ { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } });
  const Level<3> level = LastLevel(stream);
  ASSERT_EQ(level.Faces.size(), 3u);
  EXPECT_EQ(CutIntoManifold(stream, level).Points.size(), 9u);
}

// With both of their sides, three sheets at an edge become one closed surface around them.
TEST(Manifold, ClosesThreeSheetsWithBothSides)
{
  StoredStream<3> stream = Sheets({ { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } });
  stream.Folds = FoldSides::Both;
  const Level<3> level = LastLevel(stream);
  ASSERT_EQ(level.Faces.size(), 6u);
  EXPECT_TRUE(IsClosedManifold(CutIntoManifold(stream, level)));
}

// A sheet of two triangles that are oriented alike stays joined, one that is not is cut.
TEST(Manifold, JoinsFoldsThatAreOrientedAlike)
{
  for (const bool alike : { true, false })
  {
    const Triangle second = alike ? Triangle{ 1, 0, 3 } : Triangle{ 0, 1, 3 };
    const StoredStream<3> stream = Sheets({ { 0, 1, 2 }, second });
    const Level<3> level = LastLevel(stream);
    EXPECT_EQ(CutIntoManifold(stream, level).Points.size(), alike ? 4u : 6u);
  }
}
