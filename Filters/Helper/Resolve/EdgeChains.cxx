// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/EdgeChains.h"

#include "Core/Mesh/SortUnique.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/SortedEdge.h"
#include "Helper/Resolve/NearPairs.h"

#include <algorithm>
#include <optional>

namespace carving::helper
{
namespace
{

/** The shares of the ways along two edges at which the edges are closest to each other. */
struct Passing
{
  double ShareOfFirst, ShareOfSecond;
};

/** Where two edges pass each other between their ends. None if they are parallel. */
std::optional<Passing> FindPassing(const std::vector<Point>& points,
  const std::array<int, 2>& first, const std::array<int, 2>& second)
{
  const Point u = points[first[1]] - points[first[0]], v = points[second[1]] - points[second[0]];
  const Point between = points[second[0]] - points[first[0]];
  const Point normal = Cross(u, v);
  const double squared = Dot(normal, normal);
  const Passing passing = { Dot(Cross(between, v), normal) / squared,
    Dot(Cross(between, u), normal) / squared };
  const auto isInside = [](double share) { return share > 0.0 && share < 1.0; }; // false for NaN
  return isInside(passing.ShareOfFirst) && isInside(passing.ShareOfSecond) ? std::optional(passing)
                                                                           : std::nullopt;
}

} // namespace

EdgeChains::EdgeChains(ResolvedMesh& mesh, const EdgeList& segments, double tolerance)
{
  for (const auto& [a, b] : segments)
  {
    this->Edges.push_back(SortedEdge(a, b));
  }
  for (const Triangle& t : mesh.Facets)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Edges.push_back(SortedEdge(t[i], t[(i + 1) % 3]));
    }
  }
  SortUnique(this->Edges);
  this->Inner.resize(this->Edges.size());
  this->DivideAtPoints(mesh, tolerance);
  this->DivideAtCrossings(mesh, tolerance);
}

int EdgeChains::Find(int a, int b) const
{
  return static_cast<int>(
    std::lower_bound(this->Edges.begin(), this->Edges.end(), SortedEdge(a, b)) -
    this->Edges.begin());
}

std::vector<int> EdgeChains::Get(int a, int b) const
{
  const std::vector<int>& inner = this->Inner[this->Find(a, b)];
  std::vector<int> chain = { a };
  if (a < b)
  {
    chain.insert(chain.end(), inner.begin(), inner.end());
  }
  else
  {
    chain.insert(chain.end(), inner.rbegin(), inner.rend());
  }
  return chain;
}

EdgeList EdgeChains::GetParts() const
{
  EdgeList parts;
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    int from = this->Edges[i][0];
    for (const int to : this->Inner[i])
    {
      parts.push_back(SortedEdge(from, to));
      from = to;
    }
    parts.push_back(SortedEdge(from, this->Edges[i][1]));
  }
  SortUnique(parts);
  return parts;
}

void EdgeChains::DivideAtPoints(const ResolvedMesh& mesh, double tolerance)
{
  std::vector<std::vector<Place>> places(this->Edges.size());
  VisitPairs(WidenedBoxes(mesh.Points, EachPoint(mesh.Points), tolerance),
    WidenedBoxes(mesh.Points, this->Edges, 0.0),
    [&](int point, int edge)
    {
      const auto& [a, b] = this->Edges[edge];
      const Point along = mesh.Points[b] - mesh.Points[a];
      const Point to = mesh.Points[point] - mesh.Points[a];
      const double share = Dot(along, to) / Dot(along, along);
      if (point != a && point != b && share > 0.0 && share < 1.0 &&
        Length(to - share * along) <= tolerance)
      {
        places[edge].push_back({ share, point });
      }
    });
  this->Insert(this->Edges, std::move(places));
}

void EdgeChains::DivideAtCrossings(ResolvedMesh& mesh, double tolerance)
{
  const EdgeList parts = this->GetParts();
  this->Insert(parts, FindCrossings(parts, tolerance, mesh));
}

/** Finds where parts pass each other, and appends one point for all that pass one place. */
std::vector<std::vector<EdgeChains::Place>> EdgeChains::FindCrossings(
  const EdgeList& parts, double tolerance, ResolvedMesh& mesh)
{
  struct Crossing
  {
    std::array<int, 2> Parts;
    Passing Where;
  };
  std::vector<Crossing> crossings;
  std::vector<Point> middles;
  VisitPairs(WidenedBoxes(mesh.Points, parts, 0.5 * tolerance),
    [&](int i, int k)
    {
      const auto& [a, b] = parts[i];
      const auto& [c, d] = parts[k];
      if (a == c || a == d || b == c || b == d)
      {
        return;
      }
      if (const std::optional<Passing> passing = FindPassing(mesh.Points, parts[i], parts[k]))
      {
        const Point p = Between(mesh.Points[a], mesh.Points[b], passing->ShareOfFirst);
        const Point q = Between(mesh.Points[c], mesh.Points[d], passing->ShareOfSecond);
        if (Length(q - p) <= tolerance)
        {
          crossings.push_back({ { i, k }, *passing });
          middles.push_back(Between(p, q, 0.5));
        }
      }
    });
  const std::vector<int> points = AppendDistinct(middles, 2.0 * tolerance, mesh);
  std::vector<std::vector<Place>> places(parts.size());
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    const auto& [first, second] = crossings[i].Parts;
    places[first].push_back({ crossings[i].Where.ShareOfFirst, points[i] });
    places[second].push_back({ crossings[i].Where.ShareOfSecond, points[i] });
  }
  return places;
}

/** Divides edges at places that are given on their parts. */
void EdgeChains::Insert(const EdgeList& parts, std::vector<std::vector<Place>> places)
{
  for (std::vector<Place>& of : places)
  {
    std::sort(of.begin(), of.end(),
      [](const Place& a, const Place& b)
      { return a.Share != b.Share ? a.Share < b.Share : a.Point < b.Point; });
  }
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    std::vector<int> inner;
    // Two edges may pass this one at one point, or at one that divides it already.
    const auto add = [&](int point)
    {
      if (point != this->Edges[i][0] && point != this->Edges[i][1] &&
        std::find(inner.begin(), inner.end(), point) == inner.end())
      {
        inner.push_back(point);
      }
    };
    int from = this->Edges[i][0];
    const auto addUpTo = [&](int to)
    {
      const auto part = std::lower_bound(parts.begin(), parts.end(), SortedEdge(from, to));
      std::vector<Place> between = places[part - parts.begin()];
      if (to < from)
      {
        std::reverse(between.begin(), between.end());
      }
      for (const Place& place : between)
      {
        add(place.Point);
      }
      add(to);
      from = to;
    };
    for (const int to : this->Inner[i])
    {
      addUpTo(to);
    }
    addUpTo(this->Edges[i][1]);
    this->Inner[i] = std::move(inner);
  }
}

} // namespace carving::helper
