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

ContactSearch::ContactSearch(const Fan& fan, const Point& from, const Point& to, double margin)
  : From(from)
  , Along(to - from)
  , Margin(margin)
  , Time(Never)
{
  std::vector<Point> normals;
  for (const auto& [a, b] : fan)
  {
    normals.push_back(Cross(b - a, from - a));
  }
  for (std::size_t i = 0; i < fan.size(); ++i)
  {
    const auto& [a, b] = fan[i];
    const Point& before = normals[(i + fan.size() - 1) % fan.size()];
    this->Faces.push_back({ a, b, {}, {}, normals[i] + before });
  }
  this->SetEnd(to);
}

/** Lets the motion end at a position. */
void ContactSearch::SetEnd(const Point& to)
{
  this->Bounds = Box();
  for (FanFace& face : this->Faces)
  {
    face.Bounds = Box({ face.A, face.B, this->From, to });
    this->Bounds.Add(face.Bounds);
    face.Slabs = { this->MakeSlab(face.A, face.B, this->From, to),
      this->MakeSlab(face.A, face.B, to, this->From) };
  }
}

/** Along the plane through a, b and w, and up to another point. */
ContactSearch::Slab ContactSearch::MakeSlab(
  const Point& a, const Point& b, const Point& w, const Point& other) const
{
  const Point normal = Cross(b - a, w - a);
  const double tolerance = 2.0 * this->Margin * Length(normal);
  const auto [lower, upper] = std::minmax({ Dot(normal, a), Dot(normal, other) });
  return { normal, lower - tolerance, upper + tolerance };
}

bool ContactSearch::Overlaps(const Slab& slab, const Box& box)
{
  double lower = 0.0, upper = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double x = slab.Normal[k] * box.Lower[k], y = slab.Normal[k] * box.Upper[k];
    lower += std::min(x, y);
    upper += std::max(x, y);
  }
  return lower <= slab.Upper && slab.Lower <= upper;
}

bool ContactSearch::MayMeet(const FanFace& face, const Box& box)
{
  return face.Bounds.Overlaps(box) && Overlaps(face.Slabs[0], box) && Overlaps(face.Slabs[1], box);
}

bool ContactSearch::MayMeet(const Box& box) const
{
  return this->Bounds.Overlaps(box) &&
    std::any_of(this->Faces.begin(), this->Faces.end(),
      [&box](const FanFace& face) { return MayMeet(face, box); });
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
void ContactSearch::AddVertex(const Point& m)
{
  const Box bounds({ m });
  for (const FanFace& face : this->Faces)
  {
    if (m == face.A || m == face.B || !MayMeet(face, bounds))
    {
      continue;
    }
    const Point normal = Cross(face.B - face.A, m - face.A);
    const double time = this->FindTime(normal, face.A);
    if (time < this->Time)
    {
      const Point w = this->PositionAt(time);
      if (ProjectsInto(face.A, face.B, w, Cross(face.B - face.A, w - face.A), m))
      {
        this->Set(time, normal, face.A);
      }
    }
  }
}

/** The edge of the fan from A to w runs into an edge. */
void ContactSearch::AddEdge(const Point& p, const Point& q)
{
  const Box bounds({ p, q });
  for (const FanFace& face : this->Faces)
  {
    const Point& a = face.A;
    if (a == p || a == q || !MayMeet(face, bounds))
    {
      continue;
    }
    Point normal = Cross(p - a, q - a);
    if (Dot(normal, face.Outward) < 0.0)
    {
      normal = Negated(normal);
    }
    const double time = this->FindTime(normal, a);
    if (time >= this->Time)
    {
      continue;
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
    this->SetEnd(this->PositionAt(time));
  }
}

Point ContactSearch::PositionAt(double time) const
{
  return this->From + time * this->Along;
}

} // namespace carving::helper
