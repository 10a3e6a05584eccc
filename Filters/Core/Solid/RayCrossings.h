// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Crossings of rays with a mesh.
 */
#ifndef carving_RayCrossings_h
#define carving_RayCrossings_h

#include "Core/Mesh/FacetTree.h"

#include <array>

namespace carving
{

/** Counts the triangles of M that rays cross. The time per ray is that of a search in a tree. */
class RayCrossings
{
public:
  /** The mesh must have a facet and outlive this object. */
  explicit RayCrossings(const ResolvedMesh& mesh)
    : Tree(mesh)
  {
  }

  /**
   * The numbers of triangles that two rays from a point cross, counted with their multiplicities.
   * Both are even or both odd if M is closed. In floating point: a triangle that contains a part of
   * a ray may or may not be counted.
   */
  std::array<int, 2> Count(const Point& point) const;

private:
  int Count(const Point& point, const Point& direction) const;

  FacetTree<3> Tree;
};

} // namespace carving

#endif
