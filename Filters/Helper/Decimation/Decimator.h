// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Edge collapses that keep a mesh enclosed. Not in the paper.
 */
#ifndef carving_Decimator_h
#define carving_Decimator_h

#include "Core/Mesh/FaceDistance.h"
#include "Helper/Decimation/BoxTree.h"
#include "Helper/Decimation/ChainRecorder.h"
#include "Helper/Decimation/Obstacle.h"
#include "Helper/Decimation/Placement.h"
#include "Helper/Decimation/Quadric.h"
#include "Helper/Decimation/SurfaceMesh.h"

#include <functional>
#include <limits>
#include <optional>
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
   * `obstacle` is M, which `surface` encloses. This and `distance`, from M, must outlive this
   * object.
   */
  Decimator(SurfaceMesh surface, const ResolvedMesh& obstacle, const FaceDistance<3>& distance,
    bool nested);

  /** No face that a collapse makes may be farther from M. Bounds may only rise. */
  void SetErrorBound(double bound)
  {
    this->ErrorBound = bound;
    this->VerticesAtRefill = 0; // edges may collapse now that could not before
  }

  /** Collapses edges while `goOn` returns true. Returns false if no edge can collapse any more. */
  bool Run(const std::function<bool()>& goOn);

  const SurfaceMesh& GetSurface() const
  {
    return this->Surface;
  }

  /** The collapses up to now. */
  const ChainRecorder& GetHistory() const
  {
    return this->History;
  }

private:
  struct Candidate
  {
    double Cost;
    SurfaceMesh::size_type Edge;
    unsigned int Stamp; ///< of the edge; older candidates are out of date

    bool operator<(const Candidate& other) const
    {
      return this->Cost != other.Cost ? this->Cost > other.Cost : this->Edge > other.Edge;
    }
  };

  void AddPlanes();
  LocalError ErrorOf(HalfEdge edge) const;
  void Push(HalfEdge edge, double cost);
  void PushBound(HalfEdge edge);
  Candidate Pop();
  bool IsCurrent(const Candidate& candidate) const;
  void DropOutdated();
  bool Refill();
  bool IsWithinErrorBound(const EdgeStar& star, const Point& w) const;
  bool IsValid(const EdgeStar& star, const Point& w) const;
  bool IsFree(const EdgeStar& star, const Point& w) const;
  bool Crosses(const EdgeStar& star, const Point& w) const;
  bool SweepsOver(const EdgeStar& star, const Point& w) const;
  std::vector<Point> FindOutward(HalfEdge edge, const EdgeStar& star, const LocalError& error);
  void Try(HalfEdge edge);
  double CostOf(const EdgeStar& star, const LocalError& error, const Point& w) const;
  bool Defer(
    HalfEdge edge, const EdgeStar& star, const LocalError& error, const Point& w, double limit);
  void CollapseOrDefer(HalfEdge edge, const EdgeStar& star, const LocalError& error,
    const std::vector<Point>& outward, const Point& inward, double limit);
  void Collapse(HalfEdge edge, const EdgeStar& star, const Point& w);
  void PushAround(Vertex vertex);

  SurfaceMesh Surface;
  ChainRecorder History;
  BoxTree Tree; ///< of the surface's faces
  SurfaceMesh::size_type FacesAtBuild;
  Obstacle M;
  const FaceDistance<3>& Distance; ///< from M
  Placement Place;
  bool Nested;
  bool CanSweepOver; ///< over a part of itself, without crossing it
  double ErrorBound = std::numeric_limits<double>::infinity();
  Point Origin;                     ///< of the quadrics
  std::vector<Quadric> Quadrics;    ///< per vertex: the planes of the faces that it stands for
  std::vector<Candidate> Queue;     ///< a heap
  std::vector<unsigned int> Stamps; ///< per edge: of its last candidate
  /** Per edge in the queue with its final cost: where it collapses if that is valid then. */
  std::unordered_map<SurfaceMesh::size_type, Point> Ready;
  std::vector<char> IsQueued; ///< per edge: whether this candidate is in the queue
  SurfaceMesh::size_type VerticesAtRefill = 0;
  bool UsesEnds = false; ///< whether edges also collapse into their ends
};

} // namespace carving::helper

#endif
