// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Enclosing mode: what is met of a mesh, and how far the kept tetrahedra reach from it.
 */
#include "Checks.h"
#include "Core/Measure/LevelSelection.h"
#include "Core/Mesh/Vector.h"
#include "Core/Surface/LevelParts.h"
#include "HelperRun.h"
#include "PropertyChecks.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

using namespace carving;

// The kept distances are those of dense samples on the kept surface, of which parts of the mesh are
// left out.
TEST(MetShare, MeasuresTheKeptDistances)
{
  const TriangleMesh mesh = models::CrossingTori();
  const Reply reply = GetReply(mesh, Conformity::Enclosing);
  const Tetrahedralization& result = reply.Result;
  const std::vector<Point>& points = result.Surface.Points;
  std::vector<std::pair<double, double>> samples; // distance and area
  double area = 0.0, sum = 0.0;
  for (int cell = 0; cell < static_cast<int>(result.Cells.size()); ++cell)
  {
    for (int f = 0; f < 4 && result.Kept[cell]; ++f)
    {
      const int other = result.Neighbors[cell][f];
      if ((other >= 0 && result.Kept[other]) || result.Constraints.Has(cell, f))
      {
        continue;
      }
      const auto [a, b, c] = result.OutwardFace(cell, f);
      const Point u = points[b] - points[a], v = points[c] - points[a];
      constexpr int rows = 24;
      for (int i = 0; i < rows; ++i)
      {
        for (int k = 0; i + k < rows; ++k)
        {
          const Point p = points[a] + ((i + 1.0 / 3.0) / rows) * u + ((k + 1.0 / 3.0) / rows) * v;
          const double share = Length(Cross(u, v)) / (rows * (rows + 1));
          samples.emplace_back(checks::DistanceTo(mesh.Points, mesh.Triangles, p), share);
          area += share;
          sum += share * samples.back().first;
        }
      }
    }
  }
  std::sort(samples.begin(), samples.end());
  double below = 0.0;
  auto sample = samples.begin();
  while (below < 0.99 * area)
  {
    below += sample->second;
    ++sample;
  }
  EXPECT_NEAR(reply.KeptDistanceMean, sum / area, 0.05 * sum / area);
  EXPECT_NEAR(reply.KeptDistance99, sample->first, 0.1 * sample->first);
  EXPECT_NEAR(reply.KeptDistance, samples.back().first, 0.1 * samples.back().first);
}

// The shares that are met are those of the faces' area in the area of the mesh and its triangles.
TEST(MetShare, KnowsWhichShareIsMet)
{
  const TriangleMesh mesh = models::CrossingTori();
  const Reply reply = GetReply(mesh, Conformity::Enclosing);
  const auto areaOf = [](const std::vector<Point>& points, const Triangle& t)
  { return Length(Cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])) / 2.0; };
  const ResolvedMesh& surface = reply.Result.Surface;
  std::vector<double> met(mesh.Triangles.size(), 0.0);
  for (std::size_t i = 0; i < surface.Facets.size(); ++i)
  {
    met[surface.FacetSources[i]] += areaOf(surface.Points, surface.Facets[i]);
  }
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    const int triangle = reply.Result.Unresolved.FacetSources[i];
    const double own = areaOf(mesh.Points, mesh.Triangles[triangle]);
    EXPECT_NEAR(reply.Result.MetShares[i], met[triangle] / own, 1e-9);
    area += own;
  }
  EXPECT_NEAR(reply.MetShare, std::accumulate(met.begin(), met.end(), 0.0) / area, 1e-9);
  EXPECT_GT(reply.MetShare, 0.5);
  EXPECT_LT(reply.MetShare, 1.0); // where the two cross, no triangle can be met
}

// All faces of a level that lie on M are triangles of M or parts of these.
TEST(MetShare, ExtractsThePartsOfALevel)
{
  std::mt19937_64 random(3);
  const TriangleMesh mesh = models::Soup(60, random); // with so many crossings, it is not resolved
  const Reply reply = GetReply(mesh, Conformity::Enclosing, 0.02);
  const Carved carved = CarveResult(reply.Result);
  using Corners = std::multiset<Point>;
  const auto cornersOf = [](const std::vector<Point>& points, const Triangle& t) {
    return Corners{ points[t[0]], points[t[1]], points[t[2]] };
  };
  std::set<Corners> triangles;
  for (const Triangle& t : mesh.Triangles)
  {
    triangles.insert(cornersOf(mesh.Points, t));
  }
  std::size_t extracted = 0;
  for (const int step : SpreadLevels(carved.Profile, 4))
  {
    const Level<3> level = ExtractLevel(carved.Stored, step);
    std::multiset<Corners> expected, found;
    for (const FaceLife<3>& face : level.Faces)
    {
      const Corners corners = cornersOf(carved.Mesh.Surface.Points, face.Corners);
      if (face.Constraint >= 0 && triangles.count(corners) == 0)
      {
        expected.insert(corners);
      }
    }
    const TriangleMesh parts =
      ExtractParts(carved.Stored, level, reply.Result.Unresolved.Points.size());
    for (const Triangle& part : parts.Triangles)
    {
      found.insert(cornersOf(parts.Points, part));
    }
    EXPECT_EQ(found, expected);
    extracted += found.size();
  }
  EXPECT_GT(extracted, 0u);
}

// In exact mode, no face is a part.
TEST(MetShare, HasNoPartsInExactMode)
{
  const Reply reply = GetReply(models::Sphere(1), Conformity::Exact);
  const Carved carved = CarveResult(reply.Result);
  const Level<3> level = ExtractLevel(carved.Stored, carved.Stream.LastStep());
  EXPECT_TRUE(
    ExtractParts(carved.Stored, level, reply.Result.Surface.Points.size()).Triangles.empty());
}
