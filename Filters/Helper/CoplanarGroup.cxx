// SPDX-License-Identifier: AGPL-3.0-or-later
#include "CoplanarGroup.h"

#include "ResolveContours.h"
#include "Vector.h"

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>

using namespace carving;

namespace
{

using Vertex = PlaneTriangulation::Vertex_handle;
using Face = PlaneTriangulation::Face_handle;

/** A plane, seen along the axis to which it is the least inclined. */
class Projection
{
public:
  Projection(const ResolvedMesh& mesh, int triangle)
    : Mesh(mesh)
  {
    const auto& [a, b, c] = mesh.Facets[triangle];
    const Point normal = Cross(mesh.Points[b] - mesh.Points[a], mesh.Points[c] - mesh.Points[a]);
    std::array<int, 3> axes = { 0, 1, 2 };
    std::sort(axes.begin(), axes.end(),
      [&](int i, int k) { return std::abs(normal[i]) > std::abs(normal[k]); });
    // What is rounded may mislead where the triangle is a sliver.
    for (const int axis : axes)
    {
      this->Axis = axis;
      if (this->SideOf(triangle) != CGAL::COLLINEAR)
      {
        break;
      }
    }
    this->Origin = ToExact(mesh.Points[a]);
    const Exact::Vector_3 exact = CGAL::cross_product(
      ToExact(mesh.Points[b]) - this->Origin, ToExact(mesh.Points[c]) - this->Origin);
    this->SlopeU = -exact[this->U()] / exact[this->Axis];
    this->SlopeV = -exact[this->V()] / exact[this->Axis];
    this->SlopeU.exact();
    this->SlopeV.exact();
  }

  Point Flat(int point) const
  {
    const Point& p = this->Mesh.Points[point];
    return { p[this->U()], p[this->V()], 0.0 };
  }

  PlaneKernel::Point_2 Flat(const Exact::Point_3& p) const
  {
    return { p[this->U()], p[this->V()] };
  }

  /** The point of the plane at a place, rounded: equal points give equal results, however they were made. */
  Point Lift(const PlaneKernel::Point_2& place) const
  {
    const Exact::FT height = this->Origin[this->Axis] +
      this->SlopeU * (place.x() - this->Origin[this->U()]) +
      this->SlopeV * (place.y() - this->Origin[this->V()]);
    Point p;
    p[this->U()] = CGAL::to_double(place.x().exact());
    p[this->V()] = CGAL::to_double(place.y().exact());
    p[this->Axis] = CGAL::to_double(height.exact());
    return p;
  }

  /** How a triangle of the plane is oriented as it is seen. */
  CGAL::Orientation SideOf(int triangle) const
  {
    const auto& [a, b, c] = this->Mesh.Facets[triangle];
    const auto flat = [this](int point)
    {
      const Point p = this->Flat(point);
      return Inexact::Point_2(p[0], p[1]);
    };
    return CGAL::orientation(flat(a), flat(b), flat(c));
  }

private:
  int U() const
  {
    return (this->Axis + 1) % 3;
  }
  int V() const
  {
    return (this->Axis + 2) % 3;
  }

  const ResolvedMesh& Mesh;
  int Axis;
  Exact::Point_3 Origin;
  Exact::FT SlopeU, SlopeV;
};

/** Inserts points, neighbors one after the other so that each is found from the one before it. */
std::vector<Vertex> InsertExactPoints(
  const std::vector<PlaneKernel::Point_2>& places, PlaneTriangulation& triangulation)
{
  std::vector<Inexact::Point_2> rounded;
  rounded.reserve(places.size());
  for (const auto& place : places)
  {
    rounded.emplace_back(CGAL::to_double(place.x()), CGAL::to_double(place.y()));
  }
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  using Map = CGAL::Pointer_property_map<Inexact::Point_2>::type;
  CGAL::spatial_sort(order.begin(), order.end(),
    CGAL::Spatial_sort_traits_adapter_2<Inexact, Map>(CGAL::make_property_map(rounded)));
  std::vector<Vertex> vertices(places.size());
  Face hint;
  for (const std::size_t i : order)
  {
    vertices[i] = triangulation.insert(places[i], hint);
    hint = vertices[i]->face();
  }
  return vertices;
}

using Edge = std::pair<int, int>;

struct EdgeHash
{
  std::size_t operator()(const Edge& edge) const
  {
    const std::uint64_t key = static_cast<std::uint64_t>(edge.first) << 32 | edge.second;
    return std::hash<std::uint64_t>()(key * 0x9E3779B97F4A7C15u);
  }
};

Edge Undirected(int a, int b)
{
  return std::minmax(a, b);
}

class Arrangement
{
public:
  Arrangement(const ResolvedMesh& mesh, const CoplanarGroup& group)
    : Mesh(mesh)
    , Group(group)
    , Plane(mesh, group.Triangles.front())
  {
  }

  void Build(ResolvedMesh& result)
  {
    this->InsertSides();
    this->InsertCuts();
    this->AppendPoints(result);
    this->FindBorders();
    this->AppendCovered(result);
  }

private:
  void InsertSides();
  void InsertCuts();
  void AppendPoints(ResolvedMesh& result);
  void FindBorders();
  void AppendCovered(ResolvedMesh& result) const;
  void AppendFace(const Face& face, const std::vector<int>& cover, ResolvedMesh& result) const;
  std::vector<int> CoverBeyond(const Face& face, int i, const std::vector<int>& cover) const;

  const ResolvedMesh& Mesh;
  const CoplanarGroup& Group;
  Projection Plane;
  PlaneTriangulation Triangulation;
  std::vector<int> Corners; ///< points of the mesh, ascending; the first vertices
  std::vector<std::pair<Edge, PlaneTriangulation::Constraint_id>> Sides; ///< by corners
  /** By vertices: the triangles of whose borders an edge is. */
  std::unordered_map<Edge, std::vector<int>, EdgeHash> Borders;
};

void Arrangement::InsertSides()
{
  std::vector<Edge> edges;
  for (const int triangle : this->Group.Triangles)
  {
    const Triangle& t = this->Mesh.Facets[triangle];
    for (int i = 0; i < 3; ++i)
    {
      this->Corners.push_back(t[i]);
      edges.push_back(Undirected(t[i], t[(i + 1) % 3]));
    }
  }
  const auto sort = [](auto& all)
  {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  };
  sort(this->Corners);
  sort(edges);
  std::vector<Point> places;
  for (const int corner : this->Corners)
  {
    places.push_back(this->Plane.Flat(corner));
  }
  const std::vector<Vertex> vertices = InsertPoints(places, this->Triangulation);
  const auto vertexOf = [&](int corner)
  {
    return vertices[std::lower_bound(this->Corners.begin(), this->Corners.end(), corner) -
      this->Corners.begin()];
  };
  for (const Edge& edge : edges)
  {
    this->Sides.emplace_back(
      edge, this->Triangulation.insert_constraint(vertexOf(edge.first), vertexOf(edge.second)));
  }
}

void Arrangement::InsertCuts()
{
  std::vector<PlaneKernel::Point_2> places;
  for (const Exact::Segment_3& cut : this->Group.Cuts)
  {
    places.push_back(this->Plane.Flat(cut.source()));
    places.push_back(this->Plane.Flat(cut.target()));
  }
  const std::vector<Vertex> vertices = InsertExactPoints(places, this->Triangulation);
  std::unordered_map<Vertex, int> numbers;
  std::unordered_set<Edge, EdgeHash> known;
  for (std::size_t i = 0; i < vertices.size(); i += 2)
  {
    const auto numberOf = [&](const Vertex& vertex)
    { return numbers.try_emplace(vertex, static_cast<int>(numbers.size())).first->second; };
    const Edge edge = Undirected(numberOf(vertices[i]), numberOf(vertices[i + 1]));
    if (edge.first != edge.second && known.insert(edge).second)
    {
      this->Triangulation.insert_constraint(vertices[i], vertices[i + 1]);
    }
  }
}

/** And lets vertices have the numbers that their points have in the result. */
void Arrangement::AppendPoints(ResolvedMesh& result)
{
  for (const Vertex vertex : this->Triangulation.finite_vertex_handles())
  {
    int& value = vertex->info().Value;
    if (value >= 0)
    {
      value = this->Corners[value];
      continue;
    }
    value = static_cast<int>(result.Points.size());
    result.Points.push_back(this->Plane.Lift(vertex->point()));
    result.PointSources.push_back(-1);
  }
}

void Arrangement::FindBorders()
{
  std::unordered_map<Edge, std::vector<int>, EdgeHash> triangles;
  for (const int triangle : this->Group.Triangles)
  {
    const Triangle& t = this->Mesh.Facets[triangle];
    for (int i = 0; i < 3; ++i)
    {
      triangles[Undirected(t[i], t[(i + 1) % 3])].push_back(triangle);
    }
  }
  for (const auto& [edge, constraint] : this->Sides)
  {
    const std::vector<int>& of = triangles[edge];
    const auto end = this->Triangulation.vertices_in_constraint_end(constraint);
    auto vertex = this->Triangulation.vertices_in_constraint_begin(constraint);
    for (auto next = std::next(vertex); next != end; vertex = next++)
    {
      std::vector<int>& all =
        this->Borders[Undirected((*vertex)->info().Value, (*next)->info().Value)];
      all.insert(all.end(), of.begin(), of.end());
    }
  }
}

/** Across an edge some triangles end and others begin. */
std::vector<int> Arrangement::CoverBeyond(
  const Face& face, int i, const std::vector<int>& cover) const
{
  std::vector<int> beyond = cover;
  if (face->is_constrained(i))
  {
    const auto found = this->Borders.find(
      Undirected(face->vertex((i + 1) % 3)->info().Value, face->vertex((i + 2) % 3)->info().Value));
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

void Arrangement::AppendFace(
  const Face& face, const std::vector<int>& cover, ResolvedMesh& result) const
{
  const int first = cover.front();
  const CGAL::Orientation side = this->Plane.SideOf(first);
  const Triangle corners = { face->vertex(0)->info().Value, face->vertex(1)->info().Value,
    face->vertex(2)->info().Value };
  AppendFacet<3>(this->Mesh, first, side == CGAL::POSITIVE ? corners : Flipped<3>(corners), result);
  for (std::size_t k = 1; k < cover.size(); ++k)
  {
    const int sign = side == this->Plane.SideOf(cover[k]) ? 1 : -1;
    result.Windings.back() += sign * this->Mesh.Windings[cover[k]];
    result.Counts.back() += this->Mesh.Counts[cover[k]];
  }
}

/** Walks from the outside, where there is none, to all faces. */
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

void AppendPieces(const ResolvedMesh& mesh, const CoplanarGroup& group, ResolvedMesh& result)
{
  Arrangement(mesh, group).Build(result);
}
