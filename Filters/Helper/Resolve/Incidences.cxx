// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/Incidences.h"

#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Resolve/NearPairs.h"

#include <algorithm>
#include <iterator>

namespace carving::helper
{
namespace
{

bool Contains(const std::vector<int>& sorted, int value)
{
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

} // namespace

Incidences::Incidences(ResolvedMesh& mesh, const EdgeList& segments, double tolerance)
  : Mesh(mesh)
  , Tolerance(tolerance)
  , Chains(mesh, segments, tolerance)
  , OnFacets(mesh.Facets.size())
  , Neighbors(mesh.Points.size())
{
  this->FindPointsOnFacets();
  for (const auto& [a, b] : this->Chains.GetParts())
  {
    this->Neighbors[a].push_back(b);
    this->Neighbors[b].push_back(a);
  }
}

void Incidences::FindPointsOnFacets()
{
  for (std::size_t i = 0; i < this->OnFacets.size(); ++i)
  {
    for (const Side& side : this->SidesOf(static_cast<int>(i)))
    {
      this->OnFacets[i].push_back(side.From);
    }
    std::sort(this->OnFacets[i].begin(), this->OnFacets[i].end());
  }
  std::vector<std::vector<int>> inside(this->OnFacets.size());
  const double tolerance = 2.0 * this->Tolerance; // crossings of edges are farther than their ends
  VisitPairs(WidenedBoxes(this->Mesh.Points, EachPoint(this->Mesh.Points), tolerance),
    WidenedBoxes(this->Mesh.Points, this->Mesh.Facets, 0.0),
    [&](int point, int facet)
    {
      if (!Contains(this->OnFacets[facet], point) &&
        DistanceTo(CornersOf<3>(this->Mesh.Points, this->Mesh.Facets[facet]),
          this->Mesh.Points[point]) <= tolerance)
      {
        inside[facet].push_back(point);
      }
    });
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    std::vector<int>& points = this->OnFacets[i];
    points.insert(points.end(), inside[i].begin(), inside[i].end());
    std::sort(points.begin(), points.end());
  }
}

std::vector<Side> Incidences::SidesOf(int facet) const
{
  const Triangle& t = this->Mesh.Facets[facet];
  std::vector<int> points;
  for (int i = 0; i < 3; ++i)
  {
    const std::vector<int> chain = this->Chains.Get(t[i], t[(i + 1) % 3]);
    points.insert(points.end(), chain.begin(), chain.end());
  }
  std::vector<Side> sides;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    sides.push_back({ points[i], points[(i + 1) % points.size()], facet });
  }
  return sides;
}

EdgeList Incidences::PartsOn(int facet) const
{
  EdgeList parts;
  for (const int point : this->OnFacets[facet])
  {
    for (const int neighbor : this->Neighbors[point])
    {
      if (point < neighbor && Contains(this->OnFacets[facet], neighbor))
      {
        parts.push_back({ point, neighbor });
      }
    }
  }
  return parts;
}

std::vector<int> Incidences::CommonPoints(int a, int b) const
{
  std::vector<int> common;
  std::set_intersection(this->OnFacets[a].begin(), this->OnFacets[a].end(),
    this->OnFacets[b].begin(), this->OnFacets[b].end(), std::back_inserter(common));
  return common;
}

bool Incidences::AreFlush(int a, int b) const
{
  constexpr double wide = 16.0; // times the tolerance: wider than a chain along a common edge
  std::vector<Point> points;
  for (const int point : this->CommonPoints(a, b))
  {
    points.push_back(this->Mesh.Points[point]);
  }
  if (points.size() < 3)
  {
    return false;
  }
  const Point along = FarthestFromFirst(points, [](const Point& v) { return Length(v); });
  const auto away = [&](const Point& v) { return Length(Cross(along, v)); };
  return away(FarthestFromFirst(points, away)) > wide * this->Tolerance * Length(along);
}

} // namespace carving::helper
