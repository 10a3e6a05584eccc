// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/CoplanarGroup.h"

#include "Core/Mesh/Vector.h"
#include "Helper/Plane/ResolveContours.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cmath>
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

  PlaneKernel::Point_2 Flat(const ExactPoint& p) const
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
      const Point& p = this->Mesh.Points[point];
      return Inexact::Point_2(p[this->U()], p[this->V()]);
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

using Edge = std::pair<int, int>;

using EdgeHash = boost::hash<Edge>;

Edge Undirected(int a, int b)
{
  return std::minmax(a, b);
}

class Arrangement
{
public:
  Arrangement(const ResolvedMesh& mesh, const CutPoints& cutPoints, const CoplanarGroup& group)
    : Mesh(mesh)
    , Cuts(cutPoints)
    , Group(group)
    , Plane(mesh, group.Triangles.front())
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
  Projection Plane;
  PlaneTriangulation Triangulation;
  std::unordered_map<int, Vertex> Vertices; ///< by the numbers of points
  std::vector<std::pair<int, PlaneTriangulation::Constraint_id>> Sides; ///< with their triangles
  /** By vertices: the triangles of whose borders an edge is. */
  std::unordered_map<Edge, std::vector<int>, EdgeHash> Borders;
};

void Arrangement::InsertPoints()
{
  std::vector<int> points;
  for (const int triangle : this->Group.Triangles)
  {
    const Triangle& t = this->Mesh.Facets[triangle];
    points.insert(points.end(), t.begin(), t.end());
  }
  for (const auto& cut : this->Group.Cuts)
  {
    points.insert(points.end(), cut.begin(), cut.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<PlaneKernel::Point_2> places;
  for (const int point : points)
  {
    places.push_back(this->Plane.Flat(this->Cuts.Get(point)));
  }
  const std::vector<Vertex> vertices = InsertInOrder(places, this->Triangulation);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    // Of points at one place the first counts.
    PointIndex& index = vertices[i]->info();
    index.Value = index.Value < 0 ? points[i] : index.Value;
    this->Vertices[points[i]] = vertices[i];
  }
}

void Arrangement::InsertSegments()
{
  std::vector<std::pair<Edge, int>> sides;
  for (const int triangle : this->Group.Triangles)
  {
    const Triangle& t = this->Mesh.Facets[triangle];
    for (int i = 0; i < 3; ++i)
    {
      sides.emplace_back(Undirected(t[i], t[(i + 1) % 3]), triangle);
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const auto& [edge, triangle] = sides[i];
    const bool known = i > 0 && sides[i - 1].first == edge;
    this->Sides.emplace_back(triangle,
      known ? this->Sides.back().second
            : this->Triangulation.insert_constraint(
                this->Vertices[edge.first], this->Vertices[edge.second]));
  }
  std::unordered_set<Edge, EdgeHash> known;
  for (const auto& [from, to] : this->Group.Cuts)
  {
    const Vertex a = this->Vertices[from], b = this->Vertices[to];
    if (a != b && known.insert(Undirected(a->info().Value, b->info().Value)).second)
    {
      this->Triangulation.insert_constraint(a, b);
    }
  }
}

/** Where sides and cuts cross. */
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
      this->Borders[Undirected((*vertex)->info().Value, (*next)->info().Value)].push_back(triangle);
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
    result.SignedMultiplicities.back() += sign * this->Mesh.SignedMultiplicities[cover[k]];
    result.Multiplicities.back() += this->Mesh.Multiplicities[cover[k]];
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

void AppendPieces(const ResolvedMesh& mesh, const CutPoints& cutPoints, const CoplanarGroup& group,
  ResolvedMesh& result)
{
  Arrangement(mesh, cutPoints, group).Build(result);
}
