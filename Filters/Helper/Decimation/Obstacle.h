// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The mesh M that a surface must enclose while the surface changes.
 */
#ifndef carving_Obstacle_h
#define carving_Obstacle_h

#include "Core/Mesh/FacetTree.h"
#include "Helper/Decimation/FirstContact.h"

#include <optional>
#include <vector>

namespace carving::helper
{

class Obstacle
{
public:
  /** The tree of M must outlive this object. */
  explicit Obstacle(const FacetTree<3>& tree);

  /** The first contact of a fan while its vertex w moves; in floating point. */
  std::optional<FirstContact> FindContact(const Fan& fan, const Point& from, const Point& to) const;

  /**
   * Whether M stays enclosed by a surface when the tetrahedra between some of its faces and w,
   * which lies behind them, leave the solid. Exact. Says no in some cases in which M only touches
   * the tetrahedra.
   */
  bool AllowsRemoval(const std::vector<std::array<Point, 3>>& faces, const Point& w) const;

private:
  void AssignVerticesAndEdges();

  const FacetTree<3>& Tree;
  /**
   * Bit k: the search for contacts takes corner k from this triangle. So for edges, from corner k
   * on.
   */
  std::vector<unsigned char> Vertices, Edges;
  double Margin;
};

} // namespace carving::helper

#endif
