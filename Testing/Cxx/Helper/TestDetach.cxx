// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Vertices that cutting has put on M are taken off it.
 */
#include "Core/Mesh/Box.h"
#include "Figures.h"
#include "Helper/Cutting/Cut.h"
#include "Helper/Recovery/Detach.h"
#include "Helper/Resolve/Clean.h"
#include "PiercedMeshCheck.h"
#include "RandomModels.h"
#include "Resolved.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace carving;
using namespace carving::helper;

namespace
{

PiercedMesh MakeCut(const ResolvedMesh& input)
{
  PiercedMesh mesh(input, {}, 2, Proceed);
  mesh.GiveParts(
    Cut(mesh, 1e-12 * Diagonal(input.Points), { 1000000, 100000 }, 2, Proceed), 2, Proceed);
  return mesh;
}

/** The vertices that are corners of parts but no points of M. */
std::set<int> FindVerticesOnM(const PiercedMesh& mesh, const ResolvedMesh& input)
{
  std::set<int> vertices;
  for (const auto& [corners, parent] : mesh.GetParts().GetParts())
  {
    for (const int corner : corners)
    {
      if (parent >= 0 && corner >= static_cast<int>(input.Points.size()))
      {
        vertices.insert(corner);
      }
    }
  }
  return vertices;
}

/** Expects that tetrahedra are oriented positively and fill the hull, and that neighbors agree. */
void ExpectValid(const PiercedMesh& mesh, double sixVolume)
{
  EXPECT_TRUE(mesh.GetDelaunay().tds().is_valid());
  EXPECT_NEAR(SixVolumeOf(mesh), sixVolume, 1e-9 * sixVolume);
}

} // namespace

// On closed surfaces and at the borders of open ones, every triangle is one face again afterwards.
TEST(Detach, RestoresTriangles)
{
  const TriangleMesh sphere = models::Sphere(4);
  const TriangleMesh spheres = models::Joined(sphere, models::Moved(sphere, { 3.0, 1.0, 0.0 }));
  for (const TriangleMesh& model :
    { models::Sheared(spheres), models::CloseSpheres(), models::YuccaLeaves() })
  {
    const ResolvedMesh input = Resolved(model);
    PiercedMesh mesh = MakeCut(input);
    EXPECT_FALSE(FindVerticesOnM(mesh, input).empty());
    const double volume = SixVolumeOf(mesh);
    RemoveFolds(mesh);
    DetachAll(mesh, static_cast<int>(input.Points.size()), 500);
    ExpectValid(mesh, volume);
    EXPECT_TRUE(FindVerticesOnM(mesh, input).empty());
    std::vector<Triangle> triangles(input.Facets.size());
    const std::vector<Subdivision::Part>& parts = mesh.GetParts().GetParts();
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      if (parts[i].Parent >= 0)
      {
        EXPECT_TRUE(mesh.IsFace(static_cast<int>(i)));
        triangles[parts[i].Parent] = parts[i].Corners;
      }
    }
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      EXPECT_TRUE(
        std::is_permutation(triangles[i].begin(), triangles[i].end(), input.Facets[i].begin()));
    }
  }
}

// The mesh stays valid, its points stay where they are, and no part that was a face is lost,
// whatever crosses or is degenerate.
TEST(Detach, KeepsTheMeshValid)
{
  std::mt19937_64 random(31);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_CUTS", 30);
  for (int i = 0; i < count; ++i)
  {
    SCOPED_TRACE("soup " + std::to_string(i));
    const ResolvedMesh input =
      Clean(AsResolved(models::Soup(2 + static_cast<int>(random() % 30), random)));
    PiercedMesh mesh = MakeCut(input);
    const double volume = SixVolumeOf(mesh);
    const std::size_t missing = mesh.FindMissing().size();
    DetachAll(mesh, static_cast<int>(input.Points.size()), 50);
    ExpectValid(mesh, volume);
    EXPECT_LE(mesh.FindMissing().size(), missing);
    EXPECT_TRUE(
      std::equal(input.Points.begin(), input.Points.end(), mesh.GetParts().GetPoints().begin()));
  }
}
