// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/Imprint.h"

#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/FacetTree.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Incidences.h"
#include "Helper/Resolve/NearPairs.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

using Pairs = std::vector<std::pair<int, int>>;

/** The segments in which triangles cross each other, except for those that edges lie along. */
class Cuts
{
public:
  Cuts(const ResolvedMesh& mesh, const Incidences& incidences, double tolerance)
    : Mesh(mesh)
    , Known(incidences)
    , Tolerance(tolerance)
    , Points(mesh)
  {
  }

  void Add(int a, int b);
  EdgeList AppendTo(ResolvedMesh& mesh) const;

private:
  bool IsAlongCommon(const std::array<int, 2>& cut, const std::vector<int>& common) const;

  const ResolvedMesh& Mesh;
  const Incidences& Known;
  double Tolerance;
  CutPoints Points;
  EdgeList Segments;
};

void Cuts::Add(int a, int b)
{
  if (AreCoplanar(this->Mesh, a, b) || this->Known.AreFlush(a, b))
  {
    return;
  }
  const std::array<int, 2> cut = this->Points.Intersect(a, b);
  if (!this->IsAlongCommon(cut, this->Known.CommonPoints(a, b)))
  {
    this->Segments.push_back(cut);
  }
}

/** Whether a cut lies between points that both triangles have, where rounding has made it. */
bool Cuts::IsAlongCommon(const std::array<int, 2>& cut, const std::vector<int>& common) const
{
  const auto isNear = [&](int end)
  {
    const Point p = this->Points.GetRounded(end), &first = this->Mesh.Points[common.front()];
    return std::any_of(common.begin() + 1, common.end(),
      [&](int other)
      {
        const FacetCorners<2> between = { first, this->Mesh.Points[other] };
        return DistanceTo(between, p) <= 2.0 * this->Tolerance;
      });
  };
  return !common.empty() && isNear(cut[0]) && isNear(cut[1]);
}

/** Appends the ends of cuts that are no points of the mesh. Returns the cuts between its points. */
EdgeList Cuts::AppendTo(ResolvedMesh& mesh) const
{
  std::vector<Point> ends;
  for (const auto& [from, to] : this->Segments)
  {
    ends.push_back(this->Points.GetRounded(from));
    ends.push_back(this->Points.GetRounded(to));
  }
  const std::vector<int> places = AppendDistinct(ends, this->Tolerance, mesh);
  EdgeList between;
  for (std::size_t i = 0; i < places.size(); i += 2)
  {
    if (places[i] != places[i + 1])
    {
      between.push_back({ places[i], places[i + 1] });
    }
  }
  return between;
}

/** The triangles that have to be split, those that lie on each other in one group. */
std::vector<CoplanarGroup> FindGroups(
  const ResolvedMesh& mesh, const Incidences& incidences, double tolerance)
{
  std::vector<int> touched;
  std::vector<Triangle> facets;
  for (std::size_t i = 0; i < mesh.Facets.size(); ++i)
  {
    if (incidences.PointsOn(static_cast<int>(i)).size() > 3)
    {
      touched.push_back(static_cast<int>(i));
      facets.push_back(mesh.Facets[i]);
    }
  }
  DisjointSets sets(touched.size());
  VisitPairs(WidenedBoxes(mesh.Points, facets, tolerance),
    [&](int i, int k)
    {
      if (incidences.AreFlush(touched[i], touched[k]))
      {
        sets.Unite(i, k);
      }
    });
  std::vector<CoplanarGroup> groups(touched.size()); // most of them stay empty
  for (std::size_t i = 0; i < touched.size(); ++i)
  {
    const int facet = touched[i];
    CoplanarGroup& group = groups[sets.Find(static_cast<int>(i))];
    group.Triangles.push_back(facet);
    for (const Side& side : incidences.SidesOf(facet))
    {
      group.Sides.push_back(side);
    }
    for (const int point : incidences.PointsOn(facet))
    {
      group.Cuts.push_back({ point, point });
    }
    for (const auto& part : incidences.PartsOn(facet))
    {
      group.Cuts.push_back(part);
    }
  }
  return groups;
}

} // namespace

ResolvedMesh Weld(ResolvedMesh mesh, double tolerance, double& distance)
{
  const std::vector<int> first = FirstNearPoints(mesh.Points, tolerance);
  double farthest = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    if (mesh.PointSources[i] >= 0)
    {
      farthest = std::max(farthest, Length(mesh.Points[first[i]] - mesh.Points[i]));
    }
  }
  distance += farthest;
  for (Triangle& facet : mesh.Facets)
  {
    for (int& corner : facet)
    {
      corner = first[corner];
    }
  }
  return Clean(mesh);
}

ResolvedMesh Imprint(ResolvedMesh mesh, const Pairs& pairs, double tolerance)
{
  EdgeList segments;
  {
    const Incidences incidences(mesh, {}, tolerance);
    const ResolvedMesh before = mesh; // ends of cuts are numbered after its points
    Cuts cuts(before, incidences, tolerance);
    for (const auto& [a, b] : pairs)
    {
      cuts.Add(a, b);
    }
    segments = cuts.AppendTo(mesh);
  }
  const Incidences incidences(mesh, segments, tolerance);
  ResolvedMesh result;
  result.Points = mesh.Points;
  result.PointSources = mesh.PointSources;
  for (std::size_t i = 0; i < mesh.Facets.size(); ++i)
  {
    if (incidences.PointsOn(static_cast<int>(i)).size() == 3)
    {
      AppendFacet<3>(mesh, i, mesh.Facets[i], result);
    }
  }
  const CutPoints points(mesh);
  for (const CoplanarGroup& group : FindGroups(mesh, incidences, tolerance))
  {
    if (!group.Triangles.empty())
    {
      AppendPieces(mesh, points, group, result);
    }
  }
  return Clean(result);
}

} // namespace carving::helper
