// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Base/ExactWinding.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/Kernels.h"
#include "Helper/Base/Slab.h"

#include <algorithm>
#include <array>
#include <random>

namespace carving::helper
{
namespace
{

/** A line through two points, in the direction of the second one. */
class DirectedLine
{
public:
  DirectedLine(const Point& from, const Point& to)
    : From(ToInexact(from))
    , To(ToInexact(to))
    , ExactFrom(ToExact(from))
    , ExactTo(ToExact(to))
  {
    constexpr double rounding = 1e-12;
    const Point along = to - from;
    const double slack = rounding * Length(along) * (Length(from) + Length(to));
    for (int k = 0; k < 3; ++k)
    {
      Point axis = {};
      axis[k] = 1.0;
      const Point normal = Cross(along, axis);
      const double product = Dot(normal, from);
      this->Slabs[k] = { normal, product - slack, product + slack };
    }
  }

  /** Whether the line may meet a box. */
  bool MayMeet(const Box& box) const
  {
    return std::all_of(this->Slabs.begin(), this->Slabs.end(),
      [&box](const Slab& slab) { return slab.Overlaps(box); });
  }

  /**
   * 1 if the line enters the front of a triangle through its interior, -1 if it leaves through
   * the front, 0 if it passes the triangle. None if it meets an edge.
   */
  std::optional<int> Enter(const Corners3& corners) const
  {
    bool left = false, right = false, meets = false;
    for (int k = 0; k < 3; ++k)
    {
      const auto side = CGAL::orientation(this->From, this->To, corners[k], corners[(k + 1) % 3]);
      left = left || side == CGAL::POSITIVE;
      right = right || side == CGAL::NEGATIVE;
      meets = meets || side == CGAL::COPLANAR;
    }
    if (left && right)
    {
      return 0;
    }
    const auto start = CGAL::orientation(corners[0], corners[1], corners[2], this->From);
    return meets || start == CGAL::COPLANAR ? std::nullopt : std::make_optional<int>(start);
  }

  /** Where the line crosses the plane of a triangle: 0 at the first point, 1 at the second. */
  Exact::FT Locate(const std::array<Point, 3>& corners) const
  {
    const auto a = ToExact(corners[0]), b = ToExact(corners[1]), c = ToExact(corners[2]);
    const Exact::FT start = CGAL::volume(a, b, c, this->ExactFrom);
    return start / (start - CGAL::volume(a, b, c, this->ExactTo));
  }

private:
  Inexact::Point_3 From, To;
  Exact::Point_3 ExactFrom, ExactTo;
  std::array<Slab, 3> Slabs; ///< that contain the line
};

} // namespace

ExactWinding::ExactWinding(const ResolvedMesh& mesh)
  : Tree(mesh)
  , Diagonal(carving::Diagonal(mesh.Points))
{
}

std::optional<int> ExactWinding::InFrontOf(int facet) const
{
  constexpr int mostLines = 16;
  const auto corners = this->Tree.GetItems().CornersOf(facet);
  const Point normal = Cross(corners[1] - corners[0], corners[2] - corners[0]);
  std::minstd_rand random; // of regular meshes, lines through centers meet edges
  std::uniform_real_distribution<double> share(0.2, 0.4), tilt(-0.2, 0.2);
  std::optional<int> winding;
  for (int i = 0; i < mostLines && !winding; ++i)
  {
    const double first = share(random), second = share(random);
    const Point target =
      first * corners[0] + second * corners[1] + (1.0 - first - second) * corners[2];
    const Point direction =
      normal / Length(normal) + Point{ tilt(random), tilt(random), tilt(random) };
    const Point beyond = 2.0 * this->Diagonal * direction; // outside of the mesh
    winding = this->CountAlongLine(facet, target + beyond, target - beyond);
  }
  return winding;
}

/** None if the line does not cross the facet from its front, or meets the edge of another one. */
std::optional<int> ExactWinding::CountAlongLine(int facet, const Point& from, const Point& to) const
{
  const DirectedLine line(from, to);
  const auto& items = this->Tree.GetItems();
  const auto own = items.CornersOf(facet);
  if (line.Enter(ToInexact(own)) != 1)
  {
    return std::nullopt;
  }
  const Exact::FT end = line.Locate(own);
  int winding = 0;
  const bool meetsEdge = this->Tree.Any([&line](const Box& box) { return line.MayMeet(box); },
    [&](int other)
    {
      const auto corners = items.CornersOf(other);
      const std::optional<int> direction = line.Enter(ToInexact(corners));
      if (direction.value_or(0) != 0 && other != facet && line.Locate(corners) < end)
      {
        winding += *direction * items.GetMesh().SignedMultiplicities[other];
      }
      return !direction;
    });
  return meetsEdge ? std::nullopt : std::make_optional(winding);
}

} // namespace carving::helper
