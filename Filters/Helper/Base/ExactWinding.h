// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Winding numbers in front of facets, without rounding.
 */
#ifndef carving_ExactWinding_h
#define carving_ExactWinding_h

#include "Core/Mesh/FacetTree.h"

#include <optional>

namespace carving::helper
{

/**
 * Counts the facets of a closed mesh between infinity and a facet, along a line. A point in front
 * of the facet would have to be closer to the facet than anything else is, which rounding does not
 * allow where walls are close to each other.
 */
class ExactWinding
{
public:
  /**
   * The mesh must outlive this object. Its facets have areas, and do not cross each other. They may
   * cover each other.
   */
  explicit ExactWinding(const ResolvedMesh& mesh);

  /**
   * The winding number in front of a facet and of those that cover it. None if no line is found
   * that meets facets in their interior only, as where the facet is narrower than the rounding of
   * coordinates.
   */
  std::optional<int> InFrontOf(int facet) const;

private:
  std::optional<int> CountAlongLine(int facet, const Point& from, const Point& to) const;

  FacetTree<3> Tree;
  double Diagonal;
};

} // namespace carving::helper

#endif
