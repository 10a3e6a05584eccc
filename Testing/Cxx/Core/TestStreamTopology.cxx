// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Components, tunnels and voids of streams that are small enough to be worked out by hand.
 */
#include "Core/Measure/StreamTopology.h"
#include "Homology.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

using namespace carving;

namespace
{

Profile MakeProfile(
  const Tetrahedralization& mesh, const Stream& stream, SolidRule rule = SolidRule::NonzeroWinding)
{
  Profile profile;
  SetTopology(profile, mesh, Classify(mesh, rule), stream);
  return profile;
}

} // namespace

// What is left of a row of tetrahedra is one piece without tunnels and voids, whatever has been
// carved.
TEST(StreamTopology, OfARowIsTrivial)
{
  const Tetrahedralization mesh = small::Row(5);
  const Profile profile = MakeProfile(mesh, small::Carved(mesh, small::OneByOne()));
  EXPECT_EQ(profile.Components, std::vector<int>(6, 1));
  EXPECT_EQ(profile.Tunnels, std::vector<int>(6, 0));
  EXPECT_EQ(profile.Voids, std::vector<int>(6, 0));
}

// A shell around a solid: carving the void between them ends with two components and one void; of
// the surfaces alone, without solid, with two voids.
TEST(StreamTopology, OfAShellEndsInItsVoid)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(
    small::Joined(small::InnerFaces(), small::Flipped(small::OuterFaces())));
  const SolidRule rule = SolidRule::SurfaceOnly;
  const Profile profile = MakeProfile(mesh, small::Carved(mesh, {}, rule), rule);
  EXPECT_EQ(profile.Components.front(), 1);
  EXPECT_EQ(profile.Components.back(), 2);
  EXPECT_EQ(profile.Tunnels.back(), 0);
  EXPECT_EQ(profile.Voids.front(), 0);
  EXPECT_EQ(profile.Voids.back(), 2);
}

// Every step of small streams has the Betti numbers that the ranks of boundary matrices give.
TEST(StreamTopology, AgreesWithBoundaryMatrices)
{
  const auto inner = small::InnerFaces();
  for (const Tetrahedralization& mesh : { small::Row(6), small::NestedTetrahedra(inner),
         small::NestedTetrahedra(small::Joined(inner, small::Flipped(small::OuterFaces()))),
         small::NestedTetrahedra(small::OuterFaces()), small::NestedTetrahedra({ inner[0] }) })
  {
    const Stream stream = small::Carved(mesh, small::OneByOne());
    const Profile profile = MakeProfile(mesh, stream);
    for (int step = 0; step <= stream.LastStep(); ++step)
    {
      EXPECT_EQ((homology::BettiNumbers{
                  profile.Components[step], profile.Tunnels[step], profile.Voids[step], 0 }),
        homology::ComputeBettiNumbers(homology::ClosedComplex(mesh, stream, step)));
    }
  }
}
