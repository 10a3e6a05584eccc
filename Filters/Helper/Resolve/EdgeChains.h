// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The edges of a mesh as chains through the points that lie on them but for rounding.
 */
#ifndef carving_EdgeChains_h
#define carving_EdgeChains_h

#include "Core/Mesh/Mesh.h"

#include <array>
#include <vector>

namespace carving::helper
{

/** A set of edges, or of parts of edges: their ends, the lower first, in ascending order. */
using EdgeList = std::vector<std::array<int, 2>>;

class EdgeChains
{
public:
  /**
   * Divides each edge, and each of further `segments` between points of the mesh, at the points
   * that are within `tolerance` of it. Where two of them pass each other within the tolerance,
   * appends a point midway to the mesh, and divides both there. No two points of the mesh may be
   * within the tolerance of each other.
   */
  EdgeChains(ResolvedMesh& mesh, const EdgeList& segments, double tolerance);

  /** The points from a to b on the edge between them, without b. */
  std::vector<int> Get(int a, int b) const;

  /** The parts of all edges and segments. */
  EdgeList GetParts() const;

private:
  struct Place
  {
    double Share; ///< of the way from the lower end of an edge
    int Point;
  };

  int Find(int a, int b) const;
  void DivideAtPoints(const ResolvedMesh& mesh, double tolerance);
  void DivideAtCrossings(ResolvedMesh& mesh, double tolerance);
  static std::vector<std::vector<Place>> FindCrossings(
    const EdgeList& parts, double tolerance, ResolvedMesh& mesh);
  void Insert(const EdgeList& parts, std::vector<std::vector<Place>> places);

  EdgeList Edges;
  std::vector<std::vector<int>> Inner; ///< points on each edge, from its lower end
};

} // namespace carving::helper

#endif
