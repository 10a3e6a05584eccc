// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The meshes that the tests fetch.
 */
#ifndef RealMeshes_h
#define RealMeshes_h

#include "Core/Mesh/Mesh.h"

#include <string>

/** All their faces are triangles. */
carving::TriangleMesh ReadRealMesh(const std::string& name);

/** Of one closed piece: V - E + F = 2 - 2 g, with three edges to two triangles. */
inline int GenusOf(const carving::TriangleMesh& mesh)
{
  const auto vertices = static_cast<int>(mesh.Points.size());
  const auto triangles = static_cast<int>(mesh.Triangles.size());
  return (2 - vertices + triangles / 2) / 2;
}

#endif
