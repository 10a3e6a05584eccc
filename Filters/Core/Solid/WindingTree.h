// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Winding numbers of a mesh around many points, faster than one sum over all triangles for each.
 */
#ifndef carving_WindingTree_h
#define carving_WindingTree_h

#include "Core/Mesh/Mesh.h"

#include <array>
#include <vector>

namespace carving
{

/**
 * Signed solid angles summed up over a tree of triangles (Barill et al., "Fast winding numbers for
 * soups and clouds", 2018): what is far away counts as a whole, by the first two terms of its
 * expansion around its center of area. O(n log n) to build, about O(log n) a point.
 */
class WindingTree
{
public:
  explicit WindingTree(const ResolvedMesh& mesh);

  /**
   * The winding number around a point that lies on no facet, to about 0.02. A number so close to one
   * of `thresholds` in distance from an integer that its error may decide is summed up exactly.
   */
  double Measure(const Point& point, const std::vector<double>& thresholds = {}) const;

private:
  struct Node
  {
    int First, Last;           ///< its triangles
    int Second;                ///< its second child; the first comes next; -1: a leaf
    Point Center;              ///< of area
    double Radius;             ///< of a ball around Center that holds the triangles
    Point Area;                ///< the sum of the triangles' area vectors, times their windings
    std::array<Point, 3> Skew; ///< the same, each times (its centroid - Center)
  };

  struct Item
  {
    Point Centroid;
    int Triangle;
  };

  void Build(std::vector<Item>& items, int first, int last);
  Node Summarize(const std::vector<Item>& items, int first, int last) const;
  double Approximate(const Point& point, double opening) const;

  const ResolvedMesh& Mesh;
  std::vector<int> Triangles;
  std::vector<Node> Nodes;
};

} // namespace carving

#endif
