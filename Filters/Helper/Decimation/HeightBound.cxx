// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/HeightBound.h"

#include "Core/Mesh/Vector.h"
#include "Helper/Resolve/FacetNeighbors.h"

#include <algorithm>
#include <cmath>

namespace carving::helper
{
namespace
{

/** A place relative to a face: inside each of the three sides if not negative, and the height. */
using Place = std::array<double, 4>;
constexpr int Height = 3;

/** The prism of all points below and above a face. */
class Prism
{
public:
  explicit Prism(const FacetCorners<3>& face)
    : Corners(face)
  {
    const Point normal = Cross(face[1] - face[0], face[2] - face[0]);
    this->Normal = normal / Length(normal);
    for (int i = 0; i < 3; ++i)
    {
      this->Inward[i] = Cross(this->Normal, face[(i + 1) % 3] - face[i]);
    }
  }

  /** Seen along the normal; not a number if the face has no area. */
  double AreaOf(const FacetCorners<3>& facet) const
  {
    return Dot(this->Normal, Cross(facet[1] - facet[0], facet[2] - facet[0]));
  }

  Place PlaceOf(const Point& p) const
  {
    return { Dot(this->Inward[0], p - this->Corners[0]), Dot(this->Inward[1], p - this->Corners[1]),
      Dot(this->Inward[2], p - this->Corners[2]), Dot(this->Normal, p - this->Corners[0]) };
  }

  /** Whether the segment from p, which is at `from`, to q, which is at `to`, meets the prism. */
  bool Meets(const Point& p, const Place& from, const Point& q, const Place& to) const
  {
    for (int i = 0; i < 3; ++i)
    {
      if (from[i] < 0.0 && to[i] < 0.0)
      {
        return false;
      }
    }
    const Point side = Cross(this->Normal, q - p);
    const auto isLeft = [&](const Point& corner) { return Dot(side, corner - p) > 0.0; };
    const auto isRight = [&](const Point& corner) { return Dot(side, corner - p) < 0.0; };
    return !std::all_of(this->Corners.begin(), this->Corners.end(), isLeft) &&
      !std::all_of(this->Corners.begin(), this->Corners.end(), isRight);
  }

private:
  FacetCorners<3> Corners;
  Point Normal;
  std::array<Point, 3> Inward;
};

/** The corners of the part of a facet that is inside all three sides. */
std::vector<Place> Clip(const std::array<Place, 3>& facet)
{
  std::vector<Place> polygon(facet.begin(), facet.end()), inside;
  for (int i = 0; i < 3; ++i)
  {
    inside.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
      const Place &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
      if (from[i] >= 0.0)
      {
        inside.push_back(from);
      }
      if ((from[i] < 0.0) != (to[i] < 0.0))
      {
        const double share = from[i] / (from[i] - to[i]);
        Place& crossing = inside.emplace_back();
        for (int j = 0; j < 4; ++j)
        {
          crossing[j] = from[j] + share * (to[j] - from[j]);
        }
        crossing[i] = 0.0;
      }
    }
    polygon.swap(inside);
  }
  return polygon;
}

} // namespace

HeightBound::HeightBound(const ResolvedMesh& mesh)
  : Mesh(mesh)
  , Neighbors(mesh.Facets.size())
  , IsFound(mesh.Facets.size(), 0)
{
  const std::vector<FacetNeighbors> all = FindFacetNeighbors(mesh);
  for (std::size_t f = 0; f < all.size(); ++f)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Neighbors[f][i] = all[f][i].Flipped ? -1 : all[f][i].Facet;
    }
  }
}

// From facet to facet, the sheet is followed across all edges below the face. Seen from the face,
// no two facets next to each other cover the same place, and no edge below the face is the border
// of the sheet. So the sheet covers all of the face if it covers any of it.

bool HeightBound::IsWithin(const FacetCorners<3>& face, double bound, int start)
{
  const Prism prism(face);
  const double sign =
    prism.AreaOf(carving::CornersOf<3>(this->Mesh.Points, this->Mesh.Facets[start])) < 0.0 ? -1.0
                                                                                           : 1.0;
  const auto isLow = [bound](const Place& place) { return std::abs(place[Height]) <= bound; };
  this->Found.assign(1, start);
  this->IsFound[start] = 1;
  bool isWithin = true;
  for (std::size_t next = 0; next < this->Found.size() && isWithin; ++next)
  {
    const int facet = this->Found[next];
    const FacetCorners<3> corners =
      carving::CornersOf<3>(this->Mesh.Points, this->Mesh.Facets[facet]);
    const std::array<Place, 3> places = { prism.PlaceOf(corners[0]), prism.PlaceOf(corners[1]),
      prism.PlaceOf(corners[2]) };
    isWithin = sign * prism.AreaOf(corners) > 0.0;
    if (isWithin && (next == 0 || !std::all_of(places.begin(), places.end(), isLow)))
    {
      const std::vector<Place> below = Clip(places);
      isWithin = (next > 0 || !below.empty()) && std::all_of(below.begin(), below.end(), isLow);
    }
    for (int i = 0; i < 3 && isWithin; ++i)
    {
      const int k = (i + 1) % 3;
      if (prism.Meets(corners[i], places[i], corners[k], places[k]))
      {
        const int neighbor = this->Neighbors[facet][i];
        isWithin = neighbor >= 0;
        if (isWithin && !this->IsFound[neighbor])
        {
          this->IsFound[neighbor] = 1;
          this->Found.push_back(neighbor);
        }
      }
    }
  }
  for (const int facet : this->Found)
  {
    this->IsFound[facet] = 0;
  }
  return isWithin;
}

} // namespace carving::helper
