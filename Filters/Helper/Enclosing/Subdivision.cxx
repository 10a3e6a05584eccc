// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/Subdivision.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>

namespace carving::helper
{

Subdivision::Subdivision(const ResolvedMesh& input)
  : Points(input.Points)
{
  for (const Triangle& c : input.Facets)
  {
    this->Normals.push_back(
      Cross(this->Points[c[1]] - this->Points[c[0]], this->Points[c[2]] - this->Points[c[0]]));
    this->Parts.push_back({ c, static_cast<int>(this->Parts.size()) });
  }
}

Subdivision::EdgeMap& Subdivision::GetPartsOfEdge() const
{
  if (this->PartsOfEdge.empty())
  {
    for (int part = 0; part < static_cast<int>(this->Parts.size()); ++part)
    {
      const Triangle& corners = this->Parts[part].Corners;
      for (int i = 0; i < 3; ++i)
      {
        this->PartsOfEdge[Key(corners[i], corners[(i + 1) % 3])].push_back(part);
      }
    }
  }
  return this->PartsOfEdge;
}

int Subdivision::AddPoint(const Point& p)
{
  this->Points.push_back(p);
  return static_cast<int>(this->Points.size()) - 1;
}

Subdivision::Change Subdivision::SplitPart(int part, int vertex)
{
  Change change;
  const Part old = this->Parts[part];
  const auto& [a, b, c] = old.Corners;
  this->Remove(part, change);
  this->Legalize({ this->Make({ vertex, a, b }, old.Parent, change),
                   this->Make({ vertex, b, c }, old.Parent, change),
                   this->Make({ vertex, c, a }, old.Parent, change) },
    vertex, change);
  this->Settle(change);
  return change;
}

Subdivision::Change Subdivision::SplitEdge(int a, int b, int vertex)
{
  Change change;
  std::vector<int> made;
  const std::vector<int> parts = this->GetPartsOfEdge().at(Key(a, b));
  for (const int part : parts)
  {
    const Part old = this->Parts[part];
    this->Remove(part, change);
    for (const int replaced : { a, b })
    {
      Triangle corners = old.Corners;
      std::replace(corners.begin(), corners.end(), replaced, vertex);
      made.push_back(this->Make(corners, old.Parent, change));
    }
  }
  this->Legalize(std::move(made), vertex, change);
  this->Settle(change);
  return change;
}

bool Subdivision::OnEdgeOfInput(int part, int i) const
{
  return this->GetQuad(part, i).Other < 0;
}

std::uint64_t Subdivision::Key(int a, int b)
{
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
    static_cast<std::uint32_t>(std::max(a, b));
}

int Subdivision::Make(const Triangle& corners, int parent, Change& change)
{
  const int part = static_cast<int>(this->Parts.size());
  EdgeMap& partsOfEdge = this->GetPartsOfEdge();
  this->Parts.push_back({ corners, parent });
  for (int i = 0; i < 3; ++i)
  {
    partsOfEdge[Key(corners[i], corners[(i + 1) % 3])].push_back(part);
  }
  change.Made.push_back(part);
  return part;
}

void Subdivision::Remove(int part, Change& change)
{
  const Triangle& corners = this->Parts[part].Corners;
  EdgeMap& partsOfEdge = this->GetPartsOfEdge();
  for (int i = 0; i < 3; ++i)
  {
    const auto edge = partsOfEdge.find(Key(corners[i], corners[(i + 1) % 3]));
    std::vector<int>& parts = edge->second;
    parts.erase(std::find(parts.begin(), parts.end(), part));
    if (parts.empty())
    {
      partsOfEdge.erase(edge);
    }
  }
  this->Parts[part].Parent = -1;
  change.Gone.push_back(part);
}

Subdivision::Quad Subdivision::GetQuad(int part, int i) const
{
  Quad quad;
  const auto& [corners, parent] = this->Parts[part];
  quad.Apex = corners[i];
  quad.A = corners[(i + 1) % 3];
  quad.B = corners[(i + 2) % 3];
  const std::vector<int>& parts = this->GetPartsOfEdge().at(Key(quad.A, quad.B));
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
  const Point& normal = this->Normals[parent];
  quad.Convex = Dot(Cross(a - apex, opposite - apex), normal) > 0.0 &&
    Dot(Cross(opposite - apex, b - apex), normal) > 0.0;
  return quad;
}

std::array<int, 2> Subdivision::Swap(int part, const Quad& quad, Change& change)
{
  const int parent = this->Parts[part].Parent;
  this->Remove(part, change);
  this->Remove(quad.Other, change);
  return { this->Make({ quad.Apex, quad.A, quad.Opposite }, parent, change),
    this->Make({ quad.Apex, quad.Opposite, quad.B }, parent, change) };
}

/** Swaps edges opposite to a new vertex, the apex, until all of them are Delaunay. */
void Subdivision::Legalize(std::vector<int> parts, int apex, Change& change)
{
  constexpr double Rounding = 1e-9;
  while (!parts.empty())
  {
    const int part = parts.back();
    parts.pop_back();
    if (this->Parts[part].Parent < 0)
    {
      continue;
    }
    const Triangle& corners = this->Parts[part].Corners;
    const auto i = std::find(corners.begin(), corners.end(), apex) - corners.begin();
    const Quad quad = this->GetQuad(part, static_cast<int>(i));
    if (quad.Other >= 0 && quad.Convex && quad.Cotangents < -Rounding)
    {
      for (const int made : this->Swap(part, quad, change))
      {
        parts.push_back(made);
      }
    }
  }
}

/** Drops the parts that were made and removed within one change. */
void Subdivision::Settle(Change& change) const
{
  const int first = change.Made.front();
  const auto drop = [](std::vector<int>& parts, const auto& unwanted)
  { parts.erase(std::remove_if(parts.begin(), parts.end(), unwanted), parts.end()); };
  drop(change.Gone, [&](int part) { return part >= first; });
  drop(change.Made, [&](int part) { return this->Parts[part].Parent < 0; });
}

} // namespace carving::helper
