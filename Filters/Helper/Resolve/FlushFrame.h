// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The directions of the planes in which faces of parts lie flush. Not in the paper.
 */
#ifndef carving_FlushFrame_h
#define carving_FlushFrame_h

#include "Core/Mesh/Mesh.h"

#include <array>
#include <optional>

namespace carving::helper
{

/** A frame of three orthogonal directions. */
class FlushFrame
{
public:
  /**
   * The frame along the normal that most of a mesh's area has, and the one that most of the area
   * perpendicular to it has. None if these are coordinate axes, or if little area has a common
   * normal.
   */
  static std::optional<FlushFrame> Find(const ResolvedMesh& mesh);

  Point ToFrame(const Point& p) const;
  Point FromFrame(const Point& p) const;

private:
  explicit FlushFrame(const std::array<Point, 3>& axes)
    : Axes(axes)
  {
  }

  std::array<Point, 3> Axes;
};

} // namespace carving::helper

#endif
