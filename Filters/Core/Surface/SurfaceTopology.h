// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Components and genus of a level's surface. Not in the paper.
 */
#ifndef carving_SurfaceTopology_h
#define carving_SurfaceTopology_h

#include "Core/Surface/Manifold.h"

namespace carving
{

struct SurfaceTopology
{
  /** Sets of faces connected through shared vertices. Copies of a point are different vertices. */
  int Components = 0;
  /** The sum of the genus of all components; -1 if the surface is open. */
  int Genus = 0;
};

/**
 * Measures triangles that have been cut into oriented manifolds, in O(n log n) time. The numbers
 * differ from those of the closed complex K: in K, solids that touch in a vertex or an edge are one
 * component; here, the wall of a void is a component.
 */
SurfaceTopology MeasureSurface(const ManifoldLevel<3>& level);

/** The number of components of any surface, or of edges in a plane. */
template <int D>
int CountSurfaceComponents(const ManifoldLevel<D>& level);

} // namespace carving

#endif
