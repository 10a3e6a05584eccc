// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/CollisionSearch.h"

#include "Helper/Base/TriangleCrossing.h"
#include "Helper/Enclosing/Pierce.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

/** Triangles cover each other if they have the same corners, in any order. */
bool CrossOrCover(const Corners3& a, const Corners3& b)
{
  return TrianglesCross(a, b) || std::is_permutation(a.begin(), a.end(), b.begin());
}

} // namespace

CollisionSearch::CollisionSearch(const SurfaceMesh& surface)
  : Surface(surface)
  , Tree(FaceItems(surface))
  , FacesAtBuild(surface.number_of_faces())
  , CanSweepOver(!IsConnectedWithoutCopies(surface))
{
}

bool CollisionSearch::IsFree(const Star& star, const Point& w) const
{
  return !this->Crosses(star, w) && !(this->CanSweepOver && this->SweepsOver(star, w));
}

/** Whether `predicate` holds for the corners of any face that meets a box, but is not in a star. */
template <class Predicate>
bool CollisionSearch::AnyOutside(const Star& star, const Box& box, Predicate&& predicate) const
{
  bool found = false;
  this->Tree.ForEachOverlap(box,
    [&](int index)
    {
      const Face face(index);
      found = found ||
        (std::find(star.Faces.begin(), star.Faces.end(), face) == star.Faces.end() &&
          predicate(ToInexact(CornersOf(this->Surface, face))));
    });
  return found;
}

/** Whether the new faces have no area, or cross or cover each other or the remaining faces. */
bool CollisionSearch::Crosses(const Star& star, const Point& w) const
{
  std::vector<Corners3> fan;
  for (const auto& [a, b] : star.Link)
  {
    const Corners3 face = ToInexact({ a, b, w });
    if (CGAL::collinear(face[0], face[1], face[2]) ||
      std::any_of(fan.begin(), fan.end(),
        [&face](const Corners3& other) { return CrossOrCover(face, other); }))
    {
      return true;
    }
    fan.push_back(face);
  }
  for (std::size_t i = 0; i < fan.size(); ++i)
  {
    const Box box = BoxAround({ star.Link[i][0], star.Link[i][1], w });
    if (this->AnyOutside(
          star, box, [&face = fan[i]](const Corners3& other) { return CrossOrCover(face, other); }))
    {
      return true;
    }
  }
  return false;
}

bool CollisionSearch::SweepsOver(const Star& star, const Point& w) const
{
  return std::any_of(star.Corners.begin(), star.Corners.end(),
    [&](const std::array<Point, 3>& corners)
    {
      const auto [a, b, c] = ToInexact(corners);
      Corners4 swept = { a, b, c, ToInexact(w) };
      const auto side = CGAL::orientation(swept[0], swept[1], swept[2], swept[3]);
      if (side == CGAL::NEGATIVE)
      {
        std::swap(swept[0], swept[1]);
      }
      return side != CGAL::COPLANAR &&
        this->AnyOutside(star, BoxAround({ corners[0], corners[1], corners[2], w }),
          [&swept](const Corners3& face) { return Piercer(face).FindContact(swept).Exists(); });
    });
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
