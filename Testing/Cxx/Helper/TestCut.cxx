// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Enclosing mode with a tolerance: tetrahedra are cut along triangles, and what is kept is halved.
 */
#include "Blocks.h"
#include "Checks.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Cutting/Chains.h"
#include "Helper/Cutting/Cut.h"
#include "Helper/Cutting/HalveKept.h"
#include "Helper/Enclosing/ExposedFaces.h"
#include "Helper/Resolve/Clean.h"
#include "HelperRun.h"
#include "PiercedMeshCheck.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

using namespace carving;
using namespace carving::helper;

namespace
{

PiercedMesh MakePierced(const ResolvedMesh& input)
{
  return PiercedMesh(input, {}, 2, Proceed);
}

/** The faces that are parts, each once. */
std::vector<Triangle> FindFaces(const PiercedMesh& mesh)
{
  const std::vector<Subdivision::Part>& parts = mesh.GetParts().GetParts();
  std::map<Triangle, Triangle> faces; // by sorted corners
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (parts[i].Parent >= 0 && mesh.IsFace(static_cast<int>(i)))
    {
      Triangle sorted = parts[i].Corners;
      std::sort(sorted.begin(), sorted.end());
      faces[sorted] = parts[i].Corners;
    }
  }
  std::vector<Triangle> all;
  for (const auto& [sorted, face] : faces)
  {
    all.push_back(face);
  }
  return all;
}

double AreaOf(const std::vector<Point>& points, const Triangle& t)
{
  return Length(Cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])) / 2.0;
}

TriangleMesh RandomTriangles(std::size_t count, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  TriangleMesh mesh;
  for (int i = 0; i < static_cast<int>(count); ++i)
  {
    mesh.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    for (int corner = 0; corner < 3; ++corner)
    {
      mesh.Points.push_back({ coordinate(random), coordinate(random), coordinate(random) });
    }
  }
  return mesh;
}

/** Turns a mesh around two axes. */
TriangleMesh Turned(TriangleMesh mesh, double a, double b)
{
  for (auto& [x, y, z] : mesh.Points)
  {
    std::tie(x, y) =
      std::pair(std::cos(a) * x - std::sin(a) * y, std::sin(a) * x + std::cos(a) * y);
    std::tie(y, z) =
      std::pair(std::cos(b) * y - std::sin(b) * z, std::sin(b) * y + std::cos(b) * z);
  }
  return mesh;
}

/** The triangles of M that have a part which pierces a cell. */
std::set<int> FindUnmet(const PiercedMesh& mesh)
{
  std::set<int> unmet;
  for (const PiercedMesh::Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    for (const PartContact& contact : cell->info().All)
    {
      if (contact.How.Pierces)
      {
        unmet.insert(mesh.GetParts().GetParts()[contact.Part].Parent);
      }
    }
  }
  return unmet;
}

/** The largest distance from a mesh of sample points on the exposed faces of kept tetrahedra. */
double SampleReach(const TriangleMesh& mesh, const Tetrahedralization& result)
{
  const std::vector<Point>& points = result.Surface.Points;
  double farthest = 0.0;
  for (std::size_t cell = 0; cell < result.Cells.size(); ++cell)
  {
    for (int f = 0; f < 4 && result.Kept[cell]; ++f)
    {
      const int other = result.Neighbors[cell][f];
      if (other >= 0 && result.Kept[other])
      {
        continue;
      }
      const auto [a, b, c] = result.OutwardFace(static_cast<int>(cell), f);
      for (const auto& [u, v] : { std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(0.0, 1.0),
             std::pair(0.5, 0.0), std::pair(0.0, 0.5), std::pair(0.5, 0.5), std::pair(0.33, 0.33) })
      {
        const Point p = (1.0 - u - v) * points[a] + u * points[b] + v * points[c];
        farthest = std::max(farthest, checks::DistanceTo(mesh.Points, mesh.Triangles, p));
      }
    }
  }
  return farthest;
}

} // namespace

// Nearly all random triangles that cross each other become unions of faces: their parts have the
// triangles' areas, lie on them, and do not cross; the tetrahedra fill the hull.
TEST(Cut, MeetsTrianglesThatCross)
{
  std::mt19937_64 random(21);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_CUTS", 60);
  std::size_t all = 0, met = 0;
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("soup " + std::to_string(i));
    const ResolvedMesh input = Clean(AsResolved(RandomTriangles(2 + random() % 15, random)));
    PiercedMesh mesh = MakePierced(input);
    const double volume = SixVolumeOf(mesh);
    mesh.GiveParts(Cut(mesh, 1e-12, { 1000000, 100000 }, 2, Proceed), 2, Proceed);
    EXPECT_NEAR(SixVolumeOf(mesh), volume, 1e-9 * volume);
    all += input.Facets.size();
    met += input.Facets.size() - FindUnmet(mesh).size();
    const auto& points = mesh.GetParts().GetPoints();
    EXPECT_EQ(checks::CountCrossings(points, FindFaces(mesh)), 0);
    std::vector<double> areas(input.Facets.size(), 0.0);
    for (const auto& [corners, parent] : mesh.GetParts().GetParts())
    {
      if (parent >= 0)
      {
        areas[parent] += AreaOf(points, corners);
        for (const int corner : corners)
        {
          EXPECT_LT(
            checks::DistanceTo(input.Points, { input.Facets[parent] }, points[corner]), 1e-11);
        }
      }
    }
    for (std::size_t t = 0; t < areas.size(); ++t)
    {
      EXPECT_NEAR(areas[t], AreaOf(input.Points, input.Facets[t]), 1e-9);
    }
  }
  EXPECT_GE(met, all * 99 / 100);
}

// Nearly all triangles that overlap in a plane are met, too, in whatever direction the plane is,
// unless it is that of a side of the hull.
TEST(Cut, MeetsTrianglesThatOverlapInAPlane)
{
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> angle(0.0, 3.0);
  std::size_t all = 0, met = 0;
  const TriangleMesh boxes = models::Joined(
    models::Box({ 0, 0, 0 }, { 2, 2, 1 }), models::Box({ 0.7, 0.9, 0.25 }, { 3, 3, 1 }));
  for (int i = 0; i < 10; ++i)
  {
    SCOPED_TRACE("direction " + std::to_string(i));
    const TriangleMesh turned = Turned(boxes, angle(random), angle(random));
    PiercedMesh mesh = MakePierced(
      Clean(AsResolved(models::Joined(turned, models::Box({ -9, -8, -7 }, { 9, 8, 7 })))));
    mesh.GiveParts(Cut(mesh, 1e-11, { 1000000, 100000 }, 2, Proceed), 2, Proceed);
    all += 3 * 12; // three boxes
    met += 3 * 12 - FindUnmet(mesh).size();
  }
  EXPECT_GE(met, all * 97 / 100);
}

// Cutting ends, and keeps the mesh valid, where vertices nearly coincide: both sides of a corner go
// through such a vertex, and rounding decides which vertex is nearer to the other end of a side.
TEST(Cut, EndsAtNearlyCoincidentVertices)
{
  std::mt19937_64 random(25);
  std::uniform_real_distribution<double> offset(-1e-14, 1e-14);
  for (int i = 0; i < 40; ++i)
  {
    SCOPED_TRACE("soup " + std::to_string(i));
    TriangleMesh soup = RandomTriangles(12, random);
    for (Point& p : soup.Points)
    {
      if (random() % 2 == 0)
      {
        const Point& other = soup.Points[random() % soup.Points.size()];
        p = other + Point{ offset(random), offset(random), offset(random) };
      }
    }
    const ResolvedMesh input = Clean(AsResolved(soup));
    PiercedMesh mesh = MakePierced(input);
    const double volume = SixVolumeOf(mesh);
    mesh.GiveParts(Cut(mesh, 1e-12, { 1000000, 100000 }, 2, Proceed), 2, Proceed);
    EXPECT_NEAR(SixVolumeOf(mesh), volume, 1e-9 * volume);
    EXPECT_EQ(checks::CountCrossings(mesh.GetParts().GetPoints(), FindFaces(mesh)), 0);
  }
}

// A triangle that pierces nothing, since its plane is triangulated in another way, becomes a face.
TEST(Cut, MakesFacesOfCoveredTriangles)
{
  for (const bool otherDiagonals : { false, true })
  {
    TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 2, 3 });
    for (std::size_t i = 0; i < box.Triangles.size() && otherDiagonals; i += 2)
    {
      const auto [a, b, c] = box.Triangles[i];
      const int d = box.Triangles[i + 1][2];
      box.Triangles[i] = { a, b, d };
      box.Triangles[i + 1] = { b, c, d };
    }
    PiercedMesh mesh = MakePierced(Clean(AsResolved(box)));
    mesh.GiveParts(Cut(mesh, 1e-12, { 1000, 1000 }, 2, Proceed), 2, Proceed);
    EXPECT_EQ(mesh.FindMissing(), std::vector<int>());
    EXPECT_NEAR(SixVolumeOf(mesh), 36.0, 1e-9);
  }
}

// Cutting keeps every tetrahedron oriented positively, and the hull filled, whatever is degenerate.
TEST(Cut, KeepsTheMeshValid)
{
  std::mt19937_64 random(24);
  for (int i = 0; i < 30; ++i)
  {
    SCOPED_TRACE("soup " + std::to_string(i));
    const ResolvedMesh input =
      Clean(AsResolved(models::Soup(2 + static_cast<int>(random() % 30), random)));
    PiercedMesh mesh = MakePierced(input);
    const double volume = SixVolumeOf(mesh);
    mesh.GiveParts(
      Cut(mesh, 1e-12 * Diagonal(input.Points), { 1000000, 100000 }, 2, Proceed), 2, Proceed);
    EXPECT_NEAR(SixVolumeOf(mesh), volume, 1e-9 * volume);
    EXPECT_TRUE(
      std::equal(input.Points.begin(), input.Points.end(), mesh.GetParts().GetPoints().begin()));
  }
}

// With a limit of no effort, every triangle stays as it was.
TEST(Cut, RespectsItsLimit)
{
  std::mt19937_64 random(23);
  const ResolvedMesh input = Clean(AsResolved(models::Soup(10, random)));
  PiercedMesh mesh = MakePierced(input);
  const std::set<int> before = FindUnmet(mesh);
  mesh.GiveParts(Cut(mesh, 1e-12, { 0, 100000 }, 2, Proceed), 2, Proceed);
  EXPECT_EQ(FindUnmet(mesh), before);
  EXPECT_EQ(mesh.GetParts().GetPoints(), input.Points);
}

// A chain follows what happens to its links and vertices, and ends with the last need for it.
TEST(Chains, FollowTheMesh)
{
  Chains chains;
  chains.Need(0, 1);
  chains.Need(1, 0);
  chains.Add({ 0, 1 });
  chains.Split(1, 0, 5);
  chains.Split(5, 1, 6);
  std::vector<int> between;
  chains.Append(1, 0, between);
  EXPECT_EQ(between, (std::vector<int>{ 6, 5 }));
  EXPECT_TRUE(chains.IsLink(6, 5));
  EXPECT_TRUE(chains.MayMove(5, 0));
  EXPECT_FALSE(chains.MayMove(5, 1));
  EXPECT_TRUE(chains.MayMove(7, 1)); // in no chain
  chains.Remove(5);
  EXPECT_FALSE(chains.IsLink(6, 5));
  EXPECT_TRUE(chains.IsLink(0, 6));
  chains.Release(0, 1);
  EXPECT_TRUE(chains.Has(0, 1));
  chains.Release(0, 1);
  EXPECT_FALSE(chains.Has(0, 1));
  EXPECT_FALSE(chains.IsLink(0, 6));
}

// Halving brings the surface of what is kept within the tolerance of the mesh.
TEST(HalveKept, ReachesTheTolerance)
{
  std::mt19937_64 random(11);
  for (int i = 0; i < 12; ++i)
  {
    SCOPED_TRACE("soup " + std::to_string(i));
    const ResolvedMesh input =
      Clean(AsResolved(models::Soup(4 + static_cast<int>(random() % 20), random)));
    const double length = Diagonal(input.Points);
    const double tolerance = std::array{ 0.03, 0.06, 0.12 }[random() % 3] * length;
    PiercedMesh mesh = MakePierced(input);
    const double volume = SixVolumeOf(mesh);
    const SurfaceDistance distance(input);
    HalveKept(mesh, distance, tolerance, 1000000, 2, Proceed);
    EXPECT_LE(MeasureKept(mesh, distance, 1e-4 * length, length, 2).Maximum, 1.05 * tolerance);
    EXPECT_NEAR(SixVolumeOf(mesh), volume, 1e-9 * volume);
  }
}

// The reported distance of kept tetrahedra is correct and within the tolerance.
TEST(Enclose, StaysWithinTheTolerance)
{
  std::mt19937_64 random(12);
  const TriangleMesh mesh = models::Soup(40, random);
  const Reply reply = GetReply(mesh, Conformity::Enclosing, 0.02);
  EXPECT_LE(reply.KeptDistance, 1.05 * 0.02 * Diagonal(mesh.Points));
  EXPECT_LE(SampleReach(mesh, reply.Result), 1.05 * reply.KeptDistance);
}

// Finely tessellated walls that touch in parts of their sides, and are off their planes by a
// rounding, are enclosed within the tolerance.
TEST(Enclose, EnclosesFlatWalls)
{
  const TriangleMesh mesh = models::Blocks(12);
  const Reply reply = GetReply(mesh, Conformity::Enclosing, 0.02);
  EXPECT_EQ(reply.Error, "");
  EXPECT_LE(reply.KeptDistance, 1.05 * 0.02 * Diagonal(mesh.Points));
  EXPECT_LE(SampleReach(mesh, reply.Result), 1.05 * reply.KeptDistance);
}

// The tolerance 0 adds no vertex; otherwise, all vertices that are not the mesh's are counted.
TEST(Enclose, AddsVerticesOnlyIfTold)
{
  std::mt19937_64 random(12);
  const TriangleMesh mesh = models::Soup(10, random);
  for (const double tolerance : { 0.0, 0.02 })
  {
    const Reply reply = GetReply(mesh, Conformity::Enclosing, tolerance);
    const ResolvedMesh& surface = reply.Result.Surface;
    EXPECT_EQ(
      std::count(surface.PointSources.begin(), surface.PointSources.end(), -1), reply.PointsAdded);
    EXPECT_EQ(reply.PointsAdded > 0, tolerance > 0.0);
    EXPECT_LE(SampleReach(mesh, reply.Result), 1.05 * reply.KeptDistance);
  }
}

// A mesh all of whose triangles are Delaunay faces gets no further vertex.
TEST(Enclose, AddsNothingToADelaunayMesh)
{
  const Reply reply = GetReply(
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 3, 0, 0 }, { 4, 1, 1 })),
    Conformity::Enclosing, 0.001);
  EXPECT_EQ(reply.PointsAdded, 0);
  EXPECT_EQ(reply.KeptDistance, 0.0);
}
