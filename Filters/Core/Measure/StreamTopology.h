// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Components, tunnels and voids of every approximation of a stream.
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
 * Fills `Components`, `Tunnels` and `Voids`: the Betti numbers of the closed complex K_i of M and all
 * cells, those of the solid included, that are not carved away until step i. A face, edge or vertex stays
 * in it as long as something around it does.
 *
 * Components are counted by uniting vertices while cells are put back, from the last step to the first.
 * A void opens with the first tetrahedron that is carved in a region that M encloses, and stays one, since
 * carving only goes on from what it has carved; in a plane there are none. Tunnels (in a plane, holes)
 * follow from the Euler characteristic: V - E + F - T = components - tunnels + voids. The time it takes is
 * linear, but for the sets.
 */
template <int D>
void SetTopology(Profile& profile, const Decomposition<D>& mesh, const Classification& regions,
  const Stream& stream);

} // namespace carving

#endif
