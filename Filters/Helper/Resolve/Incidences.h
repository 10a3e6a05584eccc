// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Which points lie on which edges and triangles but for rounding.
 */
#ifndef carving_Incidences_h
#define carving_Incidences_h

#include "Helper/Resolve/CoplanarGroup.h"
#include "Helper/Resolve/EdgeChains.h"

#include <vector>

namespace carving::helper
{

class Incidences
{
public:
  /**
   * Appends points to the mesh where edges or `segments` between its points pass each other within
   * the tolerance. No two points of the mesh may be within the tolerance of each other. The mesh
   * must outlive this object.
   */
  Incidences(ResolvedMesh& mesh, const EdgeList& segments, double tolerance);

  /** The points on a triangle, in ascending order. */
  const std::vector<int>& PointsOn(int facet) const
  {
    return this->OnFacets[facet];
  }

  /** The parts of the sides of a triangle. */
  std::vector<Side> SidesOf(int facet) const;

  /** The parts of edges and segments that lie on a triangle. */
  EdgeList PartsOn(int facet) const;

  /** The points that two triangles have in common. */
  std::vector<int> CommonPoints(int a, int b) const;

  /** Whether two triangles lie on each other: they have points in common that span an area. */
  bool AreFlush(int a, int b) const;

private:
  void FindPointsOnFacets();

  const ResolvedMesh& Mesh;
  double Tolerance;
  EdgeChains Chains;
  std::vector<std::vector<int>> OnFacets;
  std::vector<std::vector<int>> Neighbors; ///< of each point along parts
};

} // namespace carving::helper

#endif
