// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Shuffle_h
#define carving_Shuffle_h

#include "Core/Mesh/Mesh.h"

namespace carving::helper
{

/** Puts the points and the facets in an order drawn from a seed; seed 0 keeps the given order. */
void Shuffle(int seed, ResolvedMesh& surface);

} // namespace carving::helper

#endif
