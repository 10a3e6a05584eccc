// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The edges of a surface in the order of what their collapses cost.
 */
#ifndef carving_CollapseQueue_h
#define carving_CollapseQueue_h

#include "Helper/Decimation/SurfaceMesh.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace carving::helper
{

class CollapseQueue
{
public:
  using Edge = SurfaceMesh::Edge_index;

  /** `surface` must outlive this object. No edge is in the queue at first. */
  explicit CollapseQueue(const SurfaceMesh& surface);

  /** Adds an edge, or changes its cost. `position` is where it is known to collapse. */
  void Push(Edge edge, double cost, const std::optional<Point>& position = std::nullopt);

  /** An edge of least cost, which leaves the queue. Edges that have been removed are left out. */
  std::optional<Edge> Pop();

  /** The least cost of an edge in the queue; infinite if there is none. */
  double GetLeastCost();

  bool Contains(Edge edge) const
  {
    return this->IsQueued[edge];
  }

  /** The position that an edge was last pushed with. */
  std::optional<Point> GetPosition(Edge edge) const;

  /** Forgets this position, whose surroundings have changed. */
  void DropPosition(Edge edge)
  {
    this->Positions.erase(edge);
  }

private:
  struct Candidate
  {
    double Cost;
    SurfaceMesh::size_type Index;
    unsigned int Stamp; ///< of the edge; older candidates are out of date

    bool operator<(const Candidate& other) const
    {
      return this->Cost != other.Cost ? this->Cost > other.Cost : this->Index > other.Index;
    }
  };

  bool IsCurrent(const Candidate& candidate) const;
  void PopCandidate();
  void DropOutdatedTop();
  void DropOutdated();

  const SurfaceMesh& Surface;
  std::vector<Candidate> Heap;
  std::vector<unsigned int> Stamps; ///< per edge: of its last candidate
  std::vector<char> IsQueued;       ///< per edge: whether this candidate is in the queue
  std::unordered_map<SurfaceMesh::size_type, Point> Positions;
};

} // namespace carving::helper

#endif
