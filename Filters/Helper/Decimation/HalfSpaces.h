// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The least point of a quadric in an intersection of half-spaces.
 */
#ifndef carving_HalfSpaces_h
#define carving_HalfSpaces_h

#include "Helper/Decimation/Quadric.h"

#include <vector>

namespace carving::helper
{

/** All x with Normal . x >= Offset. The normal has length 1. */
struct HalfSpace
{
  Point Normal;
  double Offset;
};

/**
 * Finds the point of the half-spaces at which a positive definite quadric is least, incrementally
 * (Seidel, "Small-dimensional linear programming and convex hulls made easy", 1991): a new
 * constraint that the best point so far violates is tight, which leaves a problem of one dimension
 * less. Linear in the number of half-spaces if their order is random. Returns false if there is no
 * such point.
 */
bool Minimize(const Quadric& quadric, const std::vector<HalfSpace>& halfSpaces, Point& least);

} // namespace carving::helper

#endif
