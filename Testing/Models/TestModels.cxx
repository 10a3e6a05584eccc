// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The models are as their headers describe. Topology is computed from scratch, simplex by simplex.
 */
#include "Core/Mesh/DisjointSets.h"
#include "CrackedModels.h"
#include "Figures.h"
#include "Implicit.h"
#include "PointMath.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using carving::Triangle;
using namespace models;

namespace
{

/** The connected components of a mesh. */
std::vector<TriangleMesh> Components(const TriangleMesh& mesh)
{
  carving::DisjointSets sets(mesh.Points.size());
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    sets.Unite(a, b);
    sets.Unite(b, c);
  }
  std::map<int, TriangleMesh> components;
  std::vector<int> renumbered(mesh.Points.size());
  for (int i = 0; i < static_cast<int>(mesh.Points.size()); ++i)
  {
    std::vector<Point>& points = components[sets.Find(i)].Points;
    renumbered[i] = static_cast<int>(points.size());
    points.push_back(mesh.Points[i]);
  }
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    components[sets.Find(a)].Triangles.push_back({ renumbered[a], renumbered[b], renumbered[c] });
  }
  std::vector<TriangleMesh> result;
  for (const auto& [first, component] : components)
  {
    result.push_back(component);
  }
  return result;
}

int EulerCharacteristic(const TriangleMesh& mesh)
{
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : mesh.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
    }
  }
  return static_cast<int>(mesh.Points.size() + mesh.Triangles.size()) -
    static_cast<int>(edges.size());
}

double SixVolume(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    sum += carving::Dot(mesh.Points[a], carving::Cross(mesh.Points[b], mesh.Points[c]));
  }
  return sum;
}

/** Whether the triangles around every point are one cycle, and the volume inside is positive. */
bool IsSolid(const TriangleMesh& mesh)
{
  // For a point and a neighbor, the neighbor that follows around the point.
  std::map<std::pair<int, int>, int> next;
  std::vector<int> degrees(mesh.Points.size(), 0), neighbors(mesh.Points.size(), -1);
  for (const Triangle& t : mesh.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      if (!next.emplace(std::make_pair(a, b), c).second)
      {
        return false;
      }
      ++degrees[a];
      neighbors[a] = b;
    }
  }
  for (int i = 0; i < static_cast<int>(degrees.size()); ++i)
  {
    int at = neighbors[i], steps = 0;
    for (; const auto step = next.extract({ i, at }); ++steps)
    {
      at = step.mapped();
    }
    if (steps != degrees[i] || at != neighbors[i])
    {
      return false;
    }
  }
  return SixVolume(mesh) > 0.0;
}

void ExpectSolids(const TriangleMesh& mesh, std::size_t number, int genus)
{
  const std::vector<TriangleMesh> solids = Components(mesh);
  EXPECT_EQ(solids.size(), number);
  for (const TriangleMesh& solid : solids)
  {
    EXPECT_TRUE(IsSolid(solid));
    EXPECT_EQ(EulerCharacteristic(solid), 2 - 2 * genus);
  }
}

std::vector<TriangleMesh> AllFigures()
{
  return { TwoSpheres(), EightSpheres(), YuccaLeaves(), Scone(), Ribs(), Tree() };
}

} // namespace

// An isosurface bounds approximately the volume in which the function is negative.
TEST(Implicit, IsosurfaceOfABall)
{
  const TriangleMesh ball = Isosurface([](const Point& p) { return carving::Length(p) - 1.0; },
    { -1.2, -1.3, -1.4 }, { 1.4, 1.3, 1.2 }, { 20, 22, 24 });
  ExpectSolids(ball, 1, 0);
  EXPECT_NEAR(SixVolume(ball) / 6.0, 4.0 / 3.0 * Pi, 0.1);
}

// Smoothing changes the minimum and maximum only where two values are close.
TEST(Implicit, SmoothMinAndMax)
{
  EXPECT_DOUBLE_EQ(SmoothMin(1.0, 1.0, 0.4), 0.9);
  EXPECT_DOUBLE_EQ(SmoothMax(1.0, 1.0, 0.4), 1.1);
  EXPECT_DOUBLE_EQ(SmoothMin(1.0, 1.5, 0.4), 1.0);
  EXPECT_DOUBLE_EQ(SmoothMax(1.0, 1.5, 0.4), 1.5);
}

// A bumpy torus is one solid of genus 1 with nearly as many points as asked for.
TEST(ShapeModels, BumpyTorus)
{
  for (const int points : { 300, 1000, 20000 })
  {
    const TriangleMesh mesh = BumpyTorus(points);
    ExpectSolids(mesh, 1, 1);
    EXPECT_NEAR(static_cast<double>(mesh.Points.size()), points, 0.05 * points);
  }
}

// The solids of the figures are closed, manifold, oriented outward and of the stated genus.
TEST(FigureModels, Solids)
{
  ExpectSolids(TwoSpheres(), 2, 0);
  ExpectSolids(EightSpheres(), 8, 0);
  ExpectSolids(Scone(), 1, SconeGenus);
  ExpectSolids(Ribs(), 1, RibsGenus);
}

// The yucca has 25 leaves, each an open disk, and about as many points and triangles as in Table 1.
TEST(FigureModels, YuccaLeaves)
{
  const TriangleMesh mesh = YuccaLeaves();
  EXPECT_EQ(mesh.Points.size(), 800u);
  EXPECT_EQ(mesh.Triangles.size(), 1200u);
  const std::vector<TriangleMesh> leaves = Components(mesh);
  EXPECT_EQ(leaves.size(), 25u);
  for (const TriangleMesh& leaf : leaves)
  {
    EXPECT_EQ(EulerCharacteristic(leaf), 1);
    EXPECT_FALSE(IsSolid(leaf));
  }
}

// Every part of a tree is a leaf of two triangles or a solid of genus 0.
TEST(FigureModels, Tree)
{
  for (const int leaves : { 1, 300, 19500 })
  {
    int found = 0;
    for (const TriangleMesh& part : Components(Tree(leaves)))
    {
      const bool isLeaf = part.Triangles.size() == 2;
      found += isLeaf;
      EXPECT_EQ(EulerCharacteristic(part), isLeaf ? 1 : 2);
      EXPECT_EQ(IsSolid(part), !isLeaf);
    }
    EXPECT_EQ(found, leaves);
  }
  EXPECT_GE(Tree().Triangles.size(), 60000u);
}

// The points of a figure are distinct and used.
TEST(FigureModels, PointsAreDistinctAndUsed)
{
  for (const TriangleMesh& mesh : AllFigures())
  {
    EXPECT_EQ(std::set<Point>(mesh.Points.begin(), mesh.Points.end()).size(), mesh.Points.size());
    std::set<int> used;
    for (const Triangle& t : mesh.Triangles)
    {
      used.insert(t.begin(), t.end());
    }
    EXPECT_EQ(used.size(), mesh.Points.size());
  }
}

// Every call returns the same mesh.
TEST(FigureModels, AreTheSameEveryTime)
{
  const std::vector<TriangleMesh> first = AllFigures(), second = AllFigures();
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_EQ(first[i].Points, second[i].Points);
    EXPECT_EQ(first[i].Triangles, second[i].Triangles);
  }
}

// The rectangles around voxels enclose as much as the voxels.
TEST(CrackedModels, VoxelsHaveTheirVolume)
{
  std::mt19937_64 random(1);
  for (int n = 1; n < 6; ++n)
  {
    const Voxels voxels = RandomVoxels(n, 0.5, random);
    EXPECT_GT(voxels.Count, 0);
    EXPECT_NEAR(SixVolume(voxels.Surface) / 6.0, voxels.Count, 1e-4);
  }
}

// Hanging nodes add vertices and triangles, but no volume.
TEST(CrackedModels, HangingNodesKeepTheVolume)
{
  std::mt19937_64 random(2);
  const TriangleMesh torus = Torus(1.0, 0.4, 12, 8);
  const TriangleMesh hanging = WithHangingNodes(torus, 2, random);
  EXPECT_GT(hanging.Triangles.size(), 2 * torus.Triangles.size());
  EXPECT_NEAR(SixVolume(hanging), SixVolume(torus), 1e-5);
}
