// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Shuffle_h
#define carving_Shuffle_h

#include "Core/Mesh/Mesh.h"

/** Puts the points and the facets in the order of a seed, 0 for their own. */
void Shuffle(int seed, carving::ResolvedMesh& surface);

#endif
