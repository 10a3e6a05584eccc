// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Streams show the behavior of the paper's figures.
 */
#include "Figures.h"
#include "HelperRun.h"
#include "PropertyChecks.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace carving;

namespace
{

Profile MakeProfile(const TriangleMesh& given, double depthExponent)
{
  CarveOptions options;
  options.DepthExponent = depthExponent;
  return CarveResult(GetReply(given).Result, options).Profile;
}

/** The share of steps with one component and the given number of tunnels. */
double ShareOfSteps(const Profile& profile, int tunnels)
{
  int steps = 0;
  for (std::size_t i = 0; i < profile.Tunnels.size(); ++i)
  {
    steps += profile.Components[i] == 1 && profile.Tunnels[i] == tunnels;
  }
  return static_cast<double>(steps) / profile.Tunnels.size();
}

} // namespace

// Figure 4: two spheres are one component until they split into two; both ends of the stream have
// no tunnel.
TEST(Figures, TwoSpheresSplit)
{
  const Profile profile = MakeProfile(models::TwoSpheres(), 0.0);
  EXPECT_EQ(profile.Components.front(), 1);
  EXPECT_EQ(profile.Components.back(), 2);
  EXPECT_TRUE(std::is_sorted(profile.Components.begin(), profile.Components.end()));
  EXPECT_EQ(profile.Tunnels.front(), 0);
  EXPECT_EQ(profile.Tunnels.back(), 0);
}

// Figure 10 (b): without depth, eight spheres are carved through the six sides of their cube first.
// A frame of a cube, with 8 corners and 12 edges, has 12 - 8 + 1 = 5 tunnels.
TEST(Figures, EightSpheresBecomeAFrameWithoutDepth)
{
  EXPECT_GT(ShareOfSteps(MakeProfile(models::EightSpheres(), 0.0), 5), 0.5);
}

// Figure 10 (c): with dp = 2 carving advances evenly, and hardly any tunnel opens before the
// spheres split.
TEST(Figures, EightSpheresStayWholeWithDepth)
{
  EXPECT_GT(ShareOfSteps(MakeProfile(models::EightSpheres(), 2.0), 0), 0.85);
}
