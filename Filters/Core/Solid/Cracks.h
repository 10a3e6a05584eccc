// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Cracks between the triangles of M. Not in the paper.
 */
#ifndef carving_Cracks_h
#define carving_Cracks_h

#include "Core/Solid/Classification.h"

namespace carving
{

/**
 * The greatest width of a crack, as a share of M's diagonal: rounding coordinates to single
 * precision opens cracks of about a tenth of it where vertices lie on edges of other triangles.
 */
constexpr double MostCrackWidth = 1e-6;

/**
 * Adds facets to M across cracks through which its solid would be connected to the outside. They
 * are faces of cells that are no wider than a crack, and separate solid regions from others. A patch
 * of them is no wider on average. Each facet takes over the source of one that it touches. Returns
 * their number. Several threads measure winding numbers.
 */
int SealCracks(Tetrahedralization& mesh, SolidRule rule, int threads);

} // namespace carving

#endif
