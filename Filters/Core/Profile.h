// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Size of every approximation of a stream.
 */
#ifndef carving_Profile_h
#define carving_Profile_h

#include "Carver.h"
#include "Mesh.h"

#include <vector>

namespace carving
{

/** One entry per step, from C0 on: vertices and triangles of that approximation. */
struct Profile
{
  std::vector<int> Vertices;
  std::vector<int> Triangles;

  int LastStep() const
  {
    return static_cast<int>(this->Vertices.size()) - 1;
  }
};

/** O(tetrahedra): sums up where each vertex and face appears and vanishes. */
Profile ComputeProfile(const Tetrahedralization& mesh, const Stream& stream);

} // namespace carving

#endif
