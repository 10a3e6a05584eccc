// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/FaceDistance.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

namespace carving
{
namespace
{

/** The factor by which a final bound may be too large. */
constexpr double Tolerance = 1.01;

/**
 * The greatest distance that needs no such accuracy, as a share of the diagonal. Rounded to single
 * precision, faces and facets in one plane are about this far apart.
 */
constexpr double NegligibleShare = 1e-6;

using Polygon = std::vector<Point>;

/** Divides a convex polygon by the plane through p: the part in front, the part behind. */
std::array<Polygon, 2> Divide(const Polygon& polygon, const Point& normal, const Point& p)
{
  std::array<Polygon, 2> parts;
  if (std::all_of(
        polygon.begin(), polygon.end(), [&](const Point& x) { return Dot(normal, x - p) >= 0.0; }))
  {
    parts[0] = polygon;
    return parts;
  }
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double start = Dot(normal, from - p), end = Dot(normal, to - p);
    if (start >= 0.0)
    {
      parts[0].push_back(from);
    }
    if (start <= 0.0)
    {
      parts[1].push_back(from);
    }
    if (start * end < 0.0)
    {
      const Point crossing = Between(from, to, start / (start - end));
      parts[0].push_back(crossing);
      parts[1].push_back(crossing);
    }
  }
  return parts;
}

void AppendTriangles(const Polygon& polygon, std::vector<FacetCorners<3>>& triangles)
{
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    triangles.push_back({ polygon[0], polygon[i - 1], polygon[i] });
  }
}

double AreaOf(const std::vector<FacetCorners<3>>& triangles)
{
  double area = 0.0;
  for (const auto& [a, b, c] : triangles)
  {
    area += Length(Cross(b - a, c - a)) / 2.0;
  }
  return area;
}

std::vector<FacetCorners<2>> Split(const FacetCorners<2>& piece, const FacetCorners<2>&)
{
  return Halve<2>(piece);
}

/**
 * Divides a piece into the part above a facet, where only the distance from this facet matters, and
 * the remainder. Halving alone would need tiny pieces along the borders of facets if the piece is
 * very close to several facets in one plane. Halves the piece where it is not close, and where a
 * part would be small or the piece is a sliver.
 */
std::vector<FacetCorners<3>> Split(const FacetCorners<3>& piece, const FacetCorners<3>& facet)
{
  constexpr double leastShare = 0.03, leastWidth = 1e-3, greatestHeight = 0.1;
  const double length = LengthOfLongestSide<3>(piece), area = AreaOf({ piece });
  const Point normal = Cross(facet[1] - facet[0], facet[2] - facet[0]);
  const auto isClose = [&](const Point& p)
  { return std::abs(Dot(normal, p - facet[0])) <= greatestHeight * length * Length(normal); };
  if (area < leastWidth * length * length || !std::all_of(piece.begin(), piece.end(), isClose))
  {
    return Halve<3>(piece);
  }
  Polygon above(piece.begin(), piece.end());
  std::vector<FacetCorners<3>> others, parts;
  for (int i = 0; i < 3; ++i)
  {
    const Point inward = Cross(normal, facet[(i + 1) % 3] - facet[i]);
    const auto divided = Divide(above, inward, facet[i]);
    above = divided[0];
    AppendTriangles(divided[1], others);
  }
  AppendTriangles(above, parts);
  if (std::min(AreaOf(parts), AreaOf(others)) <= leastShare * area)
  {
    return Halve<3>(piece);
  }
  parts.insert(parts.end(), others.begin(), others.end());
  return parts;
}

} // namespace

template <int D>
int LongestSide(const FacetCorners<D>& face)
{
  int longest = 0;
  for (int i = 1; i < D; ++i)
  {
    if (Length(face[(i + 1) % D] - face[i]) > Length(face[(longest + 1) % D] - face[longest]))
    {
      longest = i;
    }
  }
  return longest;
}

template <int D>
double LengthOfLongestSide(const FacetCorners<D>& face)
{
  const int longest = LongestSide<D>(face);
  return Length(face[(longest + 1) % D] - face[longest]);
}

template <int D>
std::vector<FacetCorners<D>> Halve(const FacetCorners<D>& face)
{
  const int side = LongestSide<D>(face), next = (side + 1) % D;
  const Point middle = Between(face[side], face[next], 0.5);
  std::vector<FacetCorners<D>> halves(2, face);
  halves[0][side] = middle;
  halves[1][next] = middle;
  return halves;
}

template <int D>
double BallRadius(const FacetCorners<D>& face)
{
  const int i = LongestSide<D>(face);
  const Point &a = face[i], &b = face[(i + 1) % D], &c = face[(i + 2) % D];
  const double half = Length(b - a) / 2.0;
  const double product = D == 3 ? Dot(a - c, b - c) : 0.0;
  // The circumradius of an acute triangle follows from its longest side and the opposite angle.
  return product <= 0.0 ? half : half * Length(a - c) * Length(b - c) / Length(Cross(a - c, b - c));
}

template <int D>
FaceDistance<D>::FaceDistance(const ResolvedInput<D>& mesh)
  : Tree(mesh)
  , Negligible(NegligibleShare * Diagonal(mesh))
{
}

template <int D>
typename FaceDistance<D>::Bound FaceDistance<D>::Compute(
  const FacetCorners<D>& face, int queries, double enough, const FacetCorners<D>* nearby) const
{
  enough = std::max(enough, this->Negligible);
  std::priority_queue<Piece> pieces;
  double lower = 0.0;
  pieces.push(this->MakePiece(face, nearby, enough, lower));
  const FacetCorners<D> closest = pieces.top().Closest;
  for (int asked = 1;;)
  {
    const Piece top = pieces.top();
    const bool final = top.Upper <= Tolerance * lower || top.Upper <= this->Negligible;
    if (final || asked >= queries || top.Upper <= enough)
    {
      return { lower, top.Upper, final, closest };
    }
    pieces.pop();
    for (const FacetCorners<D>& part : Split(top.Corners, top.Closest))
    {
      pieces.push(this->MakePiece(part, &top.Closest, enough, lower));
      ++asked;
    }
  }
}

template <int D>
double FaceDistance<D>::FindFarther(const std::vector<FacetCorners<D>>& faces, double bound,
  long long& queries, const FacetCorners<D>& nearby) const
{
  double lower = 0.0;
  // Large pieces come before their parts: a point that is too far is mostly found by few of them.
  std::vector<Piece> open;
  const auto ask = [&](const FacetCorners<D>& corners, const FacetCorners<D>& start)
  {
    const Piece piece = this->MakePiece(corners, &start, bound, lower);
    if (piece.Upper > bound)
    {
      open.push_back(piece);
    }
    --queries;
  };
  for (const FacetCorners<D>& face : faces)
  {
    ask(face, nearby);
  }
  std::size_t next = 0;
  for (; next < open.size() && lower <= bound && queries > 0; ++next)
  {
    const Piece piece = open[next];
    for (const FacetCorners<D>& part : Split(piece.Corners, piece.Closest))
    {
      ask(part, piece.Closest);
    }
  }
  return next == open.size() ? 0.0 : std::max(lower, bound);
}

/**
 * Bounds the distances of a piece by that from one facet. The search begins at a facet nearby if
 * there is one, and ends early at a facet that is close enough to the whole piece.
 */
template <int D>
typename FaceDistance<D>::Piece FaceDistance<D>::MakePiece(
  const FacetCorners<D>& corners, const FacetCorners<D>* nearby, double enough, double& lower) const
{
  Point center = {};
  for (const Point& corner : corners)
  {
    for (int i = 0; i < 3; ++i)
    {
      center[i] += corner[i] / D;
    }
  }
  Piece piece = { corners, {}, Box::Infinity };
  double least = Box::Infinity;
  const auto consider = [&](const FacetCorners<D>& facet)
  {
    const double distance = DistanceTo(facet, center);
    if (distance < least)
    {
      least = distance;
      piece.Closest = facet;
      piece.Upper = 0.0;
      for (const Point& corner : corners)
      {
        piece.Upper = std::max(piece.Upper, DistanceTo(facet, corner));
      }
    }
    return piece.Upper <= enough ? 0.0 : least * least;
  };
  const double limit = nearby ? consider(*nearby) : Box::Infinity;
  this->Tree.ForEachNear(
    center, limit, [&](int facet) { return consider(this->Tree.GetItems().CornersOf(facet)); });
  if (piece.Upper > enough)
  {
    lower = std::max(lower, least);
  }
  return piece;
}

template int LongestSide<2>(const FacetCorners<2>&);
template int LongestSide<3>(const FacetCorners<3>&);
template double LengthOfLongestSide<2>(const FacetCorners<2>&);
template double LengthOfLongestSide<3>(const FacetCorners<3>&);
template std::vector<FacetCorners<2>> Halve<2>(const FacetCorners<2>&);
template std::vector<FacetCorners<3>> Halve<3>(const FacetCorners<3>&);
template double BallRadius<2>(const FacetCorners<2>&);
template double BallRadius<3>(const FacetCorners<3>&);
template class FaceDistance<2>;
template class FaceDistance<3>;

} // namespace carving
