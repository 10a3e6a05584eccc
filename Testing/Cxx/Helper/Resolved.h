// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Meshes without crossings, for tests of the steps after resolving.
 */
#ifndef Resolved_h
#define Resolved_h

#include "Checks.h"
#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/FacetTree.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Resolve.h"

#include <gtest/gtest.h>

/** Cleans and resolves a mesh, and expects that no two triangles cross. */
inline carving::ResolvedMesh Resolved(const carving::TriangleMesh& given)
{
  using namespace carving::helper;
  carving::ResolvedMesh mesh = Clean(AsResolved(given));
  int pairs = 0;
  EXPECT_EQ(Resolve(mesh, pairs, {}), "");
  EXPECT_EQ(checks::CountCrossings(mesh.Points, mesh.Facets), 0);
  return mesh;
}

/** The area of all triangles. */
inline double AreaOf(const carving::ResolvedMesh& mesh)
{
  double area = 0.0;
  for (const carving::Triangle& t : mesh.Facets)
  {
    area += carving::Size(carving::CornersOf<3>(mesh.Points, t));
  }
  return area;
}

#endif
