// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_RecoverAll_h
#define carving_RecoverAll_h

#include "Core/Mesh/Mesh.h"
#include "Helper/Base/Ending.h"

#include <functional>
#include <vector>

namespace carving::helper
{

/** How much work recovery may take: little suffices for a mesh that is nearly Delaunay. */
enum class RecoveryEffort
{
  Little,
  Much
};

/**
 * A tetrahedralization of the convex hull of a resolved mesh and of further points in which every
 * triangle is a face, by recovery in a Delaunay tetrahedralization.
 *
 * `result.Surface` is the mesh; the other members are filled, and the further points and the points
 * that recovery adds are appended to its points. On failure, `result` is as it was. The result does
 * not depend on `threads`.
 */
Ending RecoverAll(const std::vector<Point>& further, RecoveryEffort effort, int threads,
  const std::function<bool(double)>& progress, Tetrahedralization& result);

} // namespace carving::helper

#endif
