// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_EdgeSplitter_h
#define carving_EdgeSplitter_h

#include "Core/Mesh/Mesh.h"

#include <array>
#include <map>
#include <vector>

namespace carving::helper
{

/** Splits edges of a tetrahedralization, and the tetrahedra and facets of M around them. */
class EdgeSplitter
{
public:
  using Edge = std::array<int, 2>; ///< the lower end first

  /** Only these edges, in ascending order, can be split. The mesh must outlive this object. */
  EdgeSplitter(const std::vector<Edge>& edges, Tetrahedralization& mesh);

  /**
   * Splits an edge at a share of the way from its lower end, or up to `room` away: at a place where
   * all tetrahedra stay positively oriented, exactly. Returns whether there is one.
   */
  bool Split(const Edge& edge, double share, double room);

  /** Hands the facets on which faces lie over to the mesh, which has the old ones before. */
  void Finish();

private:
  /** For each facet at an edge that has been split: the part at the upper end. */
  using UpperFacets = std::map<int, int>;

  int CornerOf(int cell, int point) const;
  bool MaySplitAt(const Edge& edge, const Point& p) const;
  void SplitAt(const Edge& edge, int point);
  int SplitCell(int lower, const Edge& edge, int point, UpperFacets& upperFacets);
  void SplitFacets(int lower, int upper, const Edge& edge, int point, UpperFacets& upperFacets);
  void UpdateCellsAround(int lower, int upper, const Edge& edge);

  Tetrahedralization& Mesh;
  std::vector<FaceConstraints<3>::Facets> Constraints; ///< per cell
  std::map<Edge, std::vector<int>> CellsAround;        ///< of the edges that can be split
};

} // namespace carving::helper

#endif
