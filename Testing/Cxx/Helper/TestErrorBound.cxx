// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The bound of the distance of faces that collapses make.
 */
#include "Helper/Decimation/ErrorBound.h"
#include "Helper/Resolve/Clean.h"
#include "Shapes.h"

#include <gtest/gtest.h>

using namespace carving;
using helper::SurfaceMesh;
using helper::Vertex;

namespace
{

/** A tetrahedron as M and as the surface around M, and the star of the edge up the z-axis. */
class ErrorBound : public testing::Test
{
protected:
  const ResolvedMesh M = helper::AsResolved(models::Tetrahedron());
  const SurfaceMesh Surface = helper::AsSurfaceMesh(this->M);
  const helper::HalfEdge HalfEdge = this->Surface.halfedge(Vertex(0), Vertex(3));
  const SurfaceMesh::Edge_index Edge = this->Surface.edge(this->HalfEdge);
  const helper::Star Star{ this->Surface, this->HalfEdge };
  const FaceDistance<3> FromM{ this->M };
  helper::ErrorBound Bound{ this->FromM, this->Surface.num_edges() };
};

} // namespace

// The bound never falls.
TEST_F(ErrorBound, OnlyRises)
{
  EXPECT_TRUE(this->Bound.Raise(0.5));
  EXPECT_FALSE(this->Bound.Raise(0.3));
  EXPECT_EQ(this->Bound.Get(), 0.5);
}

// Only faces within the bound are allowed.
TEST_F(ErrorBound, AllowsFacesWithin)
{
  this->Bound.Raise(0.5);
  EXPECT_TRUE(this->Bound.Allows(this->Star, { 0, 0, 1.4 }));
  EXPECT_FALSE(this->Bound.Allows(this->Star, { 0, 0, 1.6 }));
}

// An edge waits for a bound above the distance that was in the way, or is forgotten.
TEST_F(ErrorBound, SparesAttemptsThatWouldFail)
{
  this->Bound.Raise(0.5);
  EXPECT_TRUE(this->Bound.MayAllow(this->Edge));
  EXPECT_FALSE(this->Bound.Allows(this->Edge, this->Star, { 0, 0, 2 })); // 1 from M
  EXPECT_FALSE(this->Bound.Allows(this->Edge, this->Star, { 0, 0, 3 }));
  EXPECT_FALSE(this->Bound.MayAllow(this->Edge));
  this->Bound.Raise(0.9);
  EXPECT_FALSE(this->Bound.MayAllow(this->Edge));
  this->Bound.Forget(this->Edge);
  EXPECT_TRUE(this->Bound.MayAllow(this->Edge));
  EXPECT_FALSE(this->Bound.Allows(this->Edge, this->Star, { 0, 0, 2 }));
  this->Bound.Raise(1.1);
  EXPECT_TRUE(this->Bound.MayAllow(this->Edge));
}
