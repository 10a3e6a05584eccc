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

int Subdivision::AddPoint(const Point& p)
{
  this->Points.push_back(p);
  return static_cast<int>(this->Points.size()) - 1;
}

void Subdivision::SplitPart(int part, int vertex, Change& change)
{
  const auto [a, b, c] = this->Parts[part].Corners;
  this->Replace(part, { { vertex, a, b }, { vertex, b, c }, { vertex, c, a } }, change);
}

void Subdivision::SplitAtEdge(int part, int a, int b, int vertex, Change& change)
{
  Triangle withB = this->Parts[part].Corners, withA = withB;
  std::replace(withB.begin(), withB.end(), a, vertex);
  std::replace(withA.begin(), withA.end(), b, vertex);
  this->Replace(part, { withB, withA }, change);
}

void Subdivision::Replace(int part, const std::vector<Triangle>& pieces, Change& change)
{
  const int parent = this->Parts[part].Parent;
  this->Take(part);
  change.Gone.push_back(part);
  for (const Triangle& piece : pieces)
  {
    change.Made.push_back(this->Give(piece, parent));
  }
}

void Subdivision::MoveCorner(int part, int from, int to)
{
  Triangle& corners = this->Parts[part].Corners;
  std::replace(corners.begin(), corners.end(), from, to);
}

int Subdivision::Give(const Triangle& corners, int parent)
{
  this->Parts.push_back({ corners, parent });
  return static_cast<int>(this->Parts.size()) - 1;
}

} // namespace carving::helper
