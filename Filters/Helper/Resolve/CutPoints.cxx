// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/CutPoints.h"

#include <algorithm>

namespace carving::helper
{

CutPoints::CutPoints(const ResolvedMesh& mesh)
  : Mesh(mesh)
{
}

std::array<int, 2> CutPoints::Intersect(int a, int b)
{
  std::vector<int> ends;
  this->AddEnds(a, b, ends);
  this->AddEnds(b, a, ends);
  // Where edges cross edges, one end is found as several equal points. Points of the mesh have the
  // lowest indices, so they are preferred.
  std::sort(ends.begin(), ends.end());
  int last = ends.front();
  for (const int end : ends)
  {
    last = this->AreEqual(ends.front(), end) ? last : end;
  }
  return { ends.front(), last };
}

ExactPoint CutPoints::Get(int point) const
{
  const int count = static_cast<int>(this->Mesh.Points.size());
  if (point >= count)
  {
    return this->Made[point - count];
  }
  const Point& p = this->Mesh.Points[point];
  return { Exact::FT(p[0]), Exact::FT(p[1]), Exact::FT(p[2]) };
}

Point CutPoints::GetRounded(int point) const
{
  const auto [x, y, z] = this->Get(point);
  return { CGAL::to_double(x.exact()), CGAL::to_double(y.exact()), CGAL::to_double(z.exact()) };
}

void CutPoints::AppendRounded(ResolvedMesh& result) const
{
  const std::size_t given = this->Mesh.Points.size();
  for (std::size_t i = 0; i < this->Made.size(); ++i)
  {
    result.Points.push_back(this->GetRounded(static_cast<int>(given + i)));
    result.PointSources.push_back(-1);
  }
}

/** Adds the points at which corners and edges of triangle a meet triangle b. */
void CutPoints::AddEnds(int a, int b, std::vector<int>& ends)
{
  const Triangle &of = this->Mesh.Facets[a], &other = this->Mesh.Facets[b];
  const Inexact::Point_3 p = this->At(other[0]), q = this->At(other[1]), r = this->At(other[2]);
  CGAL::Orientation sides[3];
  for (int i = 0; i < 3; ++i)
  {
    const bool common = std::find(other.begin(), other.end(), of[i]) != other.end();
    sides[i] = common ? CGAL::COPLANAR : CGAL::orientation(p, q, r, this->At(of[i]));
    if (common ||
      (sides[i] == CGAL::COPLANAR && Inexact::Triangle_3(p, q, r).has_on(this->At(of[i]))))
    {
      ends.push_back(of[i]);
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    if (sides[i] * sides[next] >= 0)
    {
      continue;
    }
    const Inexact::Point_3 from = this->At(of[i]), to = this->At(of[next]);
    const int turns[3] = { CGAL::orientation(from, to, p, q), CGAL::orientation(from, to, q, r),
      CGAL::orientation(from, to, r, p) };
    const auto [least, most] = std::minmax({ turns[0], turns[1], turns[2] });
    if (least >= 0 || most <= 0)
    {
      const auto [lower, upper] = std::minmax({ of[i], of[next] });
      ends.push_back(this->Find({ lower, upper, b }));
    }
  }
}

int CutPoints::Find(const Crossing& crossing)
{
  const int count = static_cast<int>(this->Mesh.Points.size() + this->Made.size());
  const auto [found, isNew] = this->Known.try_emplace(crossing, count);
  if (isNew)
  {
    const auto& [fromPoint, toPoint, triangle] = crossing;
    const ExactVector& normal = this->NormalOf(triangle);
    const ExactVector origin = this->ToExactVector(this->Mesh.Facets[triangle][0]),
                      from = this->ToExactVector(fromPoint), to = this->ToExactVector(toPoint);
    Exact::Exact_kernel::FT atFrom = 0, atTo = 0;
    for (int i = 0; i < 3; ++i)
    {
      atFrom += normal[i] * (from[i] - origin[i]);
      atTo += normal[i] * (to[i] - origin[i]);
    }
    const Exact::Exact_kernel::FT share = atFrom / (atFrom - atTo);
    ExactPoint& point = this->Made.emplace_back();
    for (int i = 0; i < 3; ++i)
    {
      const Exact::Exact_kernel::FT coordinate = from[i] + share * (to[i] - from[i]);
      point[i] = Exact::FT(coordinate);
    }
  }
  return found->second;
}

const CutPoints::ExactVector& CutPoints::NormalOf(int triangle)
{
  const auto [found, isNew] = this->Normals.try_emplace(triangle);
  ExactVector& normal = found->second;
  if (isNew)
  {
    const Triangle& t = this->Mesh.Facets[triangle];
    const ExactVector a = this->ToExactVector(t[0]);
    ExactVector u = this->ToExactVector(t[1]), v = this->ToExactVector(t[2]);
    for (int i = 0; i < 3; ++i)
    {
      u[i] -= a[i];
      v[i] -= a[i];
    }
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3, last = (i + 2) % 3;
      normal[i] = u[next] * v[last] - u[last] * v[next];
    }
  }
  return normal;
}

CutPoints::ExactVector CutPoints::ToExactVector(int point) const
{
  const Point& p = this->Mesh.Points[point];
  return { p[0], p[1], p[2] };
}

Inexact::Point_3 CutPoints::At(int point) const
{
  return ToInexact(this->Mesh.Points[point]);
}

bool CutPoints::AreEqual(int a, int b) const
{
  const int count = static_cast<int>(this->Mesh.Points.size());
  if (a == b || std::max(a, b) < count)
  {
    return a == b;
  }
  return this->Get(a) == this->Get(b);
}

} // namespace carving::helper
