// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plane models similar to those in the paper's figures.
 */
#ifndef Contours_h
#define Contours_h

#include "Core/Mesh/Mesh.h"

#include <array>
#include <vector>

namespace models
{

/**
 * Closed polygons without crossings in the plane z = 0. The solid is to the left of the edges:
 * outer loops are counter-clockwise, holes are clockwise.
 */
struct ContourModel
{
  std::vector<carving::Point> Points;
  std::vector<std::array<int, 2>> Edges;
};

/**
 * Figure 9: a block with a deep, narrow, winding pocket, a deep spike and many shallow dents. The
 * walls of the pocket and of the spike have long edges and those of the dents have short ones, so
 * that carving by longest edge reaches the ends of the pocket and the spike before it opens any
 * dent. One loop.
 */
ContourModel SnakingContour();

/** Figures 2 and 5: a jug, whose outline has bays and whose handle leaves a hole. Two loops. */
ContourModel CarvedFigure();

} // namespace models

#endif
