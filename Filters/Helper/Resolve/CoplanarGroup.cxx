// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/CoplanarGroup.h"

#include "Core/Mesh/SortUnique.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/PlaneTriangulation.h"
#include "Helper/Base/SortedEdge.h"
#include "Helper/Resolve/PlaneProjection.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace carving::helper
{
namespace
{

using Vertex = PlaneTriangulation::Vertex_handle;
using Face = PlaneTriangulation::Face_handle;

using Edge = std::array<int, 2>;
using EdgeHash = boost::hash<Edge>;

/** The triangle with the greatest area: its plane is the one least in doubt. */
int FindLargest(const ResolvedMesh& mesh, const std::vector<int>& triangles)
{
  const auto area = [&mesh](int triangle)
  {
    const auto& [a, b, c] = mesh.Facets[triangle];
    return Length(Cross(mesh.Points[b] - mesh.Points[a], mesh.Points[c] - mesh.Points[a]));
  };
  return *std::max_element(
    triangles.begin(), triangles.end(), [&area](int a, int b) { return area(a) < area(b); });
}

/** The arrangement of the sides and cuts of a group in its plane. */
class Arrangement
{
public:
  Arrangement(const ResolvedMesh& mesh, const CutPoints& cutPoints, const CoplanarGroup& group)
    : Mesh(mesh)
    , Cuts(cutPoints)
    , Group(group)
    , Plane(mesh, FindLargest(mesh, group.Triangles))
  {
  }

  void Build(ResolvedMesh& result)
  {
    this->InsertPoints();
    this->InsertSegments();
    this->AppendPoints(result);
    this->FindBorders();
    this->AppendCovered(result);
  }

private:
  void InsertPoints();
  void InsertSegments();
  void AppendPoints(ResolvedMesh& result);
  void FindBorders();
  void AppendCovered(ResolvedMesh& result) const;
  void AppendFace(const Face& face, const std::vector<int>& cover, ResolvedMesh& result) const;
  std::vector<int> CoverBeyond(const Face& face, int i, const std::vector<int>& cover) const;

  const ResolvedMesh& Mesh;
  const CutPoints& Cuts;
  const CoplanarGroup& Group;
  PlaneProjection Plane;
  PlaneTriangulation Triangulation;
  std::unordered_map<int, Vertex> Vertices;                             ///< of points
  std::vector<std::pair<int, PlaneTriangulation::Constraint_id>> Sides; ///< of triangles
  /** For each edge on the border of any triangle, these triangles. */
  std::unordered_map<Edge, std::vector<int>, EdgeHash> Borders;
};

void Arrangement::InsertPoints()
{
  std::vector<int> points;
  for (const Side& side : this->Group.Sides)
  {
    points.insert(points.end(), { side.From, side.To });
  }
  for (const auto& cut : this->Group.Cuts)
  {
    points.insert(points.end(), cut.begin(), cut.end());
  }
  SortUnique(points);
  std::vector<PlaneKernel::Point_2> places;
  for (const int point : points)
  {
    places.push_back(this->Plane.Flat(this->Cuts.Get(point)));
  }
  const std::vector<Vertex> vertices = InsertInOrder(places, this->Triangulation);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    // The first of several points at one place represents them.
    PointIndex& index = vertices[i]->info();
    index.Value = index.Value < 0 ? points[i] : index.Value;
    this->Vertices[points[i]] = vertices[i];
  }
}

void Arrangement::InsertSegments()
{
  std::vector<std::pair<Edge, int>> sides;
  for (const Side& side : this->Group.Sides)
  {
    sides.emplace_back(SortedEdge(side.From, side.To), side.Triangle);
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const auto& [edge, triangle] = sides[i];
    const Vertex a = this->Vertices[edge[0]], b = this->Vertices[edge[1]];
    if (a == b)
    {
      continue; // seen along the normal, the ends are at one place
    }
    const bool known = i > 0 && sides[i - 1].first == edge;
    this->Sides.emplace_back(
      triangle, known ? this->Sides.back().second : this->Triangulation.insert_constraint(a, b));
  }
  std::unordered_set<Edge, EdgeHash> known;
  for (const auto& [from, to] : this->Group.Cuts)
  {
    const Vertex a = this->Vertices[from], b = this->Vertices[to];
    if (a != b && known.insert(SortedEdge(a->info().Value, b->info().Value)).second)
    {
      this->Triangulation.insert_constraint(a, b);
    }
  }
}

/** Appends the points at which sides and cuts cross. */
void Arrangement::AppendPoints(ResolvedMesh& result)
{
  for (const Vertex vertex : this->Triangulation.finite_vertex_handles())
  {
    int& value = vertex->info().Value;
    if (value < 0)
    {
      value = static_cast<int>(result.Points.size());
      result.Points.push_back(this->Plane.Lift(vertex->point()));
      result.PointSources.push_back(-1);
    }
  }
}

void Arrangement::FindBorders()
{
  for (const auto& [triangle, constraint] : this->Sides)
  {
    const auto end = this->Triangulation.vertices_in_constraint_end(constraint);
    auto vertex = this->Triangulation.vertices_in_constraint_begin(constraint);
    for (auto next = std::next(vertex); next != end; vertex = next++)
    {
      this->Borders[SortedEdge((*vertex)->info().Value, (*next)->info().Value)].push_back(triangle);
    }
  }
}

/**
 * The triangles that cover the neighbor of a face, given those that cover the face: on the edge
 * between them, some triangles end and others begin.
 */
std::vector<int> Arrangement::CoverBeyond(
  const Face& face, int i, const std::vector<int>& cover) const
{
  std::vector<int> beyond = cover;
  if (face->is_constrained(i))
  {
    const auto found = this->Borders.find(
      SortedEdge(face->vertex((i + 1) % 3)->info().Value, face->vertex((i + 2) % 3)->info().Value));
    if (found != this->Borders.end())
    {
      for (const int triangle : found->second)
      {
        const auto place = std::lower_bound(beyond.begin(), beyond.end(), triangle);
        if (place != beyond.end() && *place == triangle)
        {
          beyond.erase(place);
        }
        else
        {
          beyond.insert(place, triangle);
        }
      }
    }
  }
  return beyond;
}

/** Merges all triangles that cover a face into it. The first of them gives it its orientation. */
void Arrangement::AppendFace(
  const Face& face, const std::vector<int>& cover, ResolvedMesh& result) const
{
  const int first = cover.front();
  const CGAL::Orientation orientation = this->Plane.OrientationOf(first);
  const Triangle corners = { face->vertex(0)->info().Value, face->vertex(1)->info().Value,
    face->vertex(2)->info().Value };
  AppendFacet<3>(
    this->Mesh, first, orientation == CGAL::POSITIVE ? corners : Flipped<3>(corners), result);
  for (std::size_t k = 1; k < cover.size(); ++k)
  {
    const int sign = orientation == this->Plane.OrientationOf(cover[k]) ? 1 : -1;
    result.SignedMultiplicities.back() += sign * this->Mesh.SignedMultiplicities[cover[k]];
    result.Multiplicities.back() += this->Mesh.Multiplicities[cover[k]];
  }
}

/** Walks from the unbounded face, which no triangle covers, to all other faces. */
void Arrangement::AppendCovered(ResolvedMesh& result) const
{
  struct Step
  {
    Face To;
    std::vector<int> Cover;
  };
  std::unordered_set<Face> seen = { this->Triangulation.infinite_face() };
  std::vector<Step> steps = { { this->Triangulation.infinite_face(), {} } };
  while (!steps.empty())
  {
    const Step step = std::move(steps.back());
    steps.pop_back();
    if (!step.Cover.empty())
    {
      this->AppendFace(step.To, step.Cover, result);
    }
    for (int i = 0; i < 3; ++i)
    {
      const Face neighbor = step.To->neighbor(i);
      if (seen.insert(neighbor).second)
      {
        steps.push_back({ neighbor, this->CoverBeyond(step.To, i, step.Cover) });
      }
    }
  }
}

} // namespace

bool AreCoplanar(const ResolvedMesh& mesh, int a, int b)
{
  const auto& [p, q, r] = mesh.Facets[a];
  const Triangle& others = mesh.Facets[b];
  return std::all_of(others.begin(), others.end(),
    [&, p = p, q = q, r = r](int x)
    {
      return CGAL::coplanar(ToInexact(mesh.Points[p]), ToInexact(mesh.Points[q]),
        ToInexact(mesh.Points[r]), ToInexact(mesh.Points[x]));
    });
}

void AppendSides(const ResolvedMesh& mesh, int triangle, std::vector<Side>& sides)
{
  const Triangle& t = mesh.Facets[triangle];
  for (int i = 0; i < 3; ++i)
  {
    sides.push_back({ t[i], t[(i + 1) % 3], triangle });
  }
}

void AppendPieces(const ResolvedMesh& mesh, const CutPoints& cutPoints, const CoplanarGroup& group,
  ResolvedMesh& result)
{
  Arrangement(mesh, cutPoints, group).Build(result);
}

} // namespace carving::helper
