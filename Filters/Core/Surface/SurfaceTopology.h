// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Components and genus of a level's own surface.
 */
#ifndef carving_SurfaceTopology_h
#define carving_SurfaceTopology_h

#include "Core/Surface/Manifold.h"

namespace carving
{

struct SurfaceTopology
{
  /** Sets of faces that are joined by shared vertices; copies of a point are different vertices. */
  int Components = 0;
  /** The sum of all components' genus; -1 where some edge has not one face on either side. */
  int Genus = 0;
};

/**
 * Of triangles that have been cut into oriented manifolds. Other than of the closed complex, of which
 * solids that touch in one vertex or edge are one component, and which knows of the solid between
 * surfaces: a void's wall is a component here. O(n log n).
 */
SurfaceTopology MeasureSurface(const ManifoldLevel<3>& level);

/** The components alone, of any surface and of edges in a plane. */
template <int D>
int CountSurfaceComponents(const ManifoldLevel<D>& level);

} // namespace carving

#endif
