// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decimation of levels of carvings.
 */
#include "Core/Surface/LevelParts.h"
#include "Core/Surface/Manifold.h"
#include "DecimationChecks.h"
#include "Helper/Decimation/EnclosingDecimation.h"
#include "HelperRun.h"
#include "PropertyChecks.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace carving;
using helper::DecimateEnclosing;

namespace
{

const int NumberOfSurfaces = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_DECIMATIONS", 40);

struct LevelOfMesh
{
  TriangleMesh Surface; ///< cut into manifolds; empty if there is none
  TriangleMesh M;
  TriangleMesh Parts;
};

/** A random level of a carving of a mesh. Folds show both sides. */
LevelOfMesh RandomLevel(const TriangleMesh& mesh, std::mt19937_64& random)
{
  Job job;
  job.Mesh = mesh;
  job.Conformity = Conformity::Auto;
  const HelperRun run = RunHelper(job);
  if (!run.Succeeded())
  {
    return {};
  }
  Carved carved = CarveResult(run.Reply.Result);
  carved.Stored.Folds = FoldSides::Both;
  const int step = static_cast<int>(random() % (carved.Stream.LastStep() + 1));
  const Level<3> extracted = ExtractLevel(carved.Stored, step);
  const ManifoldLevel<3> cut = CutIntoManifold(carved.Stored, extracted);
  const bool conforming = run.Reply.Result.Unresolved.Facets.empty();
  const ResolvedMesh& m = conforming ? carved.Stored.Mesh.Surface : run.Reply.Result.Unresolved;
  LevelOfMesh level = { { {}, cut.Faces }, { m.Points, m.Facets },
    ExtractParts(carved.Stored, extracted, m.Points.size()) };
  for (const int point : cut.Points)
  {
    level.Surface.Points.push_back(carved.Stored.Mesh.Surface.Points[point]);
  }
  return level;
}

/** Expects results of half and an eighth of a level's vertices that enclose what they have to. */
void ExpectToEncloseDecimated(const LevelOfMesh& level, bool nested, std::mt19937_64& random)
{
  if (level.Surface.Points.size() <= 4)
  {
    return; // there is no level, or no vertex that could go
  }
  const TriangleMesh inside = nested ? level.Surface : models::Joined(level.M, level.Parts);
  const double half = std::floor(level.Surface.Points.size() / 2.0);
  Decimation decimation;
  ASSERT_EQ(DecimateEnclosing(level.Surface, nested ? level.Surface : level.M, level.Parts,
              OptionsFor({ half, half / 4 }, nested), decimation),
    "");
  for (const DecimationResult& result : GetResults(decimation))
  {
    ExpectEnclosingSurface(level.Surface, inside, result, random);
  }
}

} // namespace

// Levels of carvings, which touch themselves in copies of points, can be decimated. Nested results
// enclose the level, all others the mesh that has been carved.
TEST(DecimatedLevels, EnclosesLevelsOfRandomMeshes)
{
  for (int i = 0; i < NumberOfSurfaces; ++i)
  {
    SCOPED_TRACE(i);
    std::mt19937_64 random(i);
    const TriangleMesh mesh = models::MakeRandom(random).Mesh;
    ExpectToEncloseDecimated(RandomLevel(mesh, random), i % 2 == 0, random);
  }
}

// The same for flat sheets, whose corners move in the sheets' planes.
TEST(DecimatedLevels, EnclosesLevelsOfFlatSheets)
{
  for (int i = 0; i < NumberOfSurfaces; ++i)
  {
    SCOPED_TRACE(i);
    std::mt19937_64 random(i);
    const TriangleMesh mesh = models::Discs(2 + i % 4, random);
    ExpectToEncloseDecimated(RandomLevel(mesh, random), i % 4 == 0, random);
  }
}

// The same for sheets in one plane, up to rounding.
TEST(DecimatedLevels, EnclosesLevelsOfSheetsInOnePlane)
{
  for (int i = 0; i < NumberOfSurfaces; ++i)
  {
    SCOPED_TRACE(i);
    std::mt19937_64 random(i);
    const TriangleMesh sheets = models::Joined(
      models::Sheet(2 + i % 4), models::Moved(models::Sheet(3), { 1.5, random() % 9 / 9.0, 0.0 }));
    ExpectToEncloseDecimated(RandomLevel(models::Rotated(sheets, random), random), false, random);
  }
}
