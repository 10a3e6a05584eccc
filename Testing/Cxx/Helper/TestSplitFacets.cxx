// SPDX-License-Identifier: BSD-3-Clause
#include "Helper/Exact/SplitFacets.h"

#include <gtest/gtest.h>

#include <utility>

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
  ASSERT_EQ(ReplaceByParts(PartsOfBoth(), { 0, 1 }, mesh), "");
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
    EXPECT_NE(ReplaceByParts(parts, { 0, 1 }, mesh).find(missing < 4 ? "triangle 0" : "triangle 1"),
      std::string::npos);
    parts = PartsOfBoth();
    parts.push_back(parts[missing]);
    mesh = TwoTriangles();
    EXPECT_NE(ReplaceByParts(parts, { 0, 1 }, mesh), "");
  }
}

// A part in another plane is detected.
TEST(SplitFacets, DetectAnotherPlane)
{
  ResolvedMesh mesh = TwoTriangles();
  mesh.Points[5][2] += 1e-6;
  EXPECT_NE(
    ReplaceByParts(PartsOfBoth(), { 0, 1 }, mesh).find("leave its plane"), std::string::npos);
}

// The facets of a class may be cut in another way: here along the other diagonal of a square, with
// a point on one side.
TEST(SplitFacets, MayCutAClassInAnotherWay)
{
  ResolvedMesh mesh;
  mesh.Points = { { 0, 0, 1 }, { 4, 0, 1 }, { 4, 4, 1 }, { 0, 4, 1 }, { 2, 0, 1 } };
  mesh.PointSources = { 0, 1, 2, 3, -1 };
  mesh.Facets = { { 0, 1, 2 }, { 0, 2, 3 } };
  mesh.FacetSources = { 5, 5 };
  mesh.SignedMultiplicities = mesh.Multiplicities = { 1, 1 };
  const std::vector<int> classes = FindFacetClasses(mesh);
  EXPECT_EQ(classes, (std::vector<int>{ 0, 0 }));
  const std::vector<FacetPart> parts = { { { 0, 4, 3 }, 0 }, { { 4, 3, 1 }, 0 },
    { { 1, 2, 3 }, 0 } };
  ResolvedMesh cut = mesh;
  ASSERT_EQ(ReplaceByParts(parts, classes, cut), "");
  EXPECT_EQ(cut.Facets.size(), 3u);
  EXPECT_EQ(cut.FacetSources, (std::vector<int>{ 5, 5, 5 }));
  // As many triangles and the same area, but one part twice and another not at all.
  EXPECT_NE(ReplaceByParts({ parts[0], parts[0], parts[2] }, classes, mesh), "");
}

// Parts of one triangle with other multiplicities or another direction belong to other classes.
TEST(SplitFacets, TellClassesApart)
{
  ResolvedMesh mesh = TwoTriangles();
  mesh.Facets = { { 0, 4, 5 }, { 4, 1, 5 }, { 5, 1, 2 }, { 2, 5, 0 } };
  mesh.FacetSources = { 7, 7, 7, 7 };
  mesh.SignedMultiplicities = { 1, 1, 1, 0 };
  mesh.Multiplicities = { 1, 1, 1, 2 };
  std::swap(mesh.Facets[1][0], mesh.Facets[1][1]);
  EXPECT_EQ(FindFacetClasses(mesh), (std::vector<int>{ 0, 1, 0, 2 }));
}

// In a steep plane, the roundings of a long, thin triangle do not turn its parts over.
TEST(SplitFacets, KeepTheDirectionOfSteepSlivers)
{
  // The plane is x = y / 3, up to rounding, so that the projection along z is nothing but rounding.
  const auto at = [](double y, double z) { return Point{ y / 3.0, y, z }; };
  ResolvedMesh mesh;
  mesh.Points = { at(0.1, 0), at(0.7, 1), at(1.3, 2.0005), at(0.4, 0.5), at(0.9, 1.3336) };
  mesh.PointSources = { 0, 1, 2, -1, -1 };
  mesh.Facets = { { 0, 1, 2 } };
  mesh.FacetSources = { 3 };
  mesh.SignedMultiplicities = mesh.Multiplicities = { 1 };
  const std::vector<FacetPart> parts = { { { 0, 3, 2 }, 0 }, { { 3, 1, 2 }, 0 } };
  ASSERT_EQ(ReplaceByParts(parts, { 0 }, mesh), "");
  EXPECT_EQ(mesh.Facets[0], (Triangle{ 0, 3, 2 }));
  EXPECT_EQ(mesh.Facets[1], (Triangle{ 3, 1, 2 }));
}
