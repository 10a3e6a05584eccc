// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The distance of a whole face from a mesh. Not in the paper.
 */
#ifndef carving_FaceDistance_h
#define carving_FaceDistance_h

#include "Core/Mesh/FacetTree.h"

#include <vector>

namespace carving
{

/**
 * The radius of the smallest ball around a face. No point of the face is farther from the nearest
 * corner.
 */
template <int D>
double BallRadius(const FacetCorners<D>& face);

/** The longest side of a face, from this corner to the next. */
template <int D>
int LongestSide(const FacetCorners<D>& face);

/** The length of a face's longest side. */
template <int D>
double LengthOfLongestSide(const FacetCorners<D>& face);

/** The halves of a face on both sides of the midpoint of its longest side. */
template <int D>
std::vector<FacetCorners<D>> Halve(const FacetCorners<D>& face);

/**
 * Some thousand queries tell the distance of a face. Only slivers in one plane with many facets
 * need more, up to billions. They are very close to the mesh then, so that their bound may be more
 * than 1 % too large.
 */
constexpr int MostDistanceQueries = 20000;

/** Bounds the largest distance of any point of a face from a mesh, by branch and bound. */
template <int D>
class FaceDistance
{
public:
  /** The mesh must have a facet and outlive this object. */
  explicit FaceDistance(const ResolvedInput<D>& mesh);

  const FacetTree<D>& GetTree() const
  {
    return this->Tree;
  }

  double OfPoint(const Point& p) const
  {
    return this->Tree.Find(p).Distance;
  }

  struct Bound
  {
    double Lower; ///< at most the distance of the farthest point
    double Upper;
    bool Final;             ///< whether `Upper` is at most 1 % too large, or negligible
    FacetCorners<D> Nearby; ///< a facet close to the center of the face
  };

  /**
   * Bounds, refined with at most this many queries for closest facets: the distance from
   * one facet is convex, so that its maximum over a piece of the face is at a corner. Stops early
   * below `enough`. The first search begins at the facet `nearby`, if there is one.
   */
  Bound Compute(const FacetCorners<D>& face, int queries, double enough = 0.0,
    const FacetCorners<D>* nearby = nullptr) const;

  /**
   * The distance of a point of the faces that is farther than a bound, or 0 if there is none. The
   * bound itself if no more than `queries` do not decide. Reduces this number by the queries made.
   * The first search begins at the facet `nearby`.
   */
  double FindFarther(const std::vector<FacetCorners<D>>& faces, double bound, long long& queries,
    const FacetCorners<D>& nearby) const;

private:
  struct Piece
  {
    FacetCorners<D> Corners;
    FacetCorners<D> Closest; ///< the facet closest to the center, or one that is close enough
    double Upper;            ///< the distance of the farthest corner from this facet

    bool operator<(const Piece& other) const
    {
      return this->Upper < other.Upper;
    }
  };

  Piece MakePiece(const FacetCorners<D>& corners, const FacetCorners<D>* nearby, double enough,
    double& lower) const;

  const FacetTree<D> Tree;
  const double Negligible; ///< distances up to this one need no accuracy
};

} // namespace carving

#endif
