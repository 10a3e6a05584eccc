// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/Subdivision.h"

#include <algorithm>

namespace carving::helper
{

Subdivision::Subdivision(const ResolvedMesh& input)
  : Points(input.Points)
{
  for (const Triangle& c : input.Facets)
  {
    this->Parts.push_back({ c, static_cast<int>(this->Parts.size()) });
  }
}

Subdivision::EdgeMap& Subdivision::GetPartsOfEdge()
{
  if (this->PartsOfEdge.empty())
  {
    for (int part = 0; part < static_cast<int>(this->Parts.size()); ++part)
    {
      const auto& [corners, parent] = this->Parts[part];
      for (int i = 0; i < 3 && parent >= 0; ++i)
      {
        this->PartsOfEdge[EdgeKey(corners[i], corners[(i + 1) % 3])].push_back(part);
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

void Subdivision::SplitPart(int part, int vertex, Change& change)
{
  const Part old = this->Parts[part];
  const auto& [a, b, c] = old.Corners;
  this->Remove(part, change);
  this->Make({ vertex, a, b }, old.Parent, change);
  this->Make({ vertex, b, c }, old.Parent, change);
  this->Make({ vertex, c, a }, old.Parent, change);
}

void Subdivision::SplitEdge(int a, int b, int vertex, Change& change)
{
  const EdgeMap& partsOfEdge = this->GetPartsOfEdge();
  const auto found = partsOfEdge.find(EdgeKey(a, b));
  const std::vector<int> parts = found == partsOfEdge.end() ? std::vector<int>() : found->second;
  for (const int part : parts)
  {
    const Part old = this->Parts[part];
    this->Remove(part, change);
    for (const int replaced : { a, b })
    {
      Triangle corners = old.Corners;
      std::replace(corners.begin(), corners.end(), replaced, vertex);
      this->Make(corners, old.Parent, change);
    }
  }
}

void Subdivision::Take(int part)
{
  Change change;
  this->Remove(part, change);
}

int Subdivision::Give(const Triangle& corners, int parent)
{
  Change change;
  this->Make(corners, parent, change);
  return change.Made.front();
}

void Subdivision::Make(const Triangle& corners, int parent, Change& change)
{
  const int part = static_cast<int>(this->Parts.size());
  EdgeMap& partsOfEdge = this->GetPartsOfEdge();
  this->Parts.push_back({ corners, parent });
  for (int i = 0; i < 3; ++i)
  {
    partsOfEdge[EdgeKey(corners[i], corners[(i + 1) % 3])].push_back(part);
  }
  change.Made.push_back(part);
}

void Subdivision::MoveCorner(int part, int from, int to)
{
  Triangle& corners = this->Parts[part].Corners;
  const auto corner = std::find(corners.begin(), corners.end(), from);
  for (const int other : corners)
  {
    if (other != from)
    {
      this->DropFromEdge(part, from, other);
      this->PartsOfEdge[EdgeKey(to, other)].push_back(part);
    }
  }
  *corner = to;
}

void Subdivision::DropFromEdge(int part, int a, int b)
{
  EdgeMap& partsOfEdge = this->GetPartsOfEdge();
  const auto edge = partsOfEdge.find(EdgeKey(a, b));
  std::vector<int>& parts = edge->second;
  parts.erase(std::find(parts.begin(), parts.end(), part));
  if (parts.empty())
  {
    partsOfEdge.erase(edge);
  }
}

void Subdivision::Remove(int part, Change& change)
{
  const Triangle& corners = this->Parts[part].Corners;
  for (int i = 0; i < 3; ++i)
  {
    this->DropFromEdge(part, corners[i], corners[(i + 1) % 3]);
  }
  this->Parts[part].Parent = -1;
  change.Gone.push_back(part);
}

} // namespace carving::helper
