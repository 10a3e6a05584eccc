// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Decimation of a closed surface into surfaces that enclose it. Not in the paper.
 */
#ifndef carving_EnclosingDecimation_h
#define carving_EnclosingDecimation_h

#include "Core/Mesh/Progress.h"
#include "Core/Protocol/Protocol.h"

#include <string>
#include <vector>

namespace carving::helper
{

/**
 * Decimates a closed surface, once per target. Every result is a closed, oriented manifold of the same topology that
 * encloses the surface and does not cross itself.
 *
 * Equal points of the surface are merged, unless the surface is closed without that. The surface may be oriented
 * outward or inward. Appends to `results` in the order of `options.Targets`. Returns an empty string, or an error for the
 * user: the surface is open, not manifold or crosses itself.
 */
std::string DecimateEnclosing(const TriangleMesh& surface, const DecimationOptions& options,
  std::vector<DecimatedSurface>& results, const Progress& progress = {});

} // namespace carving::helper

#endif
