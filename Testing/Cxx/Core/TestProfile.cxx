// SPDX-License-Identifier: BSD-3-Clause
#include "Level.h"
#include "Profile.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <set>

using namespace carving;

// A row of n tetrahedra has 2 n + 2 faces and n + 3 vertices, and loses two and one with each of them;
// the last leaves one triangle.
TEST(Profile, OfARowIsKnown)
{
  const Tetrahedralization mesh = small::Row(5);
  const Profile profile = ComputeProfile(mesh, small::CarveOneByOne(mesh));
  EXPECT_EQ(profile.Triangles, (std::vector<int>{ 12, 10, 8, 6, 4, 1 }));
  EXPECT_EQ(profile.Vertices, (std::vector<int>{ 8, 7, 6, 5, 4, 3 }));
  EXPECT_EQ(profile.LastStep(), 5);
}

// The profile counts what extracting the level gives, at every step.
TEST(Profile, AgreesWithEveryLevel)
{
  const auto inner = small::InnerFaces();
  for (const auto& triangles :
    { inner, small::Joined(small::OuterFaces(), small::Flipped(inner)), small::OuterFaces() })
  {
    const Tetrahedralization mesh = small::NestedTetrahedra(triangles);
    const Stream stream = small::CarveOneByOne(mesh);
    const Profile profile = ComputeProfile(mesh, stream);
    ASSERT_EQ(profile.LastStep(), stream.LastStep());
    for (int step = 0; step <= stream.LastStep(); ++step)
    {
      const Level level = ExtractLevel(mesh, stream, step);
      std::set<int> vertices;
      for (const Triangle& t : level.Triangles)
      {
        vertices.insert(t.begin(), t.end());
      }
      EXPECT_EQ(profile.Triangles[step], static_cast<int>(level.Triangles.size()));
      EXPECT_EQ(profile.Vertices[step], static_cast<int>(vertices.size()));
    }
  }
}
