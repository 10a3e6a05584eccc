// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The Delaunay tetrahedralization that has as much of M as recovery and cutting reach. Not in the
 * paper.
 */
#ifndef carving_CutTetrahedra_h
#define carving_CutTetrahedra_h

#include "Core/Mesh/Progress.h"
#include "Helper/Enclosing/PiercedMesh.h"

#include <memory>
#include <vector>

namespace carving::helper
{

/** A tetrahedralization after recovery and cutting: its faces cover M as far as possible. */
struct CutTetrahedra
{
  ResolvedMesh
    Input; ///< M, with other triangles in some flat parts, and resolved if that meets more
  std::unique_ptr<PiercedMesh> Mesh;
  std::vector<Subdivision::Part> Needles; ///< parts almost without area that are not in the mesh
  bool Crosses = false;                   ///< the input crosses itself often
  int ResolvedPairs = 0;                  ///< see Enclosure
  double FlatDistance = 0.0;              ///< see Enclosure
};

/**
 * Recovers and cuts M or, if more of it is met then, the resolved M. `tolerance` is that of Cut;
 * with 0, M is only recovered. Parts that are flat within `flatness` and lack triangles after
 * recovery get other ones; with 0, none does. Both are lengths.
 */
CutTetrahedra CutBest(const ResolvedMesh& input, const std::vector<Point>& further,
  double tolerance, double flatness, int threads, const Progress& progress);

/**
 * Measures the share of M's area that is faces, which is returned, and that of each triangle's
 * area.
 */
double MeasureMetShares(const PiercedMesh& mesh, std::vector<double>& shares);

} // namespace carving::helper

#endif
