// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Components, tunnels and voids of every approximation of a stream. Not in the paper.
 */
#ifndef carving_StreamTopology_h
#define carving_StreamTopology_h

#include "Core/Carving/Stream.h"
#include "Core/Measure/Profile.h"
#include "Core/Mesh/Mesh.h"
#include "Core/Solid/Classification.h"

namespace carving
{

/**
 * Computes the Betti numbers of the closed complex K_i, which consists of M and all cells that are
 * not carved until step i, those of the solid included, with all their faces, edges and vertices.
 *
 * Components are counted by union-find over vertices while cells are put back, from the last step
 * to the first. A void begins with the first tetrahedron carved in a region that M encloses. It
 * remains one void, since carving in the region proceeds from there. In the plane there are no
 * voids. Tunnels (in the plane, holes) follow from the Euler characteristic: V - E + F - T =
 * components - tunnels + voids. Takes O(n alpha(n)) time for n cells.
 * The mesh may lack the cells of the solid (DropSolid).
 */
template <int D>
StreamTopology ComputeTopology(
  const Decomposition<D>& mesh, const Classification& regions, const Stream& stream);

} // namespace carving

#endif
