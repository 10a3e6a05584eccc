// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fast winding numbers of a mesh around many points.
 */
#ifndef carving_WindingTree_h
#define carving_WindingTree_h

#include "Core/Mesh/Mesh.h"

#include <array>
#include <vector>

namespace carving
{

/**
 * A tree of triangles for hierarchical sums of signed solid angles (Barill et al., "Fast winding
 * numbers for soups and clouds", 2018). A distant node contributes the first two terms of its
 * expansion around its center of area. Building takes O(n log n) time, a query about O(log n).
 */
class WindingTree
{
public:
  explicit WindingTree(const ResolvedMesh& mesh);

  /**
   * The winding number around a point that lies on no facet, to about 0.02. `thresholds` are
   * distances from the nearest integer: where the error could move the result across one of them,
   * the sum is refined until it cannot.
   */
  double Measure(const Point& point, const std::vector<double>& thresholds = {}) const;

private:
  struct Node
  {
    int First, Last;           ///< triangles First to Last - 1
    int Second;                ///< the second child; the first is the next node; -1 for a leaf
    Point Center;              ///< of area
    double Radius;             ///< of a ball around Center that contains the triangles
    Point Area;                ///< the sum of area vector times signed multiplicity
    std::array<Point, 3> Skew; ///< the same sum, each term times (centroid - Center)
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
