// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether what is not carved still hangs together without one more cell.
 */
#ifndef carving_Connectivity_h
#define carving_Connectivity_h

#include "Core/Budget/RemainingCells.h"
#include "Core/Mesh/Mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace carving
{

/**
 * Connectivity of K, the closed complex of M, the solid and all cells that are not carved, while cells
 * are taken away.
 *
 * What stays for good hangs together for good: each of its components is one node, and so is every
 * other vertex. There is an edge between two nodes while a cell with corners of both is left. A question is answered by
 * searches from all sides in lockstep, which end when only one is left: a part that falls off costs as
 * much as the smaller side, O(n log n) for a whole carving; parts that are still joined cost as much as
 * the way from one to the other.
 */
template <int D>
class Connectivity
{
public:
  /** A label per corner of a cell; equal for corners that are in one piece, -1 for those that are in none. */
  using Labels = std::array<int, D + 1>;

  /** Follows the states of the cells; all must outlive this object. */
  Connectivity(const Decomposition<D>& mesh, const std::vector<CellState>& states);

  /**
   * `labels` says which corners of the cell the rest of its boundary joins. Merges the labels of those
   * that the rest of K joins and returns the number of labels that remain.
   */
  int JoinAround(int cell, Labels& labels);

  /** How many components K has. */
  int CountComponents();

  /**
   * The cell stays although K would fall apart into these components without it. They can only be joined
   * through it, for as long as it stays; no other search has to walk through it from one to the other.
   */
  void KeepAsBridge(int cell, const Labels& components);

private:
  /** A walk over the nodes that hang together with some corners of a cell. */
  struct Search
  {
    std::vector<int> Nodes;  ///< reached so far
    std::size_t Current = 0; ///< the one whose links are being followed
    int NextLink = -1;       ///< -1: the first
    int Label = -1;          ///< that of the corners; of searches that have met the same
    int Side = 0;            ///< of a bridge: searches on different sides cannot meet
  };

  struct Edge
  {
    std::array<int, 2> Nodes;
    int Holder; ///< the first in the list of its cells; some of them have gone
  };
  struct Holder
  {
    int Cell;
    int Next;
  };

  /** An edge as one of its nodes has it. */
  struct Link
  {
    int Node; ///< the other one
    int Edge;
  };

  void FindNodes();
  template <class Visitor>
  void ForEachPair(Visitor&& visit) const;
  void FindLinks();
  void Start(int cell, const Labels& labels);
  bool IsOpen(const Search& search) const;
  void FollowLink(Search& search, int cell);
  bool Reach(Search& search, int node);
  bool HasMet(const Search& search, int node) const;
  bool Holds(int cell, const std::array<int, 2>& nodes) const;
  int FindHolder(int edge, int cell);

  /** Corners with the same number are joined by the cell; they differ where it is a bridge. */
  int SideOf(int cell, int corner) const
  {
    return this->Sides[cell] >> (2 * corner) & 3;
  }

  const Decomposition<D>& Mesh;
  const std::vector<CellState>& States;
  std::vector<unsigned char> Sides;
  /** Per vertex; nodes are named after one of their vertices. */
  std::vector<int> Node;
  std::vector<Edge> Edges;
  std::vector<Holder> Holders;
  /** The links of a node are those from Begins to Ends, some of which have gone. Empty until needed. */
  std::vector<int> Begins, Ends;
  std::vector<Link> Links;
  std::array<Search, D + 1> Searches;
  /** Per node: the number of the last question in which a search came to it, times D + 1, plus which. */
  std::vector<long long> Reached;
  long long Question = 0;
};

} // namespace carving

#endif
