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
 * Closes the cracks through which M's solid would be connected to the outside, with facets that
 * are added to M ("seals"). A seal is a face of a cell, at most as wide as a crack, between a
 * solid region and another one. A patch of seals is on average no wider than a crack. Each seal
 * takes over the source of a facet that it touches. Returns the number of seals. Several threads
 * measure winding numbers.
 */
int SealCracks(Tetrahedralization& mesh, SolidRule rule, int threads);

} // namespace carving

#endif
