// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The mesh M that a surface must enclose while the surface changes.
 */
#ifndef carving_Obstacle_h
#define carving_Obstacle_h

#include "Helper/Decimation/ObstacleSearch.h"
#include "Helper/Decimation/SurfaceMesh.h"

#include <initializer_list>
#include <optional>
#include <vector>

namespace carving::helper
{

class Obstacle
{
public:
  /** The tree of M must outlive this object. */
  explicit Obstacle(const FacetTree<3>& tree);

  /**
   * The first contact of the faces around w with the boundary of a star while w moves; in floating
   * point.
   */
  std::optional<FirstContact> FindContact(const Star& star, const Point& from, const Point& to);

  /**
   * Whether M stays enclosed by a surface when faces around w replace those of a star: the
   * tetrahedra between w and the faces that w is behind leave the solid. Exact. Says no in some
   * cases in which M only touches the tetrahedra.
   */
  bool StaysEnclosed(const Star& star, const Point& w);

private:
  void AssignVerticesAndEdges();
  bool IsFlat(int corner, int otherCorner) const;
  void MoveTo(const Star& star, std::initializer_list<Point> points);

  ObstacleSearch Triangles;
  /**
   * Bit k: the search for contacts takes corner k from this triangle. So for edges, from corner k
   * on.
   */
  std::vector<unsigned char> Vertices, Edges;
  double Margin;
};

} // namespace carving::helper

#endif
