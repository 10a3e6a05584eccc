// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * How far triangles reach from M.
 */
#ifndef carving_SurfaceDistance_h
#define carving_SurfaceDistance_h

#include "Core/Mesh/Mesh.h"

#include <memory>

class SurfaceDistance
{
public:
  explicit SurfaceDistance(const carving::ResolvedMesh& surface);
  ~SurfaceDistance();

  using Corners = std::array<carving::Point, 3>;

  /** Whether no point of a triangle is farther from M than `distance`, to 5 %. */
  bool IsWithin(const Corners& triangle, double distance) const;

  /** The distance from M of the farthest point of a triangle, to 5 %, or `atLeast` if that is more. */
  double Farthest(const Corners& triangle, double atLeast) const;

private:
  struct Tree;
  std::unique_ptr<Tree> Locator;
};

#endif
