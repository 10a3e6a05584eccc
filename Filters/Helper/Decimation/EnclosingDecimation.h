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

namespace carving::helper
{

/**
 * Decimates a closed surface around a mesh, or the mesh itself, once per target. Every result is a
 * closed, oriented manifold of the surface's topology that encloses the mesh and its parts and does
 * not cross itself. Nested results enclose the surface, too. Distances are those from the mesh.
 *
 * Equal points of the surface are merged, unless the surface is closed without that. The surface
 * may be oriented outward or inward. Returns an empty string, or an error for the user: the surface
 * is open, not manifold or crosses itself. With several threads, the error of each result is
 * measured while the next one is made.
 */
std::string DecimateEnclosing(const TriangleMesh& surface, const TriangleMesh& mesh,
  const TriangleMesh& parts, const DecimationOptions& options, Decimation& result,
  const Progress& progress = {}, int threads = 1);

} // namespace carving::helper

#endif
