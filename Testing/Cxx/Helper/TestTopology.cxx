// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The profile's components, tunnels and voids of models, of real meshes and in the plane.
 * TestProperties.cxx has the random meshes.
 */
#include "Core/Measure/LevelSelection.h"
#include "Core/Measure/StreamTopology.h"
#include "Core/Mesh/BettiNumbers.h"
#include "Figures.h"
#include "HelperRun.h"
#include "Homology.h"
#include "PropertyChecks.h"
#include "RealMeshes.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace carving;

namespace
{

/** Expects the right topology at the steps of ten levels. */
Profile ExpectTopologyOfTenSteps(const Carved& carved)
{
  const std::vector<int> steps = SpreadLevels(carved.Profile, 10);
  EXPECT_EQ(steps.size(), 10u);
  for (const int step : steps)
  {
    ExpectTopology(carved, step);
  }
  return carved.Profile;
}

/** Concentric spheres of these radii; from the outside, solid and hollow alternate. */
TriangleMesh NestedShells(const std::vector<double>& radii)
{
  TriangleMesh mesh;
  bool solid = true;
  for (const double radius : radii)
  {
    const TriangleMesh sphere = models::Moved(models::Sphere(2), { 0, 0, 0 }, radius);
    mesh = models::Joined(mesh, solid ? sphere : models::Flipped(sphere));
    solid = !solid;
  }
  return mesh;
}

} // namespace

// The cheese ends as one component with many tunnels. A target of tunnels picks a step with no more
// tunnels, followed by a step with more.
TEST(Topology, OfCheese)
{
  const TriangleMesh mesh = ReadRealMesh("cheese.off");
  const Carved carved = CarveResult(GetReply(mesh).Result);
  const Profile profile = ExpectTopologyOfTenSteps(carved);
  EXPECT_EQ(profile.Components.back(), 1);
  EXPECT_EQ(profile.Tunnels.back(), GenusOf(mesh));
  EXPECT_EQ(profile.Voids.back(), 0);
  for (const int tunnels : { 0, 10, 50 })
  {
    const int step = SelectStep(profile, LevelTarget::Tunnels, tunnels).Step;
    ExpectTopology(carved, step);
    EXPECT_LE(profile.Tunnels[step], tunnels);
    ExpectTopology(carved, step + 1);
    EXPECT_GT(profile.Tunnels[step + 1], tunnels);
  }
}

// Bones that cross each other have the Betti numbers of boundary matrices.
TEST(Topology, OfBones)
{
  ExpectTopologyOfTenSteps(CarveResult(GetReply(ReadRealMesh("bones.off")).Result));
}

// Eight spheres end as eight components.
TEST(Topology, OfEightSpheres)
{
  const Profile profile =
    ExpectTopologyOfTenSteps(CarveResult(GetReply(models::EightSpheres()).Result));
  EXPECT_EQ(profile.Components.back(), 8);
  EXPECT_EQ(profile.Tunnels.back(), 0);
  EXPECT_EQ(profile.Voids.back(), 0);
}

// Two nested shells around a ball have three components and two voids.
TEST(Topology, OfNestedShells)
{
  const Profile profile = ExpectTopologyOfTenSteps(
    CarveResult(GetReply(NestedShells({ 3.0, 2.6, 2.2, 1.8, 1.0 })).Result));
  EXPECT_EQ(profile.Components.back(), 3);
  EXPECT_EQ(profile.Tunnels.back(), 0);
  EXPECT_EQ(profile.Voids.back(), 2);
}

// In the plane, tunnels are holes: two nested rings around a disk have three components and two
// holes.
TEST(Topology, OfContoursCountsHoles)
{
  Job job;
  job.Kind = JobKind::Triangulate;
  int sign = 1;
  for (const double radius : { 3.0, 2.6, 2.2, 1.8, 1.0 })
  {
    const int first = static_cast<int>(job.Contours.Points.size()), count = 24;
    for (int i = 0; i < count; ++i)
    {
      const double angle = sign * 2.0 * M_PI * i / count;
      job.Contours.Points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.0 });
      job.Contours.Edges.push_back({ first + i, first + (i + 1) % count });
    }
    sign = -sign;
  }
  const Reply reply = GetReply(job);
  const Decomposition<2>& mesh = reply.Plane;
  const Classification regions = Classify(mesh);
  Stream stream;
  Carve(mesh, regions, {}, stream);
  const StreamTopology topology = ComputeTopology(mesh, regions, stream);
  for (int step = 0; step <= stream.LastStep(); ++step)
  {
    EXPECT_EQ((homology::BettiNumbers{
                topology.Components[step], topology.Tunnels[step], topology.Voids[step], 0 }),
      homology::ComputeBettiNumbers(homology::ClosedComplex(mesh, stream, step)));
  }
  EXPECT_EQ(topology.Components.back(), 3);
  EXPECT_EQ(topology.Tunnels.back(), 2);
}
