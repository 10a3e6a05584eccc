// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/FirstContact.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

constexpr double Never = 2.0;

Point Negated(const Point& p)
{
  return { -p[0], -p[1], -p[2] };
}

/** Whether the projection of p along the normal of triangle (a, b, c) lies in the triangle. */
bool ProjectsInto(
  const Point& a, const Point& b, const Point& c, const Point& normal, const Point& p)
{
  return Dot(Cross(b - a, p - a), normal) >= 0.0 && Dot(Cross(c - b, p - b), normal) >= 0.0 &&
    Dot(Cross(a - c, p - c), normal) >= 0.0;
}

} // namespace

SweptFace::SweptFace(
  const Point& a, const Point& b, const Point& from, const Point& to, double margin)
  : Bounds(BoxAround({ a, b, from, to }))
{
  const auto makeSlab = [&](const Point& w, const Point& other)
  {
    const Point normal = Cross(b - a, w - a);
    const double tolerance = 2.0 * margin * Length(normal);
    const auto [lower, upper] = std::minmax({ Dot(normal, a), Dot(normal, other) });
    return Slab{ normal, lower - tolerance, upper + tolerance };
  };
  this->Slabs = { makeSlab(from, to), makeSlab(to, from) };
}

bool SweptFace::MayMeet(const std::array<Point, 3>& triangle) const
{
  return this->Slabs[0].Overlaps(triangle) && this->Slabs[1].Overlaps(triangle);
}

bool SweptFace::MayMeet(const Box& box) const
{
  return this->Bounds.Overlaps(box) && this->Slabs[0].Overlaps(box) && this->Slabs[1].Overlaps(box);
}

ContactSearch::ContactSearch(const Fan& fan, const Point& from, const Point& to, double margin)
  : From(from)
  , Along(to - from)
  , Margin(margin)
  , Time(Never)
{
  this->Faces.reserve(fan.size());
  Point before = Cross(fan.back()[1] - fan.back()[0], from - fan.back()[0]);
  for (const auto& [a, b] : fan)
  {
    const Point normal = Cross(b - a, from - a);
    this->Faces.push_back({ a, b, normal + before });
    before = normal;
  }
}

SweptFace ContactSearch::Sweep(std::size_t face) const
{
  const Point to = this->PositionAt(std::min(this->Time, 1.0));
  return { this->Faces[face].A, this->Faces[face].B, this->From, to, this->Margin };
}

/** w runs into a triangle. */
void ContactSearch::AddTriangle(const Point& p, const Point& q, const Point& r)
{
  const Point normal = Cross(q - p, r - p);
  const double time = this->FindTime(normal, p);
  if (time < this->Time && ProjectsInto(p, q, r, normal, this->PositionAt(time)))
  {
    this->Set(time, normal, p);
  }
}

/** A face of the fan runs into a vertex. */
void ContactSearch::AddVertex(std::size_t face, const Point& m)
{
  const auto& [a, b, outward] = this->Faces[face];
  if (m == a || m == b)
  {
    return;
  }
  const Point normal = Cross(b - a, m - a);
  const double time = this->FindTime(normal, a);
  if (time < this->Time)
  {
    const Point w = this->PositionAt(time);
    if (ProjectsInto(a, b, w, Cross(b - a, w - a), m))
    {
      this->Set(time, normal, a);
    }
  }
}

/** The edge of the fan from A to w runs into an edge. */
void ContactSearch::AddEdge(std::size_t face, const Point& p, const Point& q)
{
  const auto& [a, b, outward] = this->Faces[face];
  if (a == p || a == q)
  {
    return;
  }
  Point normal = Cross(p - a, q - a);
  if (Dot(normal, outward) < 0.0)
  {
    normal = Negated(normal);
  }
  const double time = this->FindTime(normal, a);
  if (time >= this->Time)
  {
    return;
  }
  // In their common plane, each edge separates the ends of the other one.
  const Point w = this->PositionAt(time);
  const auto side = [&normal](const Point& from, const Point& to, const Point& x)
  { return Dot(Cross(to - from, x - from), normal); };
  if (side(a, w, p) * side(a, w, q) <= 0.0 && side(p, q, a) * side(p, q, w) <= 0.0)
  {
    this->Set(time, normal, a);
  }
}

std::optional<FirstContact> ContactSearch::Get() const
{
  return this->Time <= 1.0 ? std::optional<FirstContact>({ this->Time, this->Allowed })
                           : std::nullopt;
}

/** The time at which w crosses the plane through p from the front, or Never. */
double ContactSearch::FindTime(const Point& normal, const Point& p) const
{
  const double height = Dot(normal, this->From - p), speed = Dot(normal, this->Along);
  if (speed >= 0.0 || height + speed > 0.0)
  {
    return Never;
  }
  if (height < 0.0 && height < -this->Margin * Length(normal))
  {
    return Never; // w is behind the plane from the start
  }
  return std::max(0.0, -height / speed);
}

void ContactSearch::Set(double time, const Point& normal, const Point& p)
{
  const double length = Length(normal);
  if (length > 0.0)
  {
    const Point n = normal / length;
    this->Time = time;
    this->Allowed = { n, Dot(n, p) + this->Margin };
  }
}

Point ContactSearch::PositionAt(double time) const
{
  return this->From + time * this->Along;
}

} // namespace carving::helper
