// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/Pierce.h"

#include <CGAL/Filtered_predicate.h>

#include <tuple>

namespace carving::helper
{
namespace
{

/** The side of the plane through p and q, parallel to ab, on which x lies. */
template <class Kernel>
struct SideAlongEdges
{
  using result_type = CGAL::Orientation;
  using Point = typename Kernel::Point_3;

  result_type operator()(
    const Point& p, const Point& q, const Point& a, const Point& b, const Point& x) const
  {
    return CGAL::orientation(q - p, b - a, x - p);
  }
};
// The side takes no division, so that a ring is enough: faster than CGAL's rational numbers.
using FilteredSideAlongEdges = CGAL::Filtered_predicate<SideAlongEdges<Inexact::Exact_kernel_rt>,
  SideAlongEdges<Inexact::Approximate_kernel>, Inexact::C2E_rt, Inexact::C2F>;

/**
 * The side of a plane through three points. Equal points are frequent and need no exact arithmetic.
 */
CGAL::Orientation SideOfPlane(const Inexact::Point_3& a, const Inexact::Point_3& b,
  const Inexact::Point_3& c, const Inexact::Point_3& x)
{
  return x == a || x == b || x == c ? CGAL::COPLANAR : CGAL::orientation(a, b, c, x);
}

/** Whether the plane of a face of the tetrahedron separates the triangle from it. */
bool FaceSeparates(const Corners3& t, const Corners4& k)
{
  for (const auto& f : FaceCorners)
  {
    const SpannedPlane plane({ k[f[0]], k[f[1]] }, { k[f[0]], k[f[2]] });
    bool outside = true;
    for (int i = 0; i < 3 && outside; ++i)
    {
      CGAL::Orientation side;
      if (!plane.FindSide({ k[f[0]], t[i] }, side))
      {
        side = SideOfPlane(k[f[0]], k[f[1]], k[f[2]], t[i]);
      }
      // A point in front of a face sees it counter-clockwise.
      outside = side != CGAL::NEGATIVE;
    }
    if (outside)
    {
      return true;
    }
  }
  return false;
}

/** For each corner of a triangle, the equal corner of a tetrahedron; -1: none. */
std::array<int, 3> FindCommonCorners(const Corners3& t, const Corners4& k)
{
  std::array<int, 3> common;
  for (int i = 0; i < 3; ++i)
  {
    const auto found = std::find(k.begin(), k.end(), t[i]);
    common[i] = found == k.end() ? -1 : static_cast<int>(found - k.begin());
  }
  return common;
}

/** A triangle and a tetrahedron, seen from one edge of the tetrahedron. */
struct EdgeView
{
  const Corners3& T;
  const Corners4& K;
  std::array<int, 3> Common; ///< corners of both
  int P, Q;                  ///< the ends of the edge
  std::array<int, 2> Others; ///< the other corners of the tetrahedron
  Difference Along;          ///< from P to Q
  std::array<Difference, 2> ToOthers;

  EdgeView(const Corners3& t, const Corners4& k, const std::array<int, 3>& common, int p, int q)
    : T(t)
    , K(k)
    , Common(common)
    , P(p)
    , Q(q)
    , Others(OtherCorners(p, q))
    , Along(k[p], k[q])
    , ToOthers{ Difference(k[p], k[this->Others[0]]), Difference(k[p], k[this->Others[1]]) }
  {
  }

  /** Whether a corner of the triangle is an end of the edge. */
  bool IsEnd(int corner) const
  {
    return this->Common[corner] == this->P || this->Common[corner] == this->Q;
  }
};

/** The plane through an edge of a tetrahedron that is parallel to an edge of a triangle. */
class EdgePlane
{
public:
  /** The triangle's edge is from corner `a` to the next corner. */
  EdgePlane(const EdgeView& view, int a, const Difference& ab)
    : View(view)
    , A(a)
    , B((a + 1) % 3)
    , Filter(view.Along, ab)
  {
  }

  /**
   * Whether the tetrahedron is on one side and the triangle on the other; both may touch the plane.
   */
  bool Separates() const
  {
    const int side = this->SideOfTetrahedron();
    // Corners A and B are on the same side, as their edge is parallel to the plane.
    return side != 0 && (this->View.IsEnd(this->B) || this->IsBeyond(this->A, side)) &&
      this->IsBeyond((this->A + 2) % 3, side);
  }

private:
  CGAL::Orientation SideOf(const Inexact::Point_3& x, const Difference& toX) const
  {
    const auto& [t, k] = std::tie(this->View.T, this->View.K);
    CGAL::Orientation side;
    return this->Filter.FindSide(toX, side)
      ? side
      : FilteredSideAlongEdges()(k[this->View.P], k[this->View.Q], t[this->A], t[this->B], x);
  }

  /** The side of one of the other two corners of the tetrahedron. */
  int SideOfOther(int n) const
  {
    // If A and B are corners of the face of the edge and this corner, that face lies in the plane.
    const auto isOnFace = [&](int corner) {
      return this->View.Common[corner] >= 0 &&
        this->View.Common[corner] != this->View.Others[1 - n];
    };
    return isOnFace(this->A) && isOnFace(this->B)
      ? CGAL::ZERO
      : this->SideOf(this->View.K[this->View.Others[n]], this->View.ToOthers[n]);
  }

  /** 0 if the plane cuts the tetrahedron, or if the edges are parallel. */
  int SideOfTetrahedron() const
  {
    const int first = this->SideOfOther(0), second = this->SideOfOther(1);
    return first * second < 0 ? 0 : first != 0 ? first : second;
  }

  /**
   * Whether a corner of the triangle is in the plane or on the side opposite to the tetrahedron.
   */
  bool IsBeyond(int corner, int side) const
  {
    const Inexact::Point_3& x = this->View.T[corner];
    return this->View.IsEnd(corner) ||
      side * this->SideOf(x, { this->View.K[this->View.P], x }) <= 0;
  }

  const EdgeView& View;
  int A, B;
  SpannedPlane Filter;
};

/**
 * Whether a plane through an edge of the tetrahedron, parallel to an edge of the triangle,
 * separates them.
 */
bool EdgesSeparate(const Corners3& t, const Corners4& k)
{
  const std::array<int, 3> common = FindCommonCorners(t, k);
  const std::array<Difference, 3> sides = { Difference(t[0], t[1]), Difference(t[1], t[2]),
    Difference(t[2], t[0]) };
  for (int p = 0; p < 3; ++p)
  {
    for (int q = p + 1; q < 4; ++q)
    {
      const EdgeView view(t, k, common, p, q);
      for (int a = 0; a < 3; ++a)
      {
        if (EdgePlane(view, a, sides[a]).Separates())
        {
          return true;
        }
      }
    }
  }
  return false;
}

} // namespace

bool CrossesInside(const Inexact::Point_3& p, const Inexact::Point_3& q, const Corners3& t)
{
  const CGAL::Orientation turn = CGAL::orientation(p, q, t[0], t[1]);
  return turn != CGAL::COPLANAR && CGAL::orientation(p, q, t[1], t[2]) == turn &&
    CGAL::orientation(p, q, t[2], t[0]) == turn;
}

Piercer::Piercer(const Corners3& corners)
  : Corners(corners)
  , Plane({ corners[0], corners[1] }, { corners[0], corners[2] })
{
  for (int i = 0; i < 3; ++i)
  {
    std::tie(this->Least[i], this->Most[i]) =
      std::minmax({ corners[0][i], corners[1][i], corners[2][i] });
  }
}

CGAL::Orientation Piercer::SideOf(const Inexact::Point_3& x) const
{
  CGAL::Orientation side;
  return this->Plane.FindSide({ this->Corners[0], x }, side)
    ? side
    : SideOfPlane(this->Corners[0], this->Corners[1], this->Corners[2], x);
}

/**
 * Whether the triangle's bounding box meets that of the tetrahedron in more than their boundaries.
 */
bool Piercer::MeetsBox(const Corners4& k) const
{
  for (int i = 0; i < 3; ++i)
  {
    const auto [lower, upper] = std::minmax({ k[0][i], k[1][i], k[2][i], k[3][i] });
    const bool apart = this->Least[i] == this->Most[i]
      ? this->Least[i] > upper || this->Most[i] < lower
      : this->Least[i] >= upper || this->Most[i] <= lower;
    if (apart)
    {
      return false;
    }
  }
  return true;
}

/**
 * Whether an edge of the tetrahedron crosses the inside of the triangle: most tetrahedra that a
 * large triangle pierces have such an edge, which tells faster than all planes that may separate.
 */
bool Piercer::HasCrossingEdge(
  const Corners4& k, const std::array<CGAL::Orientation, 4>& sides) const
{
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      if (sides[i] * sides[j] < 0 && CrossesInside(k[i], k[j], this->Corners))
      {
        return true;
      }
    }
  }
  return false;
}

Contact Piercer::FindContact(const Corners4& k) const
{
  Contact contact;
  if (!this->MeetsBox(k))
  {
    return contact;
  }
  int above = 0, below = 0;
  int last = 0; // the last corner off the plane: the face opposite to it may be in the plane
  std::array<CGAL::Orientation, 4> sides;
  for (int i = 0; i < 4; ++i)
  {
    sides[i] = this->SideOf(k[i]);
    above += sides[i] == CGAL::POSITIVE;
    below += sides[i] == CGAL::NEGATIVE;
    last = sides[i] == CGAL::COPLANAR ? last : i;
  }
  if (above > 0 && below > 0)
  {
    contact.Pierces = this->HasCrossingEdge(k, sides) ||
      (!FaceSeparates(this->Corners, k) && !EdgesSeparate(this->Corners, k));
  }
  else if (above + below == 1)
  {
    const auto& [a, b, c] = FaceCorners[last];
    contact.Face = Overlap(this->Corners, { k[a], k[b], k[c] }) ? last : -1;
  }
  return contact;
}

} // namespace carving::helper
