// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/Decimator.h"

#include "Helper/Base/TriangleCrossing.h"
#include "Helper/Enclosing/Pierce.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>

namespace carving::helper
{
namespace
{

/**
 * At most so many vertices: the inward slide of every candidate orders the queue, which is better,
 * but slower.
 */
constexpr SurfaceMesh::size_type FewVertices = 2000;

/** At more vertices, surfaces are so close to M that measuring distances is not worth the time. */
constexpr SurfaceMesh::size_type ManyVertices = 20000;

/** Queries for the distance of a face within an error bound. */
constexpr int MostQueries = 64;

Corners3 ToInexact(const Point& a, const Point& b, const Point& c)
{
  return { helper::ToInexact(a), helper::ToInexact(b), helper::ToInexact(c) };
}

bool CrossOrCover(const Corners3& a, const Corners3& b)
{
  return TrianglesCross(a, b) || std::is_permutation(a.begin(), a.end(), b.begin());
}

} // namespace

Decimator::Decimator(
  SurfaceMesh surface, const ResolvedMesh& obstacle, const FaceDistance<3>& distance, bool nested)
  : Surface(std::move(surface))
  , History(this->Surface)
  , Tree(BoxesOf(this->Surface))
  , FacesAtBuild(this->Surface.number_of_faces())
  , M(obstacle)
  , Distance(distance)
  , Place(PointsOf(this->Surface), this->M)
  , Nested(nested)
  , CanSweepOver(!IsConnectedWithoutCopies(this->Surface))
  , Quadrics(this->Surface.num_vertices())
  , Stamps(this->Surface.num_edges(), 0)
  , IsQueued(this->Surface.num_edges(), 0)
{
  Point lower, upper;
  GetBounds(obstacle.Points, lower, upper);
  this->Origin = Between(lower, upper, 0.5);
  this->AddPlanes();
}

/** Adds the plane of each face to the quadrics of its vertices, weighted by area. */
void Decimator::AddPlanes()
{
  for (const Face face : this->Surface.faces())
  {
    const auto [a, b, c] = CornersOf(this->Surface, face);
    const Point normal = Cross(b - a, c - a);
    const double length = Length(normal);
    if (length > 0.0)
    {
      const Point n = normal / length;
      for (const Vertex v : CGAL::vertices_around_face(this->Surface.halfedge(face), this->Surface))
      {
        this->Quadrics[v].AddPlane(n, a - this->Origin, length);
      }
    }
  }
}

/** The error about the edge's midpoint. */
LocalError Decimator::ErrorOf(HalfEdge edge) const
{
  const Vertex u = this->Surface.source(edge), v = this->Surface.target(edge);
  const Point middle = Between(this->Surface.point(u), this->Surface.point(v), 0.5);
  Quadric sum = this->Quadrics[u];
  sum.Add(this->Quadrics[v]);
  return { sum.MovedTo(middle - this->Origin), middle };
}

void Decimator::Push(HalfEdge edge, double cost)
{
  const auto index = this->Surface.edge(edge);
  this->IsQueued[index] = 1;
  this->Queue.push_back({ cost, index, ++this->Stamps[index] });
  std::push_heap(this->Queue.begin(), this->Queue.end());
}

Decimator::Candidate Decimator::Pop()
{
  std::pop_heap(this->Queue.begin(), this->Queue.end());
  const Candidate top = this->Queue.back();
  this->Queue.pop_back();
  return top;
}

bool Decimator::IsCurrent(const Candidate& candidate) const
{
  return !this->Surface.is_removed(SurfaceMesh::Edge_index(candidate.Edge)) &&
    candidate.Stamp == this->Stamps[candidate.Edge];
}

/** Keeps the queue from growing beyond twice the number of edges. */
void Decimator::DropOutdated()
{
  if (this->Queue.size() > 2 * this->Surface.number_of_edges())
  {
    this->Queue.erase(std::remove_if(this->Queue.begin(), this->Queue.end(),
                        [this](const Candidate& candidate) { return !this->IsCurrent(candidate); }),
      this->Queue.end());
    std::make_heap(this->Queue.begin(), this->Queue.end());
  }
}

/** Pushes an edge with a lower bound of its cost: the least error anywhere. */
void Decimator::PushBound(HalfEdge edge)
{
  this->Ready.erase(this->Surface.edge(edge));
  const LocalError error = this->ErrorOf(edge);
  this->Push(edge, this->Place.FindLeastError(error));
}

/**
 * Pushes all edges that are not in the queue. Returns false if none has collapsed since the last
 * time.
 */
bool Decimator::Refill()
{
  if (this->VerticesAtRefill == this->Surface.number_of_vertices())
  {
    return false;
  }
  this->VerticesAtRefill = this->Surface.number_of_vertices();
  for (const auto edge : this->Surface.edges())
  {
    if (!this->IsQueued[edge])
    {
      this->PushBound(this->Surface.halfedge(edge));
    }
  }
  return true;
}

bool Decimator::Run(const std::function<bool()>& goOn)
{
  while (goOn())
  {
    while (this->Queue.empty() && !this->Refill())
    {
      if (this->UsesEnds && !this->Place.Widen())
      {
        return false;
      }
      this->UsesEnds = true;
      this->VerticesAtRefill = 0;
    }
    const Candidate next = this->Pop();
    if (this->IsCurrent(next))
    {
      this->IsQueued[next.Edge] = 0;
      this->Try(this->Surface.halfedge(SurfaceMesh::Edge_index(next.Edge)));
    }
  }
  return true;
}

/**
 * Collapses an edge, or pushes it again with a greater cost. Does neither if the edge cannot
 * collapse.
 */
void Decimator::Try(HalfEdge edge)
{
  if (!CGAL::Euler::does_satisfy_link_condition(this->Surface.edge(edge), this->Surface))
  {
    return;
  }
  const EdgeStar star(this->Surface, edge);
  const LocalError error = this->ErrorOf(edge);
  const auto ready = this->Ready.find(this->Surface.edge(edge));
  if (ready != this->Ready.end() && this->IsValid(star, ready->second) &&
    this->IsWithinErrorBound(star, ready->second))
  {
    this->Collapse(edge, star, ready->second);
    return;
  }
  const std::vector<Point> outward = this->FindOutward(edge, star, error);
  if (outward.empty())
  {
    return;
  }
  const double limit =
    this->Queue.empty() ? std::numeric_limits<double>::infinity() : this->Queue.front().Cost;
  const bool few = this->Surface.number_of_vertices() <= FewVertices;
  const Point& start = outward.front();
  Point inward = start;
  if (!this->Nested && (few || error.At(start) <= limit))
  {
    inward = this->Place.SlideInward(star, error, start, limit);
  }
  const double least = error.At(few ? inward : start);
  if (least > limit)
  {
    this->Push(edge, least);
  }
  else if (ready != this->Ready.end() || !this->Defer(edge, star, error, inward, limit))
  {
    this->CollapseOrDefer(edge, star, error, outward, inward, limit);
  }
}

/** Pushes an edge again if collapsing it into w costs more than the limit. */
bool Decimator::Defer(
  HalfEdge edge, const EdgeStar& star, const LocalError& error, const Point& w, double limit)
{
  const bool measures = !this->Nested && this->Surface.number_of_vertices() <= ManyVertices;
  const double cost = measures ? this->CostOf(star, error, w) : error.At(w);
  if (cost <= limit)
  {
    return false;
  }
  this->Push(edge, cost);
  this->Ready[this->Surface.edge(edge)] = w;
  return true;
}

/**
 * Takes the first valid position on the ways inward from outward ones. `inward` is the end of the
 * first way.
 */
void Decimator::CollapseOrDefer(HalfEdge edge, const EdgeStar& star, const LocalError& error,
  const std::vector<Point>& outward, const Point& inward, double limit)
{
  for (const Point& start : outward)
  {
    const Point end = this->Nested ? start
      : start == outward.front()   ? inward
                                   : this->Place.SlideInward(star, error, start);
    for (const double share : { 1.0, 0.98, 0.7, 0.0 })
    {
      const Point w = Between(start, end, share);
      if ((share > 0.0 && start == end) || !this->IsValid(star, w))
      {
        continue;
      }
      if (!this->IsWithinErrorBound(star, w))
      {
        break;
      }
      if (w == inward || !this->Defer(edge, star, error, w, limit))
      {
        this->Collapse(edge, star, w);
      }
      return;
    }
  }
}

/**
 * The quadric error, or the squared distance of the new faces from M times their area if that is
 * greater. Quadrics know planes only: where parts of M end, or a gap is bridged, a vertex on all
 * planes can be far from M.
 */
double Decimator::CostOf(const EdgeStar& star, const LocalError& error, const Point& w) const
{
  double farthest = this->Distance.OfPoint(w), twiceArea = 0.0;
  for (const auto& [a, b] : star.Link)
  {
    farthest = std::max(farthest, this->Distance.OfPoint((a + b + w) / 3.0));
    twiceArea += Length(Cross(b - a, w - a));
  }
  return std::max(error.At(w), twiceArea * farthest * farthest);
}

/**
 * Outward positions, best first. Ends of edges are tried only once nothing else helps: the other
 * positions fit better, but may turn faces over in flat regions.
 */
std::vector<Point> Decimator::FindOutward(
  HalfEdge edge, const EdgeStar& star, const LocalError& error)
{
  std::vector<Point> positions;
  if (const std::optional<Point> w = this->Place.FindOutward(star, error))
  {
    positions.push_back(*w);
  }
  for (const Vertex end : { this->Surface.source(edge), this->Surface.target(edge) })
  {
    if (this->UsesEnds && IsOutside(star, this->Surface.point(end)))
    {
      positions.push_back(this->Surface.point(end));
    }
  }
  std::stable_sort(positions.begin(), positions.end(),
    [&](const Point& a, const Point& b) { return error.At(a) < error.At(b); });
  return positions;
}

/** Whether M stays enclosed, and the surface does not cross itself. Exact. */
bool Decimator::IsValid(const EdgeStar& star, const Point& w) const
{
  std::vector<std::array<Point, 3>> passed; // faces that w is behind
  for (const auto& corners : star.Corners)
  {
    const auto [a, b, c] = ToInexact(corners[0], corners[1], corners[2]);
    if (CGAL::orientation(a, b, c, helper::ToInexact(w)) == CGAL::NEGATIVE)
    {
      passed.push_back(corners);
    }
  }
  return this->M.AllowsRemoval(passed, w) && this->IsFree(star, w);
}

/**
 * Whether the surface may become one with its faces around w: it does not cross itself, and does
 * not sweep over a part of itself, which would then be on the wrong side without crossing anything:
 * a component or void, or a part that is joined in a copy of a point. A connected surface without
 * copies has no such part.
 */
bool Decimator::IsFree(const EdgeStar& star, const Point& w) const
{
  return !this->Crosses(star, w) && !(this->CanSweepOver && this->SweepsOver(star, w));
}

bool Decimator::SweepsOver(const EdgeStar& star, const Point& w) const
{
  bool sweeps = false;
  for (const auto& [a, b, c] : star.Corners)
  {
    Corners4 swept = { helper::ToInexact(a), helper::ToInexact(b), helper::ToInexact(c),
      helper::ToInexact(w) };
    const auto side = CGAL::orientation(swept[0], swept[1], swept[2], swept[3]);
    if (side == CGAL::NEGATIVE)
    {
      std::swap(swept[0], swept[1]);
    }
    this->Tree.ForEachOverlap(Box({ a, b, c, w }),
      [&](int index)
      {
        const Face face(index);
        if (!sweeps && side != CGAL::COPLANAR &&
          std::find(star.Faces.begin(), star.Faces.end(), face) == star.Faces.end())
        {
          const auto [p, q, r] = CornersOf(this->Surface, face);
          sweeps = Piercer(ToInexact(p, q, r)).FindContact(swept).Exists();
        }
      });
  }
  return sweeps;
}

/**
 * Whether the new faces around w have no area, or cross or cover each other or the remaining faces.
 * Exact. Faces cover each other if they have the same corners, in any order.
 */
bool Decimator::Crosses(const EdgeStar& star, const Point& w) const
{
  std::vector<Corners3> fan;
  for (const auto& [a, b] : star.Link)
  {
    fan.push_back(ToInexact(a, b, w));
    if (CGAL::collinear(fan.back()[0], fan.back()[1], fan.back()[2]))
    {
      return true;
    }
    for (std::size_t i = 0; i + 1 < fan.size(); ++i)
    {
      if (CrossOrCover(fan.back(), fan[i]))
      {
        return true;
      }
    }
  }
  bool crosses = false;
  for (std::size_t i = 0; i < fan.size() && !crosses; ++i)
  {
    this->Tree.ForEachOverlap(Box({ star.Link[i][0], star.Link[i][1], w }),
      [&](int index)
      {
        const Face face(index);
        if (!crosses && std::find(star.Faces.begin(), star.Faces.end(), face) == star.Faces.end())
        {
          const auto [a, b, c] = CornersOf(this->Surface, face);
          crosses = CrossOrCover(fan[i], ToInexact(a, b, c));
        }
      });
  }
  return crosses;
}

bool Decimator::IsWithinErrorBound(const EdgeStar& star, const Point& w) const
{
  return this->ErrorBound == std::numeric_limits<double>::infinity() ||
    std::all_of(star.Link.begin(), star.Link.end(),
      [&](const std::array<Point, 2>& edge)
      {
        return this->Distance.Compute({ edge[0], edge[1], w }, MostQueries, this->ErrorBound)
                 .Upper <= this->ErrorBound;
      });
}

void Decimator::Collapse(HalfEdge edge, const EdgeStar& star, const Point& w)
{
  const Vertex u = this->Surface.source(edge), v = this->Surface.target(edge);
  Quadric quadric = this->Quadrics[u];
  quadric.Add(this->Quadrics[v]);
  const Vertex vertex = CGAL::Euler::collapse_edge(this->Surface.edge(edge), this->Surface);
  this->Surface.point(vertex) = w;
  this->History.Add(this->Surface, vertex, vertex == u ? v : u, star.Faces);
  this->Quadrics[vertex] = quadric;
  for (std::size_t i = 0; i < star.Faces.size(); ++i)
  {
    const bool remains = i < star.Link.size();
    this->Tree.Update(static_cast<int>(star.Faces[i]),
      remains ? Box({ star.Link[i][0], star.Link[i][1], w }) : Box());
  }
  this->PushAround(vertex);
  if (2 * this->Surface.number_of_faces() < this->FacesAtBuild)
  {
    this->Tree = BoxTree(BoxesOf(this->Surface));
    this->FacesAtBuild = this->Surface.number_of_faces();
  }
}

/** Pushes the edges whose errors or stars have changed, with their lower bounds. */
void Decimator::PushAround(Vertex vertex)
{
  const HalfEdge first = this->Surface.halfedge(vertex);
  for (const HalfEdge spoke : CGAL::halfedges_around_target(first, this->Surface))
  {
    this->PushBound(spoke);
    const HalfEdge back = this->Surface.opposite(spoke);
    for (const HalfEdge edge : CGAL::halfedges_around_target(back, this->Surface))
    {
      if (edge != back)
      {
        this->PushBound(edge);
      }
    }
  }
  this->DropOutdated();
}

} // namespace carving::helper
