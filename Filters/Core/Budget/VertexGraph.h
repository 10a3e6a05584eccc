// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The graph of the vertices of K, joined by the remaining cells.
 */
#ifndef carving_VertexGraph_h
#define carving_VertexGraph_h

#include "Core/Budget/LockstepSearch.h"
#include "Core/Budget/RemainingCells.h"
#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/Mesh.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace carving
{

/**
 * A graph with the connectivity of K, the closed complex of M, the solid and all remaining cells.
 *
 * M and the permanent cells never change, so each of their connected components is one node. Every
 * other vertex is a node of its own. An edge joins two nodes as long as a carvable cell with
 * corners of both remains. Nodes and edges are found when a search first needs them: many carvings
 * need none.
 */
template <int D>
class VertexGraph
{
public:
  /** The mesh and the states, which may change, must outlive this object. */
  VertexGraph(const Decomposition<D>& mesh, const std::vector<CellState>& states);

  /** The number of components of K, in linear time. */
  int CountComponents();

  /** Notes that the cell is kept, and that only the cell joins corners with different labels. */
  void KeepAsBridge(int cell, const Labels<D + 1>& labels)
  {
    this->SidesOf[cell] = Sides<D + 1>(labels);
  }

  // For LockstepSearch:

  static constexpr std::size_t MaximumPieces = D + 1;

  struct Place
  {
    int Node;
    int Followed = 0; ///< the number of links of the node that the search has followed
  };

  const Sides<D + 1>& GetSides(int cell) const
  {
    return this->SidesOf[cell];
  }

  template <class Search>
  void Start(int cell, int corner, Search search)
  {
    this->FindNodes();
    this->Enter(this->NodeOf[this->Mesh.Cells[cell][corner]], search);
  }

  /** Follows one link. A node that stands for a large part of M has too many links for one step. */
  template <class Search>
  bool Step(int cell, Place& place, Search search);

private:
  /**
   * Two nodes, and the range of the cells in JoiningCells that join them. Some cells may be carved
   * by now.
   */
  struct Edge
  {
    std::array<int, 2> Nodes;
    int Begin, End;
  };

  /** An edge as seen from one of its nodes. */
  struct Link
  {
    int Node; ///< the other node
    int Edge;
  };

  void FindNodes();
  void FindEdges();
  void FindLinks();
  template <class Visitor>
  void ForEachPair(Visitor&& visit) const;
  bool Joins(int cell, const std::array<int, 2>& nodes) const;
  int FindJoiningCell(Edge& edge, int cell);

  template <class Search>
  Arrival Enter(int node, Search& search)
  {
    const Arrival arrival = search.Arrive(this->Reached[node]);
    if (arrival == Arrival::First)
    {
      search.Add({ node });
    }
    return arrival;
  }

  const Decomposition<D>& Mesh;
  const std::vector<CellState>& States;
  std::vector<Sides<D + 1>> SidesOf; ///< per cell
  std::vector<int> NodeOf; ///< per vertex: the smallest vertex of its node, which names the node
  std::vector<ReachedBy> Reached; ///< per node
  std::vector<Edge> Edges;
  std::vector<int> JoiningCells;
  std::optional<Buckets<Link>> Links; ///< per node; empty until a search needs them
  std::vector<int> LinkCount;         ///< per node: the number of its links that are in use
};

template <int D>
template <class Search>
bool VertexGraph<D>::Step(int cell, Place& place, Search search)
{
  if (!this->Links)
  {
    this->FindEdges();
    this->FindLinks();
  }
  const auto links = (*this->Links)[place.Node].First;
  int& count = this->LinkCount[place.Node];
  if (place.Followed == count)
  {
    return false;
  }
  Link& link = links[place.Followed];
  if (search.HasReached(this->Reached[link.Node]))
  {
    ++place.Followed;
    return true;
  }
  const int joining = this->FindJoiningCell(this->Edges[link.Edge], cell);
  if (joining < 0) // the nodes will never be joined again
  {
    link = links[--count];
    return true;
  }
  ++place.Followed;
  if (joining != cell && this->Enter(link.Node, search) == Arrival::Meeting)
  {
    std::swap(link, links[0]); // what joins two pieces is likely to join them the next time
  }
  return true;
}

} // namespace carving

#endif
