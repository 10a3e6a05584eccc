// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/CollisionSearch.h"

#include "Helper/Base/TriangleCrossing.h"
#include "Helper/Decimation/FittedBounds.h"
#include "Helper/Decimation/Sheets.h"
#include "Helper/Enclosing/Pierce.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

/** A face that is compared with many others. */
struct NewFace
{
  Corners3 Corners;
  FittedBounds<3> Bounds;
  Piercer Prepared;

  explicit NewFace(const std::array<Point, 3>& corners)
    : Corners(ToInexact(corners))
    , Bounds(corners)
    , Prepared(this->Corners)
  {
  }

  /** Triangles cover each other if they have the same corners, in any order. */
  bool CrossesOrCovers(const Corners3& other) const
  {
    return !this->Prepared.IsBeside(other) &&
      (TrianglesCross(this->Corners, other) ||
        std::is_permutation(this->Corners.begin(), this->Corners.end(), other.begin()));
  }
};

} // namespace

CollisionSearch::CollisionSearch(const SurfaceMesh& surface)
  : Surface(surface)
  , Tree(FaceItems(surface))
  , FacesAtBuild(surface.number_of_faces())
  , CanSweepOver(!IsConnectedWithoutCopies(surface))
  , IsSheet(CanSweepOver ? FindSheets(surface) : std::vector<char>())
{
}

bool CollisionSearch::IsFree(const Star& star, const Point& w) const
{
  // Most positions that are not free sweep over something, which takes less time to find.
  return !(this->CanSweepOver && this->SweepsOver(star, w)) && !this->Crosses(star, w);
}

/**
 * Whether `predicate` holds for the corners of any face that is not in a star and whose box `meets`
 * accepts.
 */
template <class BoxPredicate, class Predicate>
bool CollisionSearch::AnyOutside(
  const Star& star, BoxPredicate&& meets, Predicate&& predicate) const
{
  return this->Tree.Any(meets,
    [&](int index)
    {
      const Face face(index);
      return std::find(star.Faces.begin(), star.Faces.end(), face) == star.Faces.end() &&
        predicate(CornersOf(this->Surface, face));
    });
}

/** Whether the new faces have no area, or cross or cover each other or the remaining faces. */
bool CollisionSearch::Crosses(const Star& star, const Point& w) const
{
  std::vector<NewFace> fan;
  fan.reserve(star.Link.size());
  Box region;
  for (const auto& [a, b] : star.Link)
  {
    const NewFace face({ a, b, w });
    if (CGAL::collinear(face.Corners[0], face.Corners[1], face.Corners[2]) ||
      std::any_of(fan.begin(), fan.end(),
        [&face](const NewFace& other) { return face.CrossesOrCovers(other.Corners); }))
    {
      return true;
    }
    fan.push_back(face);
    region.Add(face.Bounds.GetBox());
  }
  const auto meetsFan = [&](const Box& box)
  {
    return region.Overlaps(box) &&
      std::any_of(
        fan.begin(), fan.end(), [&box](const NewFace& face) { return face.Bounds.Overlaps(box); });
  };
  return this->AnyOutside(star, meetsFan,
    [&fan](const std::array<Point, 3>& corners)
    {
      const Box bounds = BoxAround(corners);
      return std::any_of(fan.begin(), fan.end(),
        [&](const NewFace& face)
        { return face.Bounds.Overlaps(bounds) && face.CrossesOrCovers(ToInexact(corners)); });
    });
}

bool CollisionSearch::SweepsOver(const Star& star, const Point& w) const
{
  for (std::size_t i = 0; i < star.Corners.size(); ++i)
  {
    const std::array<Point, 3>& corners = star.Corners[i];
    const auto [a, b, c] = ToInexact(corners);
    Corners4 swept = { a, b, c, ToInexact(w) };
    const auto side = CGAL::orientation(swept[0], swept[1], swept[2], swept[3]);
    if (side == CGAL::COPLANAR)
    {
      continue;
    }
    if (side == CGAL::NEGATIVE)
    {
      std::swap(swept[0], swept[1]);
    }
    const FittedBounds<4> bounds({ corners[0], corners[1], corners[2], w });
    // A side of a sheet may move away from the other, which is the only face with the same corners.
    const bool leavesOther = side == CGAL::POSITIVE && this->IsSheet[star.Faces[i]];
    const bool meets = this->AnyOutside(
      star, [&bounds](const Box& box) { return bounds.Overlaps(box); },
      [&](const std::array<Point, 3>& face)
      {
        return !(leavesOther &&
                 std::is_permutation(face.begin(), face.end(), corners.begin(), corners.end())) &&
          Piercer(ToInexact(face)).FindContact(swept).Exists();
      });
    if (meets)
    {
      return true;
    }
  }
  return false;
}

bool CollisionSearch::MayCoverSheet(const Star& star) const
{
  return this->CanSweepOver &&
    std::any_of(
      star.Faces.begin(), star.Faces.end(), [this](Face face) { return this->IsSheet[face]; });
}

void CollisionSearch::Update(const Star& star)
{
  for (const Face face : star.Faces)
  {
    this->Tree.Update(static_cast<int>(face));
  }
  if (2 * this->Surface.number_of_faces() < this->FacesAtBuild)
  {
    this->Tree.Rebuild();
    this->FacesAtBuild = this->Surface.number_of_faces();
  }
}

} // namespace carving::helper
