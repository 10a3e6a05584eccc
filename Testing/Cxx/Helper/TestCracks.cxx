// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Box.h"
#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Validity.h"
#include "Core/Mesh/Vector.h"
#include "Core/Solid/Cracks.h"
#include "HelperRun.h"
#include "RandomModels.h"
#include "Shapes.h"
#include "SolidVolume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

using namespace carving;

// Boxes whose sides do not share edges keep their solid when they are turned and rounded, which
// opens cracks along these edges; exactly and enclosed, by both rules, and inside out.
TEST(Cracks, LeaveTheSolidClosed)
{
  const std::array<int, 6> counts[] = { { 3, 1, 1, 1, 1, 1 }, { 3, 2, 4, 1, 2, 3 },
    { 2, 3, 4, 5, 7, 6 } };
  std::mt19937_64 random(1);
  int sealed = 0;
  for (int i = 0; i < 12; ++i)
  {
    TriangleMesh box = models::Rotated(models::PatchedBox({ 3, 2, 1 }, counts[i % 3]), random);
    box = i % 2 == 0 ? box : models::InSinglePrecision(box);
    Job job;
    job.Mesh = i % 4 < 2 ? box : models::Flipped(box);
    job.Conformity = i % 6 == 5 ? Conformity::Enclosing : Conformity::Auto;
    job.EnclosingTolerance = 0.02;
    for (const SolidRule rule : { SolidRule::NonzeroWinding, SolidRule::EvenOdd })
    {
      job.Solid = rule;
      Tetrahedralization mesh = GetReply(job).Result;
      sealed += SealCracks(mesh, rule, 1) > 0;
      EXPECT_EQ(FindMistake(mesh), "");
      const double volume = VolumeOfSolid(mesh, Classify(mesh, rule));
      EXPECT_NEAR(volume, 6.0, job.Conformity == Conformity::Enclosing ? 0.3 : 1e-4) << i;
      EXPECT_EQ(SealCracks(mesh, rule, 1), 0) << "all have been sealed";
    }
  }
  EXPECT_GT(sealed, 12);
}

// The seals have hardly any area, and take over the sources of facets that they touch.
TEST(Cracks, AreClosedByThinFacets)
{
  std::mt19937_64 random(2);
  Job job;
  job.Mesh = models::Rotated(models::PatchedBox({ 3, 2, 1 }, { 3, 1, 1, 1, 1, 1 }), random);
  job.Conformity = Conformity::Auto;
  Tetrahedralization mesh = GetReply(job).Result;
  const std::size_t own = mesh.Surface.Facets.size();
  const int seals = SealCracks(mesh, SolidRule::NonzeroWinding, 1);
  ASSERT_GT(seals, 0);
  ASSERT_EQ(mesh.Surface.Facets.size(), own + seals);
  double area = 0.0;
  for (std::size_t f = own; f < mesh.Surface.Facets.size(); ++f)
  {
    const Triangle& seal = mesh.Surface.Facets[f];
    const auto corners = CornersOf<3>(mesh.Surface.Points, seal);
    area += Length(Cross(corners[1] - corners[0], corners[2] - corners[0])) / 2.0;
    bool touches = false;
    for (std::size_t other = 0; other < own; ++other)
    {
      const Triangle& t = mesh.Surface.Facets[other];
      touches = touches ||
        (mesh.Surface.FacetSources[other] == mesh.Surface.FacetSources[f] &&
          std::find_first_of(t.begin(), t.end(), seal.begin(), seal.end()) != t.end());
    }
    EXPECT_TRUE(touches) << f;
  }
  EXPECT_LT(area, 1e-10);
}

// A hole stays open whose rim has edges that are shorter than a crack is wide: a box without a
// side, much smaller than the mesh.
TEST(Cracks, AreNoHolesWithFineRims)
{
  TriangleMesh box = models::PatchedBox({ 1, 1, 1 }, { 40, 40, 40, 40, 40, 40 });
  box.Triangles.resize(box.Triangles.size() - 2 * 40 * 40); // the last side
  const TriangleMesh far = { { { 2e4, 0, 0 }, { 0, 3e4, 0 }, { 0, 0, -4e4 } }, { { 0, 1, 2 } } };
  Tetrahedralization mesh = GetReply(models::Joined(box, far)).Result;
  ASSERT_LT(1.0 / 40, MostCrackWidth * Diagonal(mesh.Surface.Points));
  EXPECT_EQ(SealCracks(mesh, SolidRule::NonzeroWinding, 1), 0);
  EXPECT_EQ(VolumeOfSolid(mesh, Classify(mesh)), 0.0);
}

// A slit that is wider than a crack lets the outside in, however large C0 is.
TEST(Cracks, AreNoWideSlits)
{
  TriangleMesh box = models::PatchedBox({ 3, 2, 1 }, { 1, 1, 1, 1, 1, 1 });
  for (std::size_t i = 0; i < 4; ++i)
  {
    box.Points[i][0] -= 1e-3; // the first side
  }
  Job job;
  job.Mesh = box;
  Job within = job;
  within.Initial = InitialApproximation::Custom;
  within.InitialMesh = models::Box({ -1e4, -1e4, -1e4 }, { 1e4, 1e4, 1e4 });
  for (const Job& each : { job, within })
  {
    Tetrahedralization mesh = GetReply(each).Result;
    EXPECT_EQ(SealCracks(mesh, SolidRule::NonzeroWinding, 1), 0);
    EXPECT_EQ(VolumeOfSolid(mesh, Classify(mesh)), 0.0);
  }
}
