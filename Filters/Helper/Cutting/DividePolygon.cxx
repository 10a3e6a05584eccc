// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Cutting/DividePolygon.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace carving::helper
{
namespace
{

/** A vertex of a polygon: its side, and its place there. A corner belongs to the side it begins. */
struct Place
{
  std::size_t Side, At;
};

/** The longest side that has vertices between its ends; the number of sides if none has. */
std::size_t FindLongestDivided(const Sides& polygon, const std::vector<Point>& points)
{
  std::size_t longest = polygon.size();
  double most = -1.0;
  for (std::size_t s = 0; s < polygon.size(); ++s)
  {
    const double length = Length(points[polygon[s].back()] - points[polygon[s].front()]);
    if (polygon[s].size() > 2 && length > most)
    {
      longest = s;
      most = length;
    }
  }
  return longest;
}

/** The closest vertex to another one that shares no side with it, and the distance. */
std::pair<Place, double> FindClosest(
  const Sides& polygon, const Place& from, const std::vector<Point>& points)
{
  const std::size_t count = polygon.size();
  const std::size_t own = from.Side;
  const std::size_t before = (own + count - 1) % count, after = (own + 1) % count;
  const Point& p = points[polygon[own][from.At]];
  std::pair<Place, double> closest = { {}, HUGE_VAL };
  for (std::size_t s = 0; s < count; ++s)
  {
    if (s == own || (s == before && from.At == 0))
    {
      continue;
    }
    const std::size_t first = s == after ? 1 : 0; // the corner ends the side of `from`
    for (std::size_t i = first; i + 1 < polygon[s].size(); ++i)
    {
      const double distance = Length(points[polygon[s][i]] - p);
      if (distance < closest.second)
      {
        closest = { { s, i }, distance };
      }
    }
  }
  return closest;
}

/** The polygon from one vertex around to another and straight back. */
Sides PieceBetween(const Sides& polygon, const Place& from, const Place& to)
{
  const auto at = [](const std::vector<int>& side, std::size_t i)
  { return side.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::vector<int>&first = polygon[from.Side], &last = polygon[to.Side];
  Sides piece = { { at(first, from.At), first.end() } };
  for (std::size_t s = (from.Side + 1) % polygon.size(); s != to.Side; s = (s + 1) % polygon.size())
  {
    piece.push_back(polygon[s]);
  }
  if (to.At > 0)
  {
    piece.push_back({ last.begin(), at(last, to.At + 1) });
  }
  piece.push_back({ last[to.At], first[from.At] });
  return piece;
}

bool IsTriangle(const Sides& polygon)
{
  return polygon.size() == 3 &&
    std::all_of(polygon.begin(), polygon.end(),
      [](const std::vector<int>& side) { return side.size() == 2; });
}

/**
 * Where to divide a polygon: from the middle of its longest divided side to the closest vertex, or,
 * if no side is divided, along its shortest diagonal.
 */
std::pair<Place, Place> FindDiagonal(const Sides& polygon, const std::vector<Point>& points)
{
  const std::size_t divided = FindLongestDivided(polygon, points);
  if (divided < polygon.size())
  {
    const Place middle = { divided, polygon[divided].size() / 2 };
    return { middle, FindClosest(polygon, middle, points).first };
  }
  std::pair<Place, Place> shortest;
  double least = HUGE_VAL;
  for (std::size_t s = 0; s < polygon.size(); ++s)
  {
    const auto [to, distance] = FindClosest(polygon, { s, 0 }, points);
    if (distance < least)
    {
      shortest = { { s, 0 }, to };
      least = distance;
    }
  }
  return shortest;
}

} // namespace

std::vector<Triangle> DividePolygon(const Sides& polygon, const std::vector<Point>& points)
{
  std::vector<Triangle> triangles;
  std::vector<Sides> stack = { polygon };
  while (!stack.empty())
  {
    const Sides piece = std::move(stack.back());
    stack.pop_back();
    if (!IsTriangle(piece))
    {
      const auto [from, to] = FindDiagonal(piece, points);
      stack.push_back(PieceBetween(piece, from, to));
      stack.push_back(PieceBetween(piece, to, from));
      continue;
    }
    const int a = piece[0][0], b = piece[1][0], c = piece[2][0];
    if (a != b && b != c && c != a)
    {
      triangles.push_back({ a, b, c });
    }
  }
  return triangles;
}

std::vector<Triangle> FillGap(const std::vector<int>& side)
{
  std::vector<Triangle> triangles;
  std::vector<std::pair<std::size_t, std::size_t>> stack = { { 0, side.size() - 1 } };
  while (!stack.empty())
  {
    const auto [first, last] = stack.back();
    stack.pop_back();
    if (last - first >= 2)
    {
      const std::size_t middle = (first + last) / 2;
      triangles.push_back({ side[first], side[middle], side[last] });
      stack.push_back({ first, middle });
      stack.push_back({ middle, last });
    }
  }
  return triangles;
}

} // namespace carving::helper
