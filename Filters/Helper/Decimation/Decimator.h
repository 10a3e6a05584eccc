// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Edge collapses that keep a mesh enclosed. Not in the paper.
 */
#ifndef carving_Decimator_h
#define carving_Decimator_h

#include "Core/Mesh/FaceDistance.h"
#include "Core/Protocol/Protocol.h"
#include "Helper/Decimation/ChainRecorder.h"
#include "Helper/Decimation/CollapseQueue.h"
#include "Helper/Decimation/CollisionSearch.h"
#include "Helper/Decimation/ErrorBound.h"
#include "Helper/Decimation/Obstacle.h"
#include "Helper/Decimation/Placement.h"
#include "Helper/Decimation/SurfaceErrors.h"
#include "Helper/Decimation/SurfaceMesh.h"

#include <functional>
#include <limits>
#include <map>
#include <unordered_map>
#include <vector>

namespace carving::helper
{

/**
 * Collapses edges of a closed surface around a mesh M, in the order of a quadric error.
 *
 * The new vertex lies on the outer side of all faces around its edge, so that the surface after the
 * collapse encloses the surface before ("progressive hull", Sander et al., "Silhouette clipping",
 * 2000). Then, unless surfaces have to be nested, it slides inward until its faces touch M. No
 * collapse changes topology or makes the surface cross itself.
 */
class Decimator
{
public:
  /**
   * `surface` encloses `obstacle`: M, and the parts of M's triangles that are divided. The tree and
   * the distances, from M and from `surface` as given, must outlive this object.
   */
  Decimator(SurfaceMesh surface, const FacetTree<3>& obstacle, const FaceDistance<3>& fromM,
    const FaceDistance<3>& fromStart, bool nested);

  /**
   * No face that a collapse makes may be farther from M from now on. Has no effect if the last
   * bound was greater. The bound is 0 at first.
   */
  void RaiseErrorBound(double bound);

  double GetErrorBound() const
  {
    return this->Bound.Get();
  }

  /**
   * Collapses edges while `goOn` returns true. Returns false if no edge can collapse any more.
   * Before that, `triesHarder` says whether positions that fit less well are worth their time.
   */
  bool Run(const std::function<bool()>& goOn, const std::function<bool()>& triesHarder);

  /**
   * Moves vertices inward until their faces touch M: the surroundings have changed since a collapse
   * has placed them. Does nothing if surfaces have to be nested, or have many vertices. Stops as
   * soon as `goOn` returns false. The next collapse takes place as if nothing had moved: collapses
   * after such moves end farther from M.
   */
  void Tighten(const std::function<bool()>& goOn);

  const SurfaceMesh& GetSurface() const
  {
    return this->Surface;
  }

  /** Whether edges also collapse into positions that fit less well. */
  bool TriesAllPositions() const
  {
    return this->UsesEnds;
  }

  int GetNumberOfCollapses() const
  {
    return this->History.GetNumberOfCollapses();
  }

  /** The collapses up to now. The decimator is of no use afterwards. */
  ChainRecorder TakeHistory() &&
  {
    return std::move(this->History);
  }

private:
  /** The shares of a way inward that are tried in turn: near its end, roundings decide. */
  static constexpr double Shares[] = { 1.0, 0.98, 0.7, 0.0 };

  /** A vertex that has been tightened since the last collapse. */
  struct Move
  {
    Point Other;    ///< its position before, or after while edges collapse
    int ChainPoint; ///< its point of the chain before
  };

  /** An attempt to collapse an edge. */
  struct Attempt
  {
    HalfEdge Edge;
    Star Around;
    LocalError Error;
    double Limit = 0.0; ///< of the cost: the least of all other edges
  };

  /** Whether the surface may shrink, and is small enough to take time for a closer fit. */
  bool FitsClosely() const
  {
    return !this->Nested && this->Surface.number_of_vertices() <= DecimationOptions::ManyVertices;
  }

  void PushBound(HalfEdge edge);
  /** Lets the next Refill push all edges, since edges may collapse now that could not before. */
  void AllowRefill()
  {
    this->VerticesAtRefill = std::numeric_limits<double>::infinity();
  }
  bool Refill();
  bool CollapseAll(const std::function<bool()>& goOn, const std::function<bool()>& triesHarder);
  void SwapMoves();
  void RecordMovesBack();
  bool KeepsTopology(HalfEdge edge) const;
  bool IsValid(const Star& star, const Point& w);
  std::vector<Point> FindOutward(const Attempt& attempt);
  void Try(HalfEdge edge);
  bool Defer(const Attempt& attempt, const Point& w);
  void CollapseOrDefer(const Attempt& attempt, const std::vector<Point>& outward,
    const Point& inward, bool isCostKnown);
  std::optional<Point> FindValid(const Attempt& attempt, const Point& start, const Point& end);
  void Collapse(const Attempt& attempt, const Point& w);
  Slide& GetSlide(SurfaceMesh::Edge_index edge, const Point& start);
  void MoveInward(Vertex vertex);
  void PushAround(Vertex vertex);

  SurfaceMesh Surface;
  ChainRecorder History;
  CollisionSearch Collisions; ///< of the surface with itself
  CollapseQueue Queue;
  Obstacle M;
  ErrorBound Bound; ///< of the distance from M
  SurfaceErrors Errors;
  Placement Place;
  bool Nested;
  double VerticesAtRefill = std::numeric_limits<double>::infinity();
  bool UsesEnds = false; ///< whether edges also collapse into their ends
  std::map<Vertex, Move> Moves;
  std::unordered_map<SurfaceMesh::size_type, Slide> Slides; ///< of edges with unchanged stars
};

} // namespace carving::helper

#endif
