// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The facet of a mesh that is closest to a point.
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

/** The distance of a point from a triangle (D = 3) or an edge (D = 2) of nonzero length. */
double DistanceTo(const FacetCorners<2>& edge, const Point& p);
double DistanceTo(const FacetCorners<3>& triangle, const Point& p);

/**
 * A bounding volume hierarchy of axis-aligned boxes around facets. Most queries start far from all
 * facets, where VTK's locators, which search a grid of buckets, take many times as long.
 */
template <int D>
class FacetTree
{
public:
  /** The mesh must have a facet and outlive the tree. */
  explicit FacetTree(const ResolvedInput<D>& mesh);

  struct Closest
  {
    FacetCorners<D> Facet;
    double Distance;
  };
  Closest Find(const Point& p) const;

private:
  /** The box of facets First to Last - 1. The first child is the next node. */
  struct Node
  {
    Point Lower;
    Point Upper;
    int First;
    int Last;
    int Second; ///< the second child; 0 for a leaf
  };

  void Build(const std::vector<Point>& centers, int first, int last);
  static double SquaredDistance(const Node& node, const Point& p);

  const ResolvedInput<D>& Mesh;
  std::vector<int> Facets;
  std::vector<Node> Nodes;
};

} // namespace carving

#endif
