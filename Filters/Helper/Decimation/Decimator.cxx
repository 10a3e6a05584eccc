// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/Decimator.h"

#include "Core/Protocol/Protocol.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carving::helper
{
namespace
{

/**
 * At most so many vertices: the inward slide of every candidate orders the queue, which is better,
 * but slower.
 */
constexpr SurfaceMesh::size_type MostToSlideFirst = 2000;

/** Queries for the distance of a face within an error bound. */
constexpr int MostQueries = 64;

/** The shares of a way inward that are tried in turn: near its end, roundings decide. */
constexpr double Shares[] = { 1.0, 0.98, 0.7, 0.0 };

} // namespace

Decimator::Decimator(
  SurfaceMesh surface, const FaceDistance<3>& fromM, const FaceDistance<3>& fromStart, bool nested)
  : Surface(std::move(surface))
  , History(this->Surface)
  , Collisions(this->Surface)
  , Queue(this->Surface)
  , M(fromM.GetTree())
  , FromM(fromM)
  , Errors(this->Surface, fromStart)
  , Place(PointsOf(this->Surface), this->M)
  , Nested(nested)
{
}

void Decimator::RaiseErrorBound(double bound)
{
  if (bound > this->ErrorBound)
  {
    this->ErrorBound = bound;
    this->AllowRefill();
  }
}

/** Pushes an edge with a lower bound of its cost: the least error anywhere. */
void Decimator::PushBound(HalfEdge edge)
{
  this->Queue.Push(this->Surface.edge(edge), Placement::FindLeastError(this->Errors.OfEdge(edge)));
}

/**
 * Pushes all edges that are not in the queue. Returns false if hardly any has collapsed since the
 * last time.
 */
bool Decimator::Refill()
{
  constexpr double hardlyAny = 0.01; // vertices that have gone, per vertex
  const double count = this->Surface.number_of_vertices();
  if (this->VerticesAtRefill - count <= hardlyAny * count)
  {
    return false;
  }
  this->VerticesAtRefill = count;
  for (const auto edge : this->Surface.edges())
  {
    if (!this->Queue.Contains(edge))
    {
      this->PushBound(this->Surface.halfedge(edge));
    }
  }
  return true;
}

bool Decimator::Run(const std::function<bool()>& goOn, const std::function<bool()>& triesHarder)
{
  this->SwapMoves();
  const bool mayCollapse = this->CollapseAll(goOn, triesHarder);
  this->SwapMoves(); // there are none if an edge has collapsed
  return mayCollapse;
}

/** Moves the tightened vertices back, or forth again. */
void Decimator::SwapMoves()
{
  for (auto& [vertex, move] : this->Moves)
  {
    std::swap(this->Surface.point(vertex), move.Other);
    this->Collisions.Update(Star(this->Surface, vertex));
    this->PushAround(vertex);
  }
}

/** Records that the tightened vertices are back. Then they count as not tightened. */
void Decimator::RecordMovesBack()
{
  for (const auto& [vertex, move] : this->Moves)
  {
    this->History.AddMoveBack(
      this->Surface, vertex, move.ChainPoint, Star(this->Surface, vertex).Faces);
  }
  this->Moves.clear();
}

/** See Run. */
bool Decimator::CollapseAll(
  const std::function<bool()>& goOn, const std::function<bool()>& triesHarder)
{
  while (goOn())
  {
    std::optional<CollapseQueue::Edge> next = this->Queue.Pop();
    while (!next)
    {
      // A pass over all edges is due after a new bound. Later passes find little.
      if (!std::isinf(this->VerticesAtRefill) && !triesHarder())
      {
        return false;
      }
      if (!this->Refill())
      {
        if (this->UsesEnds &&
          !this->Place.Widen(this->Surface.number_of_vertices(), this->ErrorBound))
        {
          return false;
        }
        this->UsesEnds = true;
        this->AllowRefill();
      }
      next = this->Queue.Pop();
    }
    this->Try(this->Surface.halfedge(*next));
  }
  return true;
}

/**
 * Collapses an edge, or pushes it again with a greater cost. Does neither if the edge cannot
 * collapse.
 */
void Decimator::Try(HalfEdge edge)
{
  const Star star(this->Surface, edge);
  if (star.Link.empty())
  {
    return; // an edge of a facet with two sides
  }
  const LocalError error = this->Errors.OfEdge(edge);
  const std::optional<Point> known = this->Queue.GetPosition(this->Surface.edge(edge));
  if (known && this->KeepsTopology(edge) && this->IsValid(star, *known) &&
    this->IsWithinErrorBound(star, *known))
  {
    this->Collapse(edge, star, *known);
    return;
  }
  const std::vector<Point> outward = this->FindOutward(edge, star, error);
  if (outward.empty())
  {
    return;
  }
  const double limit = this->Queue.GetLeastCost();
  const bool few = this->Surface.number_of_vertices() <= MostToSlideFirst;
  const Point& start = outward.front();
  Point inward = start;
  if (!this->Nested && (few || error.At(start) <= limit))
  {
    inward = this->Place.SlideInward(star, error, start, limit);
  }
  const double least = error.At(few ? inward : start);
  if (least > limit)
  {
    this->Queue.Push(this->Surface.edge(edge), least);
  }
  else if (this->KeepsTopology(edge) && (known || !this->Defer(edge, star, error, inward, limit)))
  {
    this->CollapseOrDefer(edge, star, error, outward, inward, limit);
  }
}

/** Pushes an edge again if collapsing it into w costs more than the limit. */
bool Decimator::Defer(
  HalfEdge edge, const Star& star, const LocalError& error, const Point& w, double limit)
{
  const bool measures =
    !this->Nested && this->Surface.number_of_vertices() <= DecimationOptions::ManyVertices;
  const double cost = measures ? this->Errors.CostOf(star, error, w) : error.At(w);
  if (cost <= limit)
  {
    return false;
  }
  this->Queue.Push(this->Surface.edge(edge), cost, w);
  return true;
}

/**
 * Takes the first valid position on the ways inward from outward ones. `inward` is the end of the
 * first way.
 */
void Decimator::CollapseOrDefer(HalfEdge edge, const Star& star, const LocalError& error,
  const std::vector<Point>& outward, const Point& inward, double limit)
{
  for (const Point& start : outward)
  {
    const Point end = this->Nested ? start
      : start == outward.front()   ? inward
                                   : this->Place.SlideInward(star, error, start);
    for (const double share : Shares)
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
 * Outward positions, best first. Ends of edges are tried only once nothing else helps: the other
 * positions fit better, but may turn faces over in flat regions.
 */
std::vector<Point> Decimator::FindOutward(HalfEdge edge, const Star& star, const LocalError& error)
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

bool Decimator::KeepsTopology(HalfEdge edge) const
{
  return CGAL::Euler::does_satisfy_link_condition(this->Surface.edge(edge), this->Surface);
}

/** Whether M stays enclosed, and the surface does not cross itself. Exact. */
bool Decimator::IsValid(const Star& star, const Point& w)
{
  return this->M.StaysEnclosed(star, w) && this->Collisions.IsFree(star, w);
}

bool Decimator::IsWithinErrorBound(const Star& star, const Point& w) const
{
  return this->ErrorBound == std::numeric_limits<double>::infinity() ||
    (this->FromM.OfPoint(w) <= this->ErrorBound &&
      std::all_of(star.Link.begin(), star.Link.end(),
        [&](const std::array<Point, 2>& edge) {
          return this->FromM.IsWithin({ edge[0], edge[1], w }, this->ErrorBound, MostQueries);
        }));
}

void Decimator::Collapse(HalfEdge edge, const Star& star, const Point& w)
{
  this->RecordMovesBack();
  const Vertex u = this->Surface.source(edge), v = this->Surface.target(edge);
  const Vertex vertex = CGAL::Euler::collapse_edge(this->Surface.edge(edge), this->Surface);
  const Vertex removed = vertex == u ? v : u;
  this->Surface.point(vertex) = w;
  this->History.AddCollapse(this->Surface, vertex, removed, star.Faces);
  this->Errors.Merge(vertex, removed);
  this->Collisions.Update(star);
  this->PushAround(vertex);
}

void Decimator::Tighten(const std::function<bool()>& goOn)
{
  if (this->Nested || this->Surface.number_of_vertices() > DecimationOptions::ManyVertices)
  {
    return;
  }
  for (const Vertex vertex : this->Surface.vertices())
  {
    if (!goOn())
    {
      return;
    }
    this->MoveInward(vertex);
  }
}

/** Moves a vertex where its cost is less. */
void Decimator::MoveInward(Vertex vertex)
{
  const Point from = this->Surface.point(vertex);
  const Star star(this->Surface, vertex);
  const LocalError error = this->Errors.OfVertex(vertex);
  const Point end = this->Place.SlideInward(star, error, from);
  const double cost = this->Errors.CostOf(star, error, from);
  for (const double share : Shares)
  {
    const Point w = Between(from, end, share);
    if (w == from || this->Errors.CostOf(star, error, w) >= cost)
    {
      return;
    }
    if (this->IsValid(star, w) && this->IsWithinErrorBound(star, w))
    {
      this->Moves.try_emplace(vertex, Move{ from, this->History.GetPoint(vertex) });
      this->Surface.point(vertex) = w;
      this->History.AddMove(this->Surface, vertex, star.Faces);
      this->Collisions.Update(star);
      return;
    }
  }
}

/**
 * Pushes the edges whose errors have changed, and those that may collapse now that could not
 * before, with their lower bounds. Of edges whose stars have changed alone, the costs remain as
 * estimates.
 */
void Decimator::PushAround(Vertex vertex)
{
  const HalfEdge first = this->Surface.halfedge(vertex);
  for (const HalfEdge spoke : CGAL::halfedges_around_target(first, this->Surface))
  {
    this->PushBound(spoke);
    const HalfEdge back = this->Surface.opposite(spoke);
    for (const HalfEdge edge : CGAL::halfedges_around_target(back, this->Surface))
    {
      if (edge == back)
      {
        continue;
      }
      if (this->Queue.Contains(this->Surface.edge(edge)))
      {
        this->Queue.DropPosition(this->Surface.edge(edge));
      }
      else
      {
        this->PushBound(edge);
      }
    }
  }
}

} // namespace carving::helper
