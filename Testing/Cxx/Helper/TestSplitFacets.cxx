// SPDX-License-Identifier: BSD-3-Clause
#include "Helper/Exact/SplitFacets.h"

#include <gtest/gtest.h>

using namespace carving;
using namespace carving::helper;

namespace
{

/**
 * Two triangles with a common edge, a point on that edge, and a point inside the first triangle.
 */
ResolvedMesh TwoTriangles()
{
  ResolvedMesh mesh;
  mesh.Points = { { 0, 0, 1 }, { 4, 0, 1 }, { 0, 4, 1 }, { 4, 0, 3 }, { 2, 0, 1 }, { 1, 1, 1 } };
  mesh.PointSources = { 0, 1, 2, 3, -1, -1 };
  mesh.Facets = { { 0, 1, 2 }, { 1, 0, 3 } };
  mesh.FacetSources = { 7, 8 };
  mesh.SignedMultiplicities = { 1, -2 };
  mesh.Multiplicities = { 1, 2 };
  return mesh;
}

/** Both triangles, split at these points; some parts are flipped. */
std::vector<FacetPart> PartsOfBoth()
{
  return { { { 0, 4, 5 }, 0 }, { { 4, 5, 1 }, 0 }, { { 1, 2, 5 }, 0 }, { { 2, 0, 5 }, 0 },
    { { 0, 4, 3 }, 1 }, { { 4, 3, 1 }, 1 } };
}

} // namespace

// Parts get the orientation, source and multiplicities of their triangle.
TEST(SplitFacets, TakeTheFacetsPlace)
{
  ResolvedMesh mesh = TwoTriangles();
  ASSERT_EQ(ReplaceByParts(PartsOfBoth(), mesh), "");
  ASSERT_EQ(mesh.Facets.size(), 6u);
  for (std::size_t i = 0; i < mesh.Facets.size(); ++i)
  {
    const auto& [a, b, c] = mesh.Facets[i];
    const Point &p = mesh.Points[a], &q = mesh.Points[b], &r = mesh.Points[c];
    const bool first = i < 4;
    const int x = 0, y = first ? 1 : 2; // the plane of the first is z = 1, of the second y = 0
    const double turn = (q[x] - p[x]) * (r[y] - p[y]) - (q[y] - p[y]) * (r[x] - p[x]);
    EXPECT_EQ(turn > 0.0, first) << i;
    EXPECT_EQ(mesh.FacetSources[i], first ? 7 : 8);
    EXPECT_EQ(mesh.SignedMultiplicities[i], first ? 1 : -2);
    EXPECT_EQ(mesh.Multiplicities[i], first ? 1 : 2);
  }
  EXPECT_EQ(mesh.PointSources, TwoTriangles().PointSources);
}

// Missing and duplicate parts are detected.
TEST(SplitFacets, DetectMissingParts)
{
  for (std::size_t missing = 0; missing < PartsOfBoth().size(); ++missing)
  {
    std::vector<FacetPart> parts = PartsOfBoth();
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(missing));
    ResolvedMesh mesh = TwoTriangles();
    EXPECT_NE(ReplaceByParts(parts, mesh).find(missing < 4 ? "triangle 0" : "triangle 1"),
      std::string::npos);
    parts = PartsOfBoth();
    parts.push_back(parts[missing]);
    mesh = TwoTriangles();
    EXPECT_NE(ReplaceByParts(parts, mesh), "");
  }
}

// A part in another plane is detected.
TEST(SplitFacets, DetectAnotherPlane)
{
  ResolvedMesh mesh = TwoTriangles();
  mesh.Points[5][2] += 1e-6;
  EXPECT_NE(ReplaceByParts(PartsOfBoth(), mesh).find("leave its plane"), std::string::npos);
}
