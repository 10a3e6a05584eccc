// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The bound of the distance of faces that collapses make.
 */
#include "Helper/Decimation/ErrorBound.h"

#include <gtest/gtest.h>

using namespace carving;
using helper::ErrorBound;

namespace
{

/** A tetrahedron as M and as the surface around M, and the edge up the z-axis. */
struct Surface
{
  ResolvedMesh M;
  helper::SurfaceMesh Mesh;
  helper::HalfEdge Edge;

  Surface()
  {
    this->M.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    this->M.Facets = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
    for (const Point& p : this->M.Points)
    {
      this->Mesh.add_vertex(p);
    }
    using helper::Vertex;
    for (const auto& [a, b, c] : this->M.Facets)
    {
      this->Mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
    }
    this->Edge = this->Mesh.halfedge(Vertex(0), Vertex(3));
  }
};

} // namespace

// The bound never falls.
TEST(ErrorBound, OnlyRises)
{
  const Surface surface;
  const FaceDistance<3> fromM(surface.M);
  ErrorBound bound(fromM, surface.Mesh.num_edges());
  EXPECT_TRUE(bound.Raise(0.5));
  EXPECT_FALSE(bound.Raise(0.3));
  EXPECT_EQ(bound.Get(), 0.5);
}

// Only faces within the bound are allowed.
TEST(ErrorBound, AllowsFacesWithin)
{
  const Surface surface;
  const FaceDistance<3> fromM(surface.M);
  ErrorBound bound(fromM, surface.Mesh.num_edges());
  bound.Raise(0.5);
  const helper::Star star(surface.Mesh, surface.Edge);
  EXPECT_TRUE(bound.Allows(star, { 0, 0, 1.4 }));
  EXPECT_FALSE(bound.Allows(star, { 0, 0, 1.6 }));
}

// An edge waits for a bound above the distance that was in the way, or is forgotten.
TEST(ErrorBound, SparesAttemptsThatWouldFail)
{
  const Surface surface;
  const FaceDistance<3> fromM(surface.M);
  ErrorBound bound(fromM, surface.Mesh.num_edges());
  bound.Raise(0.5);
  const helper::Star star(surface.Mesh, surface.Edge);
  const auto edge = surface.Mesh.edge(surface.Edge);
  EXPECT_TRUE(bound.MayAllow(edge));
  EXPECT_FALSE(bound.Allows(edge, star, { 0, 0, 2 })); // 1 from M
  EXPECT_FALSE(bound.Allows(edge, star, { 0, 0, 3 }));
  EXPECT_FALSE(bound.MayAllow(edge));
  bound.Raise(0.9);
  EXPECT_FALSE(bound.MayAllow(edge));
  bound.Forget(edge);
  EXPECT_TRUE(bound.MayAllow(edge));
  EXPECT_FALSE(bound.Allows(edge, star, { 0, 0, 2 }));
  bound.Raise(1.1);
  EXPECT_TRUE(bound.MayAllow(edge));
}
