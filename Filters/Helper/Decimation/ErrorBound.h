// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The distance from M that collapses may not exceed.
 */
#ifndef carving_ErrorBound_h
#define carving_ErrorBound_h

#include "Core/Mesh/FaceDistance.h"
#include "Helper/Decimation/HeightBound.h"
#include "Helper/Decimation/SurfaceMesh.h"

#include <vector>

namespace carving::helper
{

/**
 * A bound that rises. For each edge that cannot collapse within the bound, this object keeps the
 * distance that was too large: up to this distance, another attempt would fail again, which takes
 * long.
 */
class ErrorBound
{
public:
  /** `fromM` must outlive this object. The bound is 0 at first. */
  ErrorBound(const FaceDistance<3>& fromM, std::size_t numberOfEdges);

  double Get() const
  {
    return this->Bound;
  }

  /** Returns false, and keeps the last bound, if that was at least as great. */
  bool Raise(double bound);

  /** Whether no new face of a star with w in the middle is farther. */
  bool Allows(const Star& star, const Point& w)
  {
    return this->FindExcess(star, w) == 0.0;
  }

  /** The same for an attempt to collapse an edge. Keeps the distance that is too large. */
  bool Allows(SurfaceMesh::Edge_index edge, const Star& star, const Point& w);

  /** Whether another attempt may succeed, if the faces around the edge have not changed. */
  bool MayAllow(SurfaceMesh::Edge_index edge) const
  {
    return this->Excesses[edge] < this->Bound;
  }

  /** Forgets the distance of an edge, which is tried again. */
  void Forget(SurfaceMesh::Edge_index edge)
  {
    this->Excesses[edge] = 0.0;
  }

  /** Forgets the distances of all edges, which may now collapse in new ways. */
  void ForgetAll();

private:
  double FindExcess(const Star& star, const Point& w);

  const FaceDistance<3>& FromM;
  HeightBound Heights; ///< above M
  double Bound = 0.0;
  std::vector<double> Excesses; ///< per edge: the least distance that was too large, or 0
  long long SavedQueries;       ///< that earlier faces have left over
};

} // namespace carving::helper

#endif
