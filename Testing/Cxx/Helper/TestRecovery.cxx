// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Recovery of triangles in a Delaunay tetrahedralization.
 */
#include "Figures.h"
#include "Helper/Base/Kernels.h"
#include "Helper/Exact/Hull.h"
#include "Helper/Recovery/Filling.h"
#include "Helper/Recovery/NearDelaunay.h"
#include "Helper/Recovery/RecoverAll.h"
#include "Helper/Resolve/Clean.h"
#include "RandomModels.h"
#include "Resolved.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace carving;
using namespace carving::helper;

namespace
{

/** Checks independently of the search: orientation, volume, neighbors, and triangles as faces. */
void ExpectExact(const Tetrahedralization& mesh)
{
  const auto at = [&](int i) { return ToInexact(mesh.Surface.Points[i]); };
  std::vector<char> found(mesh.Surface.Facets.size(), 0);
  for (int i = 0; i < static_cast<int>(mesh.Cells.size()); ++i)
  {
    const auto& [a, b, c, d] = mesh.Cells[i];
    EXPECT_EQ(CGAL::orientation(at(a), at(b), at(c), at(d)), CGAL::POSITIVE);
    for (int f = 0; f < 4; ++f)
    {
      Triangle face = mesh.OutwardFace(i, f);
      std::sort(face.begin(), face.end());
      const int neighbor = mesh.Neighbors[i][f];
      for (const int corner : face)
      {
        EXPECT_TRUE(neighbor < 0 ||
          std::count(mesh.Cells[neighbor].begin(), mesh.Cells[neighbor].end(), corner) == 1);
      }
      if (const int constraint = mesh.Constraints.Get(i, f); constraint >= 0)
      {
        Triangle facet = mesh.Surface.Facets[constraint];
        std::sort(facet.begin(), facet.end());
        EXPECT_EQ(face, facet);
        found[constraint] = 1;
      }
    }
  }
  EXPECT_TRUE(FillsHull(mesh));
  EXPECT_EQ(std::count(found.begin(), found.end(), 0), 0);
}

std::string Recover(RecoveryEffort effort, Tetrahedralization& mesh)
{
  const auto progress = [](double) { return true; };
  return RecoverAll({}, effort, 2, progress, mesh).Mistake;
}

Tetrahedralization Recovered(
  const TriangleMesh& given, RecoveryEffort effort = RecoveryEffort::Much)
{
  Tetrahedralization mesh;
  mesh.Surface = Resolved(given);
  EXPECT_EQ(Recover(effort, mesh), "");
  return mesh;
}

} // namespace

// Every triangle of a mesh without crossings becomes a face, and no given point moves.
TEST(Recovery, MeetsFigures)
{
  for (const TriangleMesh& model : { models::TwoSpheres(), models::Scone(), models::YuccaLeaves() })
  {
    const Tetrahedralization mesh = Recovered(model);
    ExpectExact(mesh);
    const ResolvedMesh given = Resolved(model);
    EXPECT_TRUE(std::equal(given.Points.begin(), given.Points.end(), mesh.Surface.Points.begin()));
    EXPECT_EQ(given.Facets, mesh.Surface.Facets);
  }
}

// On the hull, a diagonal of a flat side is swapped for the one of the mesh.
TEST(Recovery, SwapsDiagonalsOfTheHull)
{
  for (const bool flip : { false, true })
  {
    TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
    for (Point& p : box.Points)
    {
      p[0] = flip ? 1.0 - p[0] : p[0]; // mirrors the diagonals
    }
    ExpectExact(Recovered(box));
  }
}

// Meshes of well-shaped triangles are near Delaunay, and little effort meets them. After a shear,
// which makes angles obtuse, they are not.
TEST(Recovery, TakesLittleEffortNearDelaunay)
{
  const TriangleMesh sphere = models::Sphere(4);
  const TriangleMesh model = models::Joined(sphere, models::Moved(sphere, { 3.0, 1.0, 0.0 }));
  EXPECT_TRUE(IsNearDelaunay(Resolved(model)));
  ExpectExact(Recovered(model, RecoveryEffort::Little));
  EXPECT_FALSE(IsNearDelaunay(Resolved(models::Sheared(model))));
}

// Edges between triangles tell nothing about a mesh of leaves, most of whose edges are on the
// border.
TEST(Recovery, IsNotTriedFirstOnLeaves)
{
  EXPECT_FALSE(IsNearDelaunay(Resolved(models::Tree(2000))));
}

// With much effort, recovery meets closed meshes of which the Delaunay tetrahedralization lacks
// many triangles.
TEST(Recovery, TakesMuchEffortFarFromDelaunay)
{
  ExpectExact(Recovered(models::Sheared(models::Sphere(4))));
  ExpectExact(Recovered(models::CloseSpheres()));
}

// With little effort, recovery gives up on sheets closer to each other than their points, and says
// how many triangles it lacks.
TEST(Recovery, GivesUpEarlyWithLittleEffort)
{
  const ResolvedMesh given = Resolved(models::CloseSpheres());
  EXPECT_TRUE(IsNearDelaunay(given));
  Tetrahedralization mesh;
  mesh.Surface = given;
  EXPECT_EQ(Recover(RecoveryEffort::Little, mesh).find("recovery lacks "), 0u);
  EXPECT_TRUE(mesh.Cells.empty());
  EXPECT_EQ(mesh.Surface.Points, given.Points);
}

// Recovery either meets a random mesh exactly or says how many triangles it lacks. It lacks few.
TEST(Recovery, MeetsRandomMeshes)
{
  std::mt19937_64 random(21);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_RECOVERIES", 30);
  int met = 0;
  for (int i = 0; i < count; ++i)
  {
    SCOPED_TRACE("mesh " + std::to_string(i));
    Tetrahedralization mesh;
    mesh.Surface = Resolved(models::MakeRandom(random).Mesh);
    if (Recover(RecoveryEffort::Much, mesh).empty())
    {
      ++met;
      ExpectExact(mesh);
    }
  }
  EXPECT_GE(met, count * 9 / 10);
  RecordProperty("Met", met);
}

// Schönhardt's polyhedron, a twisted prism, cannot be filled without a further point.
TEST(Recovery, RefusesSchoenhardtsPolyhedronWithoutPoints)
{
  Cavity cavity;
  for (int i = 0; i < 6; ++i)
  {
    const double angle = (i % 3) * 2.0943951 + (i / 3) * 0.5235988;
    cavity.AddPoint({ std::cos(angle), std::sin(angle), i / 3 * 1.0 }, true, false);
  }
  cavity.Front = { { 0, 1, 2 }, { 3, 5, 4 } };
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    cavity.Front.push_back({ i, next + 3, next });
    cavity.Front.push_back({ i, i + 3, next + 3 });
  }
  std::ptrdiff_t steps = 100000;
  Filling without(cavity);
  EXPECT_FALSE(without.Run(steps));
  EXPECT_GT(steps, 0);
  cavity.AddPoint({ 0.0, 0.0, 0.5 }, false, false);
  Filling with(cavity);
  EXPECT_TRUE(with.Run(steps));
  EXPECT_EQ(with.GetCells().size(), cavity.Front.size()); // a cell per face, around the point
}
