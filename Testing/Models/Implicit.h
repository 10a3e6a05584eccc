// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Solids given by a function that is negative inside.
 */
#ifndef Implicit_h
#define Implicit_h

#include "Core/Mesh/Mesh.h"

#include <array>
#include <functional>

namespace models
{

using carving::TriangleMesh;

using Implicit = std::function<double(const carving::Point&)>;

/**
 * The zero set of `solid`, from its values at the nodes of a grid: closed, manifold, oriented
 * outward and without crossings, provided that no node on the border of the grid is inside.
 */
TriangleMesh Isosurface(const Implicit& solid, const carving::Point& lower,
  const carving::Point& upper, const std::array<int, 3>& cells);

/** The minimum (maximum) of two values, smoothed where they differ by less than `width`. */
double SmoothMin(double a, double b, double width);
double SmoothMax(double a, double b, double width);

/** The distance of p from the segment between a and b. */
double SegmentDistance(const carving::Point& p, const carving::Point& a, const carving::Point& b);

} // namespace models

#endif
