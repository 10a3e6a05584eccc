// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which facet of a mesh is closest to a point.
 */
#ifndef carving_FacetTree_h
#define carving_FacetTree_h

#include "Core/Mesh/Mesh.h"

#include <vector>

namespace carving
{

/** The points of a triangle or an edge. */
template <int D>
using FacetCorners = std::array<Point, D>;

template <int D>
FacetCorners<D> CornersOf(const std::vector<Point>& points, const std::array<int, D>& facet)
{
  FacetCorners<D> corners;
  for (int i = 0; i < D; ++i)
  {
    corners[i] = points[facet[i]];
  }
  return corners;
}

/** How far a point is from a triangle (D = 3) or an edge (D = 2) that is no point. */
double DistanceTo(const FacetCorners<2>& edge, const Point& p);
double DistanceTo(const FacetCorners<3>& triangle, const Point& p);

/**
 * A tree of boxes around facets. VTK's locators search a grid of buckets, which takes many times as long
 * from points that are far from all facets, as most are here.
 */
template <int D>
class FacetTree
{
public:
  /** The mesh has to live as long as the tree, and to have a facet. */
  explicit FacetTree(const ResolvedInput<D>& mesh);

  struct Closest
  {
    FacetCorners<D> Facet;
    double Distance;
  };
  Closest Find(const Point& p) const;

private:
  /** Of the facets from First on, before Last; the children follow, unless it is a leaf. */
  struct Node
  {
    Point Lower;
    Point Upper;
    int First;
    int Last;
    int Second; ///< the second child, the first is the next node; 0 for a leaf
  };

  void Build(const std::vector<Point>& centers, int first, int last);
  static double SquaredDistance(const Node& node, const Point& p);

  const ResolvedInput<D>& Mesh;
  std::vector<int> Facets;
  std::vector<Node> Nodes;
};

} // namespace carving

#endif
