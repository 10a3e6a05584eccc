// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/Placement.h"

#include "Core/Mesh/Box.h"
#include "Helper/Base/Kernels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace carving::helper
{
namespace
{

/**
 * The weight of the distance from the edge's midpoint, which decides where the quadric does not.
 */
constexpr double Pull = 1e-3;

/**
 * The distance between M and the polytope that bounds positions, as a fraction of M's diagonal. It
 * grows where no edge can collapse: few vertices around a round mesh are far from the mesh.
 */
constexpr double LeastSlack = 1e-3, GreatestSlack = 1.0, SlackRatio = 10.0;

/**
 * Slack grows only if its product with the number of vertices is at most this many of M's
 * diagonals. The distance between a sphere and n vertices around it is about 1 / n of its diameter.
 * Where n vertices are stuck in many times this slack, more of it only makes spikes.
 */
constexpr double MostSlackOfAll = 10.0;

/**
 * Rounded positions on the planes of faces are on the wrong side of some. Planes are therefore
 * shifted outward by these fractions of M's diagonal in turn, until the exact test succeeds.
 */
constexpr double Shifts[] = { 0.0, 1e-14, 1e-12, 1e-10, 1e-8 };

constexpr int MostContacts = 6;

/** The supporting half-spaces of points in 26 directions. */
std::vector<HalfSpace> BoundingPolytope(const std::vector<Point>& points, double slack)
{
  std::vector<HalfSpace> halfSpaces;
  for (int direction = 0; direction < 27; ++direction)
  {
    const double x = direction % 3 - 1, y = direction / 3 % 3 - 1, z = direction / 9 - 1;
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length > 0.0)
    {
      const Point normal = { x / length, y / length, z / length };
      double least = std::numeric_limits<double>::infinity();
      for (const Point& p : points)
      {
        least = std::min(least, Dot(normal, p));
      }
      halfSpaces.push_back({ normal, least - slack });
    }
  }
  return halfSpaces;
}

/** Makes a quadric definite. */
Quadric WithPull(Quadric quadric)
{
  quadric.AddPoint({}, Pull * quadric.Trace() + std::numeric_limits<double>::min());
  return quadric;
}

} // namespace

bool IsOutside(const Star& star, const Point& w)
{
  const auto p = ToInexact(w);
  return std::all_of(star.Corners.begin(), star.Corners.end(),
    [&](const std::array<Point, 3>& c)
    {
      const Corners3 corners = ToInexact(c);
      return std::find(c.begin(), c.end(), w) != c.end() ||
        CGAL::orientation(corners[0], corners[1], corners[2], p) != CGAL::NEGATIVE;
    });
}

Placement::Placement(const std::vector<Point>& points, Obstacle& obstacle)
  : M(obstacle)
  , Diagonal(carving::Diagonal(points))
  , Slack(LeastSlack * this->Diagonal)
  , Bounds(BoundingPolytope(points, this->Slack))
{
}

bool Placement::Widen(std::size_t vertices, double errorBound)
{
  const double wider = SlackRatio * this->Slack;
  if (wider > 1.01 * GreatestSlack * this->Diagonal || this->Slack > errorBound ||
    static_cast<double>(vertices) * this->Slack > MostSlackOfAll * this->Diagonal)
  {
    return false;
  }
  for (HalfSpace& bound : this->Bounds)
  {
    bound.Offset -= wider - this->Slack;
  }
  this->Slack = wider;
  return true;
}

std::optional<Point> Placement::FindOutward(const Star& star, const LocalError& error) const
{
  std::vector<HalfSpace> outside;
  for (const auto& [a, b, c] : star.Corners)
  {
    const Point normal = Cross(b - a, c - a);
    const double length = Length(normal);
    if (length > 0.0)
    {
      const Point n = normal / length;
      outside.push_back({ n, Dot(n, a - error.Origin) });
    }
  }
  const std::size_t count = outside.size();
  double shift = 0.0;
  for (const double next : Shifts)
  {
    for (HalfSpace& halfSpace : outside)
    {
      halfSpace.Offset += (next - shift) * this->Diagonal;
    }
    shift = next;
    const std::optional<Point> w = this->Minimize(error, outside);
    if (!w || IsOutside(star, *w))
    {
      return w;
    }
    outside.resize(count);
  }
  return std::nullopt;
}

double Placement::FindLeastError(const LocalError& error)
{
  Point x;
  return helper::Minimize(WithPull(error.Error), {}, x) ? error.Error.At(x) : 0.0;
}

/** The least error in half-spaces. Adds those of the bounds that the result would leave. */
std::optional<Point> Placement::Minimize(
  const LocalError& error, std::vector<HalfSpace>& limits) const
{
  const Quadric pulled = WithPull(error.Error);
  constexpr int mostRounds = 4; // rounding can keep a position outside
  for (int round = 0; round < mostRounds; ++round)
  {
    Point x;
    if (!helper::Minimize(pulled, limits, x))
    {
      return std::nullopt;
    }
    const Point w = error.Origin + x;
    bool within = true;
    for (const HalfSpace& bound : this->Bounds)
    {
      if (Dot(bound.Normal, w) < bound.Offset - this->Slack / 2.0)
      {
        limits.push_back({ bound.Normal, bound.Offset - Dot(bound.Normal, error.Origin) });
        within = false;
      }
    }
    if (within)
    {
      return w;
    }
  }
  return std::nullopt;
}

Point Placement::SlideInward(const Star& star, const LocalError& error, Slide& slide, double limit)
{
  constexpr double almost = 0.999; // of the way to a contact
  while (!slide.IsAtEnd && slide.Contacts < MostContacts)
  {
    const std::optional<Point> least = this->Minimize(error, slide.Limits);
    if (!least)
    {
      break;
    }
    if (error.At(*least) > limit)
    {
      return *least; // contacts only add constraints
    }
    const std::optional<FirstContact> contact = this->M.FindContact(star, slide.Position, *least);
    if (!contact)
    {
      slide.Position = *least;
      slide.IsAtEnd = true;
      break;
    }
    slide.Position = Between(slide.Position, *least, almost * contact->Time);
    slide.Limits.push_back({ contact->Allowed.Normal,
      contact->Allowed.Offset - Dot(contact->Allowed.Normal, error.Origin) });
    ++slide.Contacts;
  }
  return slide.Position;
}

Point Placement::SlideInward(const Star& star, const LocalError& error, const Point& start)
{
  Slide slide(start);
  return this->SlideInward(star, error, slide, std::numeric_limits<double>::infinity());
}

} // namespace carving::helper
