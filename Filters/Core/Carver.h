// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The carving itself: in which order the tetrahedra of the complement disappear.
 */
#ifndef carving_Carver_h
#define carving_Carver_h

#include "Classification.h"
#include "Mesh.h"
#include "Progress.h"

#include <limits>
#include <vector>

namespace carving
{

struct CarveOptions
{
  /** Exposed neighbors of a carved tetrahedron follow in the same step (section 3.4). */
  bool CarveExposed = true;
};

/**
 * The order in which a carving removes tetrahedra.
 *
 * A step is one pop from the queue with all that it takes along; step 0 is the initial approximation
 * C0, so that a stream of n steps has n + 1 approximations.
 */
struct Stream
{
  static constexpr int Never = std::numeric_limits<int>::max();

  /** Per tetrahedron: it is missing from every C_j with j >= Step. `Never` where it stays. */
  std::vector<int> Step;
  /** Per tetrahedron: its priority, the length of its longest edge; NaN where it stays. */
  std::vector<double> Priority;
  /** Per tetrahedron: its level in the hierarchy of section 5.3, from 1; 0 where it stays. */
  std::vector<int> Depth;
  /** Per step: the priority of the tetrahedron that was popped; NaN for step 0. */
  std::vector<double> StepPriority;

  /** n: the last approximation is C_n. */
  int LastStep() const
  {
    return static_cast<int>(this->StepPriority.size()) - 1;
  }
};

/**
 * Carves the complement, longest edge first (section 4), ties by the smaller tetrahedron index.
 * Exposed tetrahedra are those of degree above one. Every void is opened at its tetrahedron of highest priority (section 3).
 *
 * Returns false when `progress` asked to stop; `stream` is then incomplete.
 */
bool Carve(const Tetrahedralization& mesh, const Classification& regions,
  const CarveOptions& options, Stream& stream, const Progress& progress = {});

} // namespace carving

#endif
