// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether an indexed surface is an oriented manifold, judged by its indices alone.
 */
#ifndef ManifoldCheck_h
#define ManifoldCheck_h

#include "Core/Surface/Manifold.h"

namespace checks
{

struct ManifoldFaults
{
  int CrowdedEdges = 0;     ///< with more than two triangles
  int MisorientedEdges = 0; ///< used by both triangles in the same direction
  int SeveralFans = 0;      ///< vertices whose triangles are not one fan
  int OpenSolidEdges = 0;   ///< used by one triangle only, which is no fold
  int MovedCorners = 0;     ///< at another point than before cutting
};

ManifoldFaults FindFaults(const carving::Level<3>& level, const carving::ManifoldLevel<3>& cut);

/** The sum of the genus of all closed components, by V - E + F of each. */
int Genus(const carving::ManifoldLevel<3>& cut);

inline bool operator==(const ManifoldFaults& a, const ManifoldFaults& b)
{
  return a.CrowdedEdges == b.CrowdedEdges && a.MisorientedEdges == b.MisorientedEdges &&
    a.SeveralFans == b.SeveralFans && a.OpenSolidEdges == b.OpenSolidEdges &&
    a.MovedCorners == b.MovedCorners;
}

} // namespace checks

#endif
