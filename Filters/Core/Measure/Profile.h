// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Size and topology of every approximation of a stream.
 */
#ifndef carving_Profile_h
#define carving_Profile_h

#include "Core/Stream/Faces.h"
#include "Core/Stream/StoredStream.h"

#include <vector>

namespace carving
{

/**
 * One entry per step, from C0 on. Vertices and triangles (in the plane, edges) are those of that
 * approximation before it is cut into manifolds.
 */
struct Profile
{
  std::vector<int> Vertices;
  std::vector<int> Triangles;
  /** Of the solid and the cells that are not carved, M's coordinates to the power of D; never grows. */
  std::vector<double> Volume;
  /** Betti numbers of the closed complex; SetTopology fills them. In a plane tunnels are holes. */
  std::vector<int> Components;
  std::vector<int> Tunnels;
  std::vector<int> Voids;
  /** How far each is from M (ComputeErrors); empty if that has not been asked for. */
  std::vector<double> Error;
  /** Of the tetrahedron popped at that step; NaN for C0. */
  std::vector<double> Priority;
  /** The smallest priority popped so far, as a length (PriorityAsLength); infinite for C0. */
  std::vector<double> FeatureSize;

  int LastStep() const
  {
    return static_cast<int>(this->Vertices.size()) - 1;
  }
};

/**
 * All but the topology. O(cells): sums up where each vertex and face appears and vanishes, and how much
 * each step carves away.
 */
template <int D>
Profile ComputeProfile(const StoredStream<D>& stream);

/** Fills `Priority` and `FeatureSize`. */
template <int D>
void SetPriorities(
  Profile& profile, const std::vector<double>& stepPriorities, PriorityMeasure measure);

} // namespace carving

#endif
