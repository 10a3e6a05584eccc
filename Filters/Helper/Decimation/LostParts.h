// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The parts of a solid that are lost when the faces around a vertex change.
 */
#ifndef carving_LostParts_h
#define carving_LostParts_h

#include "Core/Mesh/Box.h"
#include "Helper/Decimation/SurfaceMesh.h"
#include "Helper/Enclosing/Pierce.h"

#include <array>
#include <vector>

namespace carving::helper
{

/**
 * The parts of the solid that are lost when faces around w replace those of a star: tetrahedra
 * between w and the faces that w is behind, and where the solid is a sheet without thickness,
 * triangles between w and the ends of the sheet that vanish with the star.
 */
class LostParts
{
public:
  LostParts(const Star& star, const Point& w);

  /** Whether anything in a box may meet a part. */
  bool MayMeet(const Box& box) const;

  /**
   * Whether a triangle with a bounding box pierces a part, or overlaps it or a face of it in an
   * area. Exact.
   */
  bool Meet(const std::array<Point, 3>& triangle, const Box& bounds) const;

private:
  struct Tetrahedron
  {
    explicit Tetrahedron(const std::array<Point, 4>& corners);
    bool MayMeet(const Box& box) const;

    Box Bounds;
    Corners4 Corners;                   ///< positively oriented
    std::array<SpannedPlane, 4> Planes; ///< of the faces, from their first corners
  };

  struct Triangle
  {
    Box Bounds;
    Corners3 Corners;
  };

  void AddFromSheets(const Star& star, const std::vector<std::size_t>& flat, const Point& w);

  std::vector<Tetrahedron> Tetrahedra;
  std::vector<Triangle> Triangles;
};

} // namespace carving::helper

#endif
