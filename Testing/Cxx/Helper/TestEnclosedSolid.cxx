// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Enclosing mode: the solid of closed parts is in every level, not only its surface.
 */
#include "Checks.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/FacetTree.h"
#include "Core/Solid/RegionWindings.h"
#include "Core/Solid/Winding.h"
#include "Helper/Resolve/Clean.h"
#include "HelperRun.h"
#include "PropertyChecks.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

using namespace carving;

namespace
{

/** Carves M as it is enclosed, and gives the last level. */
Level<3> CarveToTheEnd(const TriangleMesh& mesh, double tolerance, Carved& carved)
{
  const Reply reply = GetReply(mesh, Conformity::Enclosing, tolerance);
  carved = CarveResult(reply.Result, {}, SolidRule::NonzeroWinding);
  return ExtractLevel(carved.Stored, carved.Profile.LastStep());
}

} // namespace

// Vertices on the edges of parts that touch are off these edges by roundings. No solid leaks there.
TEST(EnclosedSolid, StaysWherePartsTouch)
{
  std::mt19937_64 random(40);
  for (const int fins : { 14, 24 })
  {
    SCOPED_TRACE(std::to_string(fins) + " fins");
    TriangleMesh mesh = models::Box({ 0, 0, 0 }, { 0.5 * fins + 1.0, 10, 1 });
    for (int i = 1; i <= fins; ++i)
    {
      mesh = models::Joined(mesh, models::Box({ 0.5 * i, 0, 1 }, { 0.5 * i + 0.1, 10, 6 }));
    }
    const double sixVolume = checks::SixVolume(mesh.Points, mesh.Triangles); // the parts only touch
    Carved carved;
    const Level<3> last = CarveToTheEnd(models::Rotated(mesh, random), 0.2, carved);
    EXPECT_GE(checks::SixVolume(carved.Mesh.Surface.Points, Shell(last)), (1.0 - 1e-9) * sixVolume);
  }
}

// Points around which closed parts wind are in the last level, hence in all.
TEST(EnclosedSolid, HasThePointsOfRandomAssemblies)
{
  std::mt19937_64 random(41);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_MESHES", 40);
  int inside = 0;
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("assembly " + std::to_string(i));
    const int n = 2 + static_cast<int>(random() % 20);
    const TriangleMesh mesh =
      models::Rotated(i % 2 ? models::Assembly(n, random) : models::BoxSoup(n, random), random);
    const double tolerance = std::array{ 0.0, 0.05, 0.2 }[random() % 3];
    Carved carved;
    const Level<3> last = CarveToTheEnd(mesh, tolerance, carved);
    const std::vector<Triangle> shell = Shell(last);
    const ResolvedMesh given = helper::Clean(helper::AsResolved(mesh));
    const FacetTree<3> tree(given);
    const Box box = BoxAround(mesh.Points);
    for (int sample = 0; sample < 50; ++sample)
    {
      Point p;
      for (int k = 0; k < 3; ++k)
      {
        p[k] = std::uniform_real_distribution<double>(box.Lower[k], box.Upper[k])(random);
      }
      const bool isOff = tree.Find(p).Distance > 1e-9;
      if (isOff && std::abs(WindingNumber(given, p)) >= SolidFrom)
      {
        ++inside;
        EXPECT_TRUE(checks::Encloses(carved.Mesh.Surface.Points, shell, p))
          << p[0] << " " << p[1] << " " << p[2];
      }
    }
  }
  EXPECT_GT(inside, count);
}
