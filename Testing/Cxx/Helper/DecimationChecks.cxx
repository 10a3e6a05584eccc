// SPDX-License-Identifier: BSD-3-Clause
#include "DecimationChecks.h"

#include "Checks.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Decimation/EnclosingDecimation.h"

#include <gtest/gtest.h>

#include <utility>

using namespace carving;

namespace
{

/** V - E + F of a closed surface, which has three edges for every two faces. */
int EulerCharacteristic(const TriangleMesh& mesh)
{
  return static_cast<int>(mesh.Points.size()) - static_cast<int>(mesh.Triangles.size()) / 2;
}

int CountCrossings(const TriangleMesh& mesh)
{
  return checks::CountCrossings(mesh.Points, checks::WithPointsMerged(mesh.Points, mesh.Triangles));
}

} // namespace

std::vector<DecimationResult> GetResults(const Decimation& decimation)
{
  std::vector<DecimationResult> results;
  for (const DecimatedSurface& surface : decimation.Surfaces)
  {
    const CollapsedSurface collapsed = ExtractSurface(decimation.Chain, surface.Collapses);
    DecimationResult& result = results.emplace_back();
    result.Mesh.Triangles = collapsed.Triangles;
    for (const int point : collapsed.Points)
    {
      result.Mesh.Points.push_back(decimation.Points[point]);
      result.PointSources.push_back(decimation.PointSources[point]);
    }
    result.Error = surface.Error;
    result.Reached = surface.Reached;
  }
  return results;
}

DecimationOptions OptionsFor(std::vector<double> targets, bool nested, DecimationTarget type)
{
  DecimationOptions options;
  options.Type = type;
  options.Targets = std::move(targets);
  options.Nested = nested;
  return options;
}

std::vector<DecimationResult> Decimate(const TriangleMesh& mesh, const DecimationOptions& options)
{
  Decimation decimation;
  EXPECT_EQ(helper::DecimateEnclosing(mesh, mesh, {}, options, decimation), "");
  return GetResults(decimation);
}

std::vector<DecimationResult> Decimate(
  const TriangleMesh& mesh, std::vector<double> targets, bool nested, DecimationTarget type)
{
  return Decimate(mesh, OptionsFor(std::move(targets), nested, type));
}

Point RandomPointOn(const TriangleMesh& mesh, const Triangle& t, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Point onEdge = Between(mesh.Points[t[0]], mesh.Points[t[1]], uniform(random));
  return Between(onEdge, mesh.Points[t[2]], uniform(random));
}

void ExpectToEnclose(const TriangleMesh& outer, const TriangleMesh& inner, std::mt19937_64& random)
{
  for (const Triangle& t : inner.Triangles)
  {
    EXPECT_TRUE(checks::Encloses(outer.Points, outer.Triangles, inner.Points[t[0]]));
    const Point p = RandomPointOn(inner, t, random);
    EXPECT_TRUE(checks::Encloses(outer.Points, outer.Triangles, p) ||
      checks::DistanceTo(outer.Points, outer.Triangles, p) < 1e-14 * Diagonal(inner.Points));
  }
}

void ExpectEnclosingSurface(const TriangleMesh& given, const TriangleMesh& mesh,
  const DecimationResult& result, std::mt19937_64& random)
{
  EXPECT_TRUE(checks::IsClosed(result.Mesh.Triangles));
  EXPECT_LE(CountCrossings(result.Mesh), CountCrossings(given));
  EXPECT_EQ(EulerCharacteristic(result.Mesh), EulerCharacteristic(given));
  ExpectToEnclose(result.Mesh, mesh, random);
}

void ExpectEnclosingSurface(
  const TriangleMesh& given, const DecimationResult& result, std::mt19937_64& random)
{
  EXPECT_EQ(CountCrossings(given), 0);
  ExpectEnclosingSurface(given, given, result, random);
}
