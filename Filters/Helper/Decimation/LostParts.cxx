// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/LostParts.h"

#include <algorithm>
#include <iterator>

namespace carving::helper
{
namespace
{

/** The side of a triangle's edge from corner k on: positive where the triangle is. */
CGAL::Orientation SideOfEdge(const std::array<Point, 3>& triangle, int k, const Point& p)
{
  return CGAL::coplanar_orientation(ToInexact(triangle[k]), ToInexact(triangle[(k + 1) % 3]),
    ToInexact(triangle[(k + 2) % 3]), ToInexact(p));
}

/**
 * Whether a sheet ends at the edge of a face from corner k on: another face in its plane has the
 * same edge and lies on the same side of it, but none continues on the other side.
 */
bool EndsSheet(
  const std::vector<std::array<Point, 3>>& inPlane, const std::array<Point, 3>& face, int k)
{
  bool ends = false;
  for (const auto& other : inPlane)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (other[i] == face[(k + 1) % 3] && other[(i + 1) % 3] == face[k])
      {
        if (SideOfEdge(face, k, other[(i + 2) % 3]) != CGAL::POSITIVE)
        {
          return false;
        }
        ends = true;
      }
    }
  }
  return ends;
}

/**
 * The plane of a face of a tetrahedron. Whatever is in front of the face is on its positive side.
 */
SpannedPlane PlaneOf(const Corners4& corners, int face)
{
  const auto& [a, b, c] = FaceCorners[face];
  return { { corners[a], corners[b] }, { corners[a], corners[c] } };
}

} // namespace

LostParts::Tetrahedron::Tetrahedron(const std::array<Point, 4>& corners)
  : Bounds(BoxAround(corners))
  , Corners{ ToInexact(corners[0]), ToInexact(corners[1]), ToInexact(corners[2]),
    ToInexact(corners[3]) }
  , Planes{ PlaneOf(this->Corners, 0), PlaneOf(this->Corners, 1), PlaneOf(this->Corners, 2),
    PlaneOf(this->Corners, 3) }
{
}

/** Whether neither the bounding box nor the plane of any face keeps a box apart. */
bool LostParts::Tetrahedron::MayMeet(const Box& box) const
{
  if (!this->Bounds.Overlaps(box))
  {
    return false;
  }
  for (int f = 0; f < 4; ++f)
  {
    const auto& origin = this->Corners[FaceCorners[f][0]];
    const Point a = { origin.x(), origin.y(), origin.z() };
    if (this->Planes[f].IsPositiveIn({ box.Lower - a, box.Upper - a }))
    {
      return false;
    }
  }
  return true;
}

LostParts::LostParts(const Star& star, const Point& w)
{
  this->Tetrahedra.reserve(star.Corners.size());
  std::vector<std::size_t> flat;
  for (std::size_t i = 0; i < star.Corners.size(); ++i)
  {
    const std::array<Point, 3>& face = star.Corners[i];
    const auto [a, b, c] = ToInexact(face);
    const CGAL::Orientation side = CGAL::orientation(a, b, c, ToInexact(w));
    if (side == CGAL::NEGATIVE)
    {
      this->Tetrahedra.emplace_back(std::array{ face[0], face[2], face[1], w });
    }
    else if (side == CGAL::COPLANAR)
    {
      flat.push_back(i);
    }
  }
  this->AddFromSheets(star, flat, w);
}

/** Adds triangles. `flat` are the indices of those faces of the star that are in a plane with w. */
void LostParts::AddFromSheets(
  const Star& star, const std::vector<std::size_t>& flat, const Point& w)
{
  std::vector<std::array<Point, 3>> faces;
  std::transform(flat.begin(), flat.end(), std::back_inserter(faces),
    [&star](std::size_t i) { return star.Corners[i]; });
  for (const std::size_t i : flat)
  {
    const std::array<Point, 3>& face = star.Corners[i];
    for (int k = 0; k < 3; ++k)
    {
      const std::array<Point, 2> edge = { face[k], face[(k + 1) % 3] };
      const bool remains = i < star.Link.size() && star.Link[i] == edge;
      if (!remains && SideOfEdge(face, k, w) == CGAL::POSITIVE && EndsSheet(faces, face, k))
      {
        const std::array lost = { edge[0], edge[1], w };
        this->Triangles.push_back({ BoxAround(lost), ToInexact(lost) });
      }
    }
  }
}

bool LostParts::MayMeet(const Box& box) const
{
  return std::any_of(this->Tetrahedra.begin(), this->Tetrahedra.end(),
           [&box](const Tetrahedron& lost) { return lost.MayMeet(box); }) ||
    std::any_of(this->Triangles.begin(), this->Triangles.end(),
      [&box](const Triangle& lost) { return lost.Bounds.Overlaps(box); });
}

bool LostParts::Meet(const std::array<Point, 3>& triangle, const Box& bounds) const
{
  const Piercer piercer(ToInexact(triangle));
  const auto isInPlane = [&piercer](const auto& corner)
  { return piercer.SideOf(corner) == CGAL::COPLANAR; };
  return std::any_of(this->Tetrahedra.begin(), this->Tetrahedra.end(),
           [&](const Tetrahedron& lost)
           { return lost.MayMeet(bounds) && piercer.FindContact(lost.Corners).Exists(); }) ||
    std::any_of(this->Triangles.begin(), this->Triangles.end(),
      [&](const Triangle& lost)
      {
        return lost.Bounds.Overlaps(bounds) &&
          std::all_of(lost.Corners.begin(), lost.Corners.end(), isInPlane) &&
          Overlap(piercer.GetCorners(), lost.Corners);
      });
}

} // namespace carving::helper
