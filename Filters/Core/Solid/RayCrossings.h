// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Crossings of rays with a mesh.
 */
#ifndef carving_RayCrossings_h
#define carving_RayCrossings_h

#include "Core/Mesh/FacetTree.h"

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
   * The number of triangles that a ray from a point crosses, counted with their multiplicities. No
   * model is likely to be aligned with the ray's direction. In floating point: a triangle that
   * contains a part of the ray may or may not be counted.
   */
  int Count(const Point& point) const;

private:
  FacetTree<3> Tree;
};

} // namespace carving

#endif
