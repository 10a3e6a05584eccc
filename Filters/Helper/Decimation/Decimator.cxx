// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/Decimator.h"

#include "Core/Mesh/Vector.h"

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

/** A position that is a little farther outward. */
Point Raised(const Star& star, const Point& w)
{
  constexpr double share = 0.01; // of the size of the star
  const Point normal = star.SumNormals();
  const double length = Length(normal);
  return length > 0.0 ? w + share / std::sqrt(length) * normal : w;
}

} // namespace

Decimator::Decimator(SurfaceMesh surface, const FacetTree<3>& obstacle,
  const FaceDistance<3>& fromM, const FaceDistance<3>& fromStart, bool nested)
  : Surface(std::move(surface))
  , History(this->Surface)
  , Collisions(this->Surface)
  , Queue(this->Surface)
  , M(obstacle)
  , Bound(fromM, this->Surface.num_edges())
  , Errors(this->Surface, fromStart)
  , Place(PointsOf(this->Surface), this->M)
  , Nested(nested)
{
}

void Decimator::RaiseErrorBound(double bound)
{
  if (this->Bound.Raise(bound))
  {
    this->AllowRefill();
  }
}

/** Pushes an edge with a lower bound of its cost: the least error anywhere. */
void Decimator::PushBound(HalfEdge edge)
{
  this->Queue.Push(this->Surface.edge(edge), Placement::FindLeastError(this->Errors.OfEdge(edge)));
}

/**
 * Pushes all edges that are not in the queue and may collapse. Returns false if hardly any has
 * collapsed since the last time.
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
    if (!this->Queue.Contains(edge) && this->Bound.MayAllow(edge))
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
        if (!this->UsesEnds)
        {
          this->UsesEnds = true;
          this->Bound.ForgetAll();
        }
        else if (this->Place.Widen(this->Surface.number_of_vertices(), this->Bound.Get()))
        {
          this->Slides.clear(); // they depend on how far positions may be
        }
        else
        {
          return false;
        }
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
  Attempt attempt = { edge, Star(this->Surface, edge), this->Errors.OfEdge(edge) };
  if (attempt.Around.Link.empty())
  {
    return; // an edge of a facet with two sides
  }
  const std::optional<Point> known = this->Queue.GetPosition(this->Surface.edge(edge));
  // Known positions are within the error bound, which only rises.
  if (known && this->KeepsTopology(edge) && this->IsValid(attempt.Around, *known))
  {
    this->Collapse(attempt, *known);
    return;
  }
  const std::vector<Point> outward = this->FindOutward(attempt);
  if (outward.empty())
  {
    return;
  }
  attempt.Limit = this->Queue.GetLeastCost();
  const bool few = this->Surface.number_of_vertices() <= MostToSlideFirst;
  const Point& start = outward.front();
  Point inward = start;
  if (!this->Nested && (few || attempt.Error.At(start) <= attempt.Limit))
  {
    Slide fresh(start);
    Slide& slide = few ? this->GetSlide(this->Surface.edge(edge), start) : fresh;
    inward = this->Place.SlideInward(attempt.Around, attempt.Error, slide, attempt.Limit);
  }
  const double least = attempt.Error.At(few ? inward : start);
  if (least > attempt.Limit)
  {
    this->Queue.Push(this->Surface.edge(edge), least);
  }
  else if (this->KeepsTopology(edge))
  {
    this->CollapseOrDefer(attempt, outward, inward, known.has_value());
  }
}

/** The slide from an outward position, as far as earlier attempts have followed it. */
Slide& Decimator::GetSlide(SurfaceMesh::Edge_index edge, const Point& start)
{
  Slide& slide = this->Slides.try_emplace(edge, start).first->second;
  if (slide.Start != start)
  {
    slide = Slide(start);
  }
  return slide;
}

/** Pushes an edge again if collapsing it into w costs more than the limit. */
bool Decimator::Defer(const Attempt& attempt, const Point& w)
{
  const double cost = this->FitsClosely() ? this->Errors.CostOf(attempt.Around, attempt.Error, w)
                                          : attempt.Error.At(w);
  if (cost <= attempt.Limit)
  {
    return false;
  }
  this->Queue.Push(this->Surface.edge(attempt.Edge), cost, w);
  return true;
}

/**
 * Takes the first valid position on the ways inward from outward ones. `inward` is the end of the
 * first way, whose cost may be known not to exceed the limit.
 */
void Decimator::CollapseOrDefer(
  const Attempt& attempt, const std::vector<Point>& outward, const Point& inward, bool isCostKnown)
{
  const SurfaceMesh::Edge_index edge = this->Surface.edge(attempt.Edge);
  this->Bound.Forget(edge);
  for (const Point& start : outward)
  {
    const bool isFirst = start == outward.front();
    const Point end = isFirst ? inward
      : this->Nested          ? start
                              : this->Place.SlideInward(attempt.Around, attempt.Error, start);
    if (!this->Bound.Allows(edge, attempt.Around, end))
    {
      continue;
    }
    if (isFirst && !isCostKnown && this->Defer(attempt, inward))
    {
      return;
    }
    if (const std::optional<Point> w = this->FindValid(attempt, start, end))
    {
      if (*w == inward || !this->Defer(attempt, *w))
      {
        this->Collapse(attempt, *w);
      }
      return;
    }
  }
}

/**
 * The first valid position on the way from `end` to `start` that is within the error bound. `end`
 * has to be within the bound.
 */
std::optional<Point> Decimator::FindValid(
  const Attempt& attempt, const Point& start, const Point& end)
{
  for (const double share : Shares)
  {
    const Point w = Between(start, end, share);
    if (share > 0.0 && start == end)
    {
      continue;
    }
    if (w != end && !this->Bound.Allows(this->Surface.edge(attempt.Edge), attempt.Around, w))
    {
      break; // positions outward are farther
    }
    if (this->IsValid(attempt.Around, w))
    {
      return w;
    }
  }
  return std::nullopt;
}

/**
 * Outward positions, best first. Ends of edges are tried only once nothing else helps: the other
 * positions fit better, but may turn faces over in flat regions.
 */
std::vector<Point> Decimator::FindOutward(const Attempt& attempt)
{
  const auto& [edge, star, error, limit] = attempt;
  std::vector<Point> positions;
  if (const std::optional<Point> w = this->Place.FindOutward(star, error))
  {
    positions.push_back(*w);
    if (this->Collisions.MayCoverSheet(star))
    {
      // In a flat sheet, faces at the first position cover those of the other side.
      const Point raised = Raised(star, *w);
      if (IsOutside(star, raised))
      {
        positions.push_back(raised);
      }
    }
  }
  const bool mayShrink = positions.empty() && !this->Nested && this->KeepsTopology(edge);
  for (const Vertex end : { this->Surface.source(edge), this->Surface.target(edge) })
  {
    const Point& p = this->Surface.point(end);
    if (IsOutside(star, p) ? this->UsesEnds : mayShrink && this->IsValid(star, p))
    {
      positions.push_back(p);
    }
  }
  std::stable_sort(positions.begin(), positions.end(),
    [&attempt](const Point& a, const Point& b)
    { return attempt.Error.At(a) < attempt.Error.At(b); });
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

void Decimator::Collapse(const Attempt& attempt, const Point& w)
{
  const HalfEdge edge = attempt.Edge;
  this->RecordMovesBack();
  const Vertex u = this->Surface.source(edge), v = this->Surface.target(edge);
  const Vertex vertex = CGAL::Euler::collapse_edge(this->Surface.edge(edge), this->Surface);
  const Vertex removed = vertex == u ? v : u;
  this->Surface.point(vertex) = w;
  this->History.AddCollapse(this->Surface, vertex, removed, attempt.Around.Faces);
  this->Errors.Merge(vertex, removed);
  this->Collisions.Update(attempt.Around);
  this->PushAround(vertex);
}

/**
 * Pushes the edges whose errors have changed, and those that may collapse now that could not
 * before, with their lower bounds. Of edges whose stars have changed alone, the costs remain as
 * estimates. The slides of all these edges start anew.
 */
void Decimator::PushAround(Vertex vertex)
{
  const HalfEdge first = this->Surface.halfedge(vertex);
  for (const HalfEdge spoke : CGAL::halfedges_around_target(first, this->Surface))
  {
    this->PushBound(spoke);
    this->Slides.erase(this->Surface.edge(spoke));
    const HalfEdge back = this->Surface.opposite(spoke);
    for (const HalfEdge edge : CGAL::halfedges_around_target(back, this->Surface))
    {
      if (edge == back)
      {
        continue;
      }
      this->Slides.erase(this->Surface.edge(edge));
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
