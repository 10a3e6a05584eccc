// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The faces of a level that lie on M only up to roundings. Not in the paper.
 */
#ifndef carving_LevelParts_h
#define carving_LevelParts_h

#include "Core/Mesh/Mesh.h"
#include "Core/Stream/Level.h"

namespace carving
{

/**
 * The faces of a level that are parts of M's triangles. M has `numberOfPoints` points. There are
 * none in exact mode.
 *
 * In enclosing mode, the points that divide a triangle of M are rounded. Levels enclose the parts,
 * but the triangle only up to these roundings. A surface that changes has to be kept around the
 * parts as well: kept around the triangle alone, the surface could lose all of the triangle that a
 * rounding has left outside.
 */
TriangleMesh ExtractParts(
  const StoredStream<3>& stream, const Level<3>& level, std::size_t numberOfPoints);

} // namespace carving

#endif
