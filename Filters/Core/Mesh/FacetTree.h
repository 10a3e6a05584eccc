// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The facet of a mesh that is closest to a point.
 */
#ifndef carving_FacetTree_h
#define carving_FacetTree_h

#include "Core/Mesh/BoxTree.h"
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

/**
 * The length of the diagonal of the facets' bounding box; 0 without facets. A mesh in a
 * tetrahedralization has further points, which may be far from its facets.
 */
template <int D>
double Diagonal(const ResolvedInput<D>& mesh);

/** The distance of a point from a triangle (D = 3) or an edge (D = 2) of nonzero length. */
double DistanceTo(const FacetCorners<2>& edge, const Point& p);
double DistanceTo(const FacetCorners<3>& triangle, const Point& p);

/** The facets of a mesh as items of a tree. */
template <int D>
class FacetItems
{
public:
  /** The mesh must outlive this object. */
  explicit FacetItems(const ResolvedInput<D>& mesh)
    : Mesh(&mesh)
  {
  }

  std::size_t GetNumberOfItems() const
  {
    return this->Mesh->Facets.size();
  }
  FacetCorners<D> CornersOf(int facet) const
  {
    return carving::CornersOf<D>(this->Mesh->Points, this->Mesh->Facets[facet]);
  }
  Box BoxOf(int facet) const
  {
    return BoxAround(this->CornersOf(facet));
  }
  const ResolvedInput<D>& GetMesh() const
  {
    return *this->Mesh;
  }

private:
  const ResolvedInput<D>* Mesh;
};

/**
 * A search tree for facets. Most queries start far from all facets, where VTK's locators, which
 * search a grid of buckets, take many times as long.
 */
template <int D>
class FacetTree : public BoxTree<FacetItems<D>>
{
public:
  /** The mesh must have a facet and outlive the tree. */
  explicit FacetTree(const ResolvedInput<D>& mesh);

  struct Closest
  {
    double Distance;
    int Item; ///< its index; -1 if the area of each facet is zero
  };
  /** Stops early at a facet whose distance is at most `enough`. Begins at `nearby`, if given. */
  Closest Find(const Point& p, double enough = 0.0, int nearby = -1) const;
};

} // namespace carving

#endif
