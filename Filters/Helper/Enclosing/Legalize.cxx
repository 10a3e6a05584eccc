// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Keeps the parts of a Subdivision Delaunay in the planes of their triangles.
 */
#include "Core/Mesh/Vector.h"
#include "Helper/Enclosing/Subdivision.h"

#include <algorithm>

namespace carving::helper
{

Subdivision::Quad Subdivision::GetQuad(int part, int i) const
{
  Quad quad;
  const auto& [corners, parent] = this->Parts[part];
  quad.Apex = corners[i];
  quad.A = corners[(i + 1) % 3];
  quad.B = corners[(i + 2) % 3];
  const std::vector<int>& parts = this->GetPartsOfEdge().at(EdgeKey(quad.A, quad.B));
  if (parts.size() != 2)
  {
    return quad;
  }
  const int other = parts[0] == part ? parts[1] : parts[0];
  if (this->Parts[other].Parent != parent)
  {
    return quad;
  }
  quad.Other = other;
  for (const int corner : this->Parts[other].Corners)
  {
    quad.Opposite = corner != quad.A && corner != quad.B ? corner : quad.Opposite;
  }
  const Point &apex = this->Points[quad.Apex], &a = this->Points[quad.A],
              &opposite = this->Points[quad.Opposite], &b = this->Points[quad.B];
  quad.Cotangents = Cotangent(apex, a, b) + Cotangent(opposite, a, b);
  const auto [first, second, third] = this->GetCorners(parent);
  const Point normal = Cross(second - first, third - first);
  quad.Convex = Dot(Cross(a - apex, opposite - apex), normal) > 0.0 &&
    Dot(Cross(opposite - apex, b - apex), normal) > 0.0;
  return quad;
}

bool Subdivision::OnEdgeOfInput(int part, int i) const
{
  return this->GetQuad(part, i).Other < 0;
}

void Subdivision::Swap(int part, const Quad& quad, Change& change)
{
  const int parent = this->Parts[part].Parent;
  this->Remove(part, change);
  this->Remove(quad.Other, change);
  this->Make({ quad.Apex, quad.A, quad.Opposite }, parent, change);
  this->Make({ quad.Apex, quad.Opposite, quad.B }, parent, change);
}

void Subdivision::Legalize(int vertex, Change& change)
{
  constexpr double rounding = 1e-9;
  const int first = change.Made.front();
  for (std::size_t made = 0; made < change.Made.size(); ++made) // swaps make more
  {
    const int part = change.Made[made];
    if (this->Parts[part].Parent < 0)
    {
      continue;
    }
    const Triangle& corners = this->Parts[part].Corners;
    const auto i = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
    const Quad quad = this->GetQuad(part, static_cast<int>(i));
    if (quad.Other >= 0 && quad.Convex && quad.Cotangents < -rounding)
    {
      this->Swap(part, quad, change);
    }
  }
  const auto drop = [](std::vector<int>& parts, const auto& unwanted)
  { parts.erase(std::remove_if(parts.begin(), parts.end(), unwanted), parts.end()); };
  drop(change.Gone, [&](int part) { return part >= first; });
  drop(change.Made, [&](int part) { return this->Parts[part].Parent < 0; });
}

} // namespace carving::helper
