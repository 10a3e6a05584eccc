// SPDX-License-Identifier: BSD-3-Clause
#include "Chain.h"
#include "Core/Stream/Level.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <set>

using namespace carving;

namespace
{

std::multiset<Triangle> Corners(const std::vector<FaceLife<3>>& faces)
{
  std::multiset<Triangle> corners;
  for (const FaceLife<3>& face : faces)
  {
    corners.insert(face.Corners);
  }
  return corners;
}

std::multiset<Triangle> Extracted(const StoredStream<3>& stream, int step)
{
  return Corners(ExtractLevel(stream, step).Faces);
}

std::set<int> Vertices(const std::multiset<Triangle>& triangles)
{
  std::set<int> vertices;
  for (const Triangle& t : triangles)
  {
    vertices.insert(t.begin(), t.end());
  }
  return vertices;
}

void Apply(const ChainUpdate<3>& update, std::multiset<Triangle>& level, std::set<int>& vertices)
{
  for (const Triangle& t : Corners(update.Removed))
  {
    ASSERT_EQ(level.count(t), 1u);
    level.erase(t);
  }
  level.merge(Corners(update.Added));
  vertices.insert(update.AddedVertices.begin(), update.AddedVertices.end());
  for (const int vertex : update.RemovedVertices)
  {
    vertices.erase(vertex);
  }
}

/** A solid, a solid with a void, and a sheet, which becomes a fold. */
std::vector<StoredStream<3>> Streams()
{
  const auto inner = small::InnerFaces();
  std::vector<StoredStream<3>> streams;
  for (const auto& facets :
    { inner, small::Joined(small::OuterFaces(), small::Flipped(inner)), { inner[0] } })
  {
    streams.push_back(small::StoreOneByOne(small::NestedTetrahedra(facets)));
  }
  return streams;
}

} // namespace

// Moved step by step, a level equals the extracted one, forward and backward, with its vertices.
TEST(Chain, GivesTheExtractedLevels)
{
  for (const StoredStream<3>& stream : Streams())
  {
    Chain<3> chain(stream);
    std::multiset<Triangle> level = Extracted(stream, 0);
    std::set<int> vertices = Vertices(level);
    while (chain.HasNext())
    {
      Apply(chain.Next(), level, vertices);
      EXPECT_EQ(level, Extracted(stream, chain.GetStep()));
      EXPECT_EQ(vertices, Vertices(level));
    }
    EXPECT_EQ(chain.GetStep(), stream.Order.LastStep());
    while (chain.HasPrevious())
    {
      Apply(chain.Previous(), level, vertices);
      EXPECT_EQ(level, Extracted(stream, chain.GetStep()));
      EXPECT_EQ(vertices, Vertices(level));
    }
    EXPECT_EQ(chain.GetStep(), 0);
  }
}

// A tetrahedron of degree 1 takes one face away and adds three around at most one new vertex.
TEST(Chain, ReplacesOneFaceByThreeForDegreeOne)
{
  const StoredStream<3> stream = small::StoreOneByOne(small::NestedTetrahedra(small::InnerFaces()));
  Chain<3> chain(stream);
  const ChainUpdate<3> first = chain.Next();
  EXPECT_EQ(first.Removed.size(), 1u);
  EXPECT_EQ(first.Added.size(), 3u);
  EXPECT_EQ(first.AddedVertices.size(), 1u);
  EXPECT_TRUE(first.RemovedVertices.empty());
}
