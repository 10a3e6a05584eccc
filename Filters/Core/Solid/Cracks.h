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
 * Adds facets to M across cracks through which its solid would be connected to the outside. These
 * are faces of cells no wider than MostCrackWidth that separate a region, which is solid by the
 * rule, from others. Each takes over the source of a facet that it touches. Returns their number.
 * `threads` are used to measure winding numbers.
 */
int SealCracks(Tetrahedralization& mesh, SolidRule rule, int threads);

} // namespace carving

#endif
