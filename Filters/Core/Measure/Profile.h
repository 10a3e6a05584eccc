// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Size and topology of every approximation of a stream. Not in the paper.
 */
#ifndef carving_Profile_h
#define carving_Profile_h

#include "Core/Stream/Faces.h"
#include "Core/Stream/StoredStream.h"

#include <vector>

namespace carving
{

/** Betti numbers of the closed complex K (ComputeTopology). In the plane, tunnels are holes. */
struct StreamTopology
{
  std::vector<int> Components;
  std::vector<int> Tunnels;
  std::vector<int> Voids;
};

/**
 * One entry per step, from C0 on. Vertices and triangles (in the plane, edges) are counted before
 * the approximation is cut into manifolds.
 */
struct Profile : StreamTopology
{
  std::vector<int> Vertices;
  std::vector<int> Triangles;
  /**
   * The volume (in the plane, the area) of the solid and the remaining cells. Does not increase.
   */
  std::vector<double> Volume;
  /** The distance of each approximation from M (ComputeErrors); empty unless requested. */
  std::vector<double> Error;
  /** The priority of the tetrahedron popped in the step; NaN for C0. */
  std::vector<double> Priority;
  /** The smallest priority popped so far, as a length (PriorityAsLength); infinite for C0. */
  std::vector<double> FeatureSize;

  int LastStep() const
  {
    return static_cast<int>(this->Vertices.size()) - 1;
  }
};

/**
 * Computes everything except topology and errors, in time linear in the number of cells, from the
 * steps in which each vertex and face appears and vanishes and from the volumes that each step
 * removes.
 */
template <int D>
Profile ComputeProfile(const StoredStream<D>& stream);

/** Fills `Priority` and `FeatureSize`. */
template <int D>
void SetPriorities(
  Profile& profile, const std::vector<double>& stepPriorities, PriorityMeasure measure);

} // namespace carving

#endif
