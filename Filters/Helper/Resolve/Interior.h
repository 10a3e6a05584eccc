// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Interior_h
#define carving_Interior_h

#include "Core/Mesh/Mesh.h"
#include "Core/Solid/Classification.h"

/**
 * Leaves out the triangles that have solid on both sides by a rule, which no level shows, and the points
 * that only they use. The others' `SignedMultiplicities` and `Multiplicities` become those of the boundary of the solid, so that
 * by the same rule the same is solid. Returns how many were left out: none, and nothing is changed, where
 * the mesh, which has been resolved, is not closed or what is solid cannot be told.
 */
int DropInterior(carving::SolidRule rule, carving::ResolvedMesh& mesh);

#endif
