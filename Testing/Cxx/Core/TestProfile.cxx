// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Measure/Profile.h"
#include "Core/Stream/Level.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <set>

using namespace carving;

// A row of n tetrahedra has 2 n + 2 faces and n + 3 vertices, and loses two and one with each of
// them; the last leaves one triangle.
TEST(Profile, OfARowIsKnown)
{
  const Tetrahedralization mesh = small::Row(5);
  const Profile profile = ComputeProfile(small::StoreOneByOne(mesh));
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
    const StoredStream<3> stream = small::StoreOneByOne(mesh);
    const Profile profile = ComputeProfile(stream);
    ASSERT_EQ(profile.LastStep(), stream.Order.LastStep());
    for (int step = 0; step <= stream.Order.LastStep(); ++step)
    {
      const std::vector<Triangle> level = small::Triangles(ExtractLevel(stream, step));
      std::set<int> vertices;
      for (const Triangle& t : level)
      {
        vertices.insert(t.begin(), t.end());
      }
      EXPECT_EQ(profile.Triangles[step], static_cast<int>(level.size()));
      EXPECT_EQ(profile.Vertices[step], static_cast<int>(vertices.size()));
    }
  }
}
