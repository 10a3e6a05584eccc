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

StreamTopology Compute(
  const Tetrahedralization& mesh, const Stream& stream, SolidRule rule = SolidRule::NonzeroWinding)
{
  return ComputeTopology(mesh, Classify(mesh, rule), stream);
}

} // namespace

// What is left of a row of tetrahedra is one piece without tunnels and voids, whatever has been
// carved.
TEST(StreamTopology, OfARowIsTrivial)
{
  const Tetrahedralization mesh = small::Row(5);
  const StreamTopology topology = Compute(mesh, small::Carved(mesh, small::OneByOne()));
  EXPECT_EQ(topology.Components, std::vector<int>(6, 1));
  EXPECT_EQ(topology.Tunnels, std::vector<int>(6, 0));
  EXPECT_EQ(topology.Voids, std::vector<int>(6, 0));
}

// A shell around a solid: carving the void between them ends with two components and one void; of
// the surfaces alone, without solid, with two voids.
TEST(StreamTopology, OfAShellEndsInItsVoid)
{
  const Tetrahedralization mesh = small::NestedTetrahedra(
    small::Joined(small::InnerFaces(), small::Flipped(small::OuterFaces())));
  const SolidRule rule = SolidRule::SurfaceOnly;
  const StreamTopology topology = Compute(mesh, small::Carved(mesh, {}, rule), rule);
  EXPECT_EQ(topology.Components.front(), 1);
  EXPECT_EQ(topology.Components.back(), 2);
  EXPECT_EQ(topology.Tunnels.back(), 0);
  EXPECT_EQ(topology.Voids.front(), 0);
  EXPECT_EQ(topology.Voids.back(), 2);
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
    const StreamTopology topology = Compute(mesh, stream);
    for (int step = 0; step <= stream.LastStep(); ++step)
    {
      EXPECT_EQ((homology::BettiNumbers{
                  topology.Components[step], topology.Tunnels[step], topology.Voids[step], 0 }),
        homology::ComputeBettiNumbers(homology::ClosedComplex(mesh, stream, step)));
    }
  }
}
