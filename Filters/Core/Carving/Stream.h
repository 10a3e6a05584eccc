// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The result of a carving: the step in which each cell disappears.
 */
#ifndef carving_Stream_h
#define carving_Stream_h

#include <limits>
#include <vector>

namespace carving
{

/**
 * The order in which a carving removes tetrahedra (section 3.3).
 *
 * A step is one pop from the queue, with the tetrahedra that follow it. Step 0 is the initial
 * approximation C0, so that a stream of n steps has n + 1 approximations.
 */
struct Stream
{
  static constexpr int Never = std::numeric_limits<int>::max();

  /** Per tetrahedron: it is missing from every C_j with j >= Step. `Never` if it stays. */
  std::vector<int> Step;
  /** Per tetrahedron: its priority by equation (2); NaN if it stays. */
  std::vector<double> Priority;
  /** Per tetrahedron: its depth; 0 if it stays. */
  std::vector<double> Depth;
  /** Per step: the priority of the tetrahedron that was popped; NaN for step 0. */
  std::vector<double> StepPriority;

  /** n: the last approximation is C_n. */
  int LastStep() const
  {
    return static_cast<int>(this->StepPriority.size()) - 1;
  }
};

} // namespace carving

#endif
