// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decides which pieces around a cell are joined elsewhere, by searches from all pieces in lockstep.
 */
#ifndef carving_LockstepSearch_h
#define carving_LockstepSearch_h

#include "Core/Budget/Labels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace carving
{

/** The last search that reached a node. */
struct ReachedBy
{
  unsigned Question : 30; ///< the number of the call of LockstepSearch::Join; 0: never reached
  unsigned Search : 2;
};

/** How a search arrives at a node. */
enum class Arrival
{
  First,  ///< no search has been at the node
  Again,  ///< the search, or one that it has met, has been at the node
  Meeting ///< a search that it has not met has been at the node: now they have met
};

/**
 * Breadth-first searches of a graph, one from each piece around a cell. The searches take turns,
 * one step each. Two searches that reach the same node have met: their pieces are joined. The
 * searches end when no two that have not met can continue. So the cost of a piece that splits off
 * is that of the smaller side, which makes O(n log n) for all splits of a carving. The cost of
 * pieces that are still joined depends on the length of the path between them.
 *
 * Bridges (see `Sides`) divide the graph. Searches from different sides of the same bridge never
 * meet. No search crosses another bridge from side to side: a path across that led back to the cell
 * would join the sides without the bridge.
 *
 * A `Graph` has
 * - `static constexpr std::size_t MaximumPieces`, at most 4: the number of corners or of faces of a
 *   cell;
 * - `Place`: a position of a search in the graph, as a small struct;
 * - `const Sides<MaximumPieces>& GetSides(int cell) const`;
 * - `void Start(int cell, int i, Search search)`: arrives at the node at corner or face i of the
 *   cell;
 * - `bool Step(int cell, Place& place, Search search)`: takes one step from a place, but not
 *   through the cell. Returns whether more steps can follow from the place. A call of `search.Add`
 *   invalidates `place`.
 */
template <class Graph>
class LockstepSearch
{
  static constexpr std::size_t N = Graph::MaximumPieces;
  using Place = typename Graph::Place;

  /** The places of one search. */
  struct Frontier
  {
    std::vector<Place> Places; ///< in the order in which they have been reached
    std::size_t Current = 0;   ///< the place from which the search continues
    int Label = -1;            ///< the same for searches that have met
    int Side = 0;              ///< the side of the cell on which the search has started

    bool IsRunning() const
    {
      return this->Current < this->Places.size();
    }
  };

public:
  /** One search, as the graph sees it. */
  class Search
  {
  public:
    /** Whether this search, or one that it has met, has been at a node. */
    bool HasReached(ReachedBy node) const
    {
      return node.Question == this->All.Question &&
        this->All.Frontiers[node.Search].Label == this->Own.Label;
    }

    /** Arrives at a node. The graph keeps the record of each node. */
    Arrival Arrive(ReachedBy& node)
    {
      if (node.Question != this->All.Question)
      {
        node = { this->All.Question,
          static_cast<unsigned>(&this->Own - this->All.Frontiers.data()) };
        return Arrival::First;
      }
      const int met = this->All.Frontiers[node.Search].Label;
      if (met == this->Own.Label)
      {
        return Arrival::Again;
      }
      for (Frontier& frontier : this->All.Frontiers)
      {
        frontier.Label = frontier.Label == met ? this->Own.Label : frontier.Label;
      }
      return Arrival::Meeting;
    }

    /** Adds a place to continue from. */
    void Add(const Place& place)
    {
      this->Own.Places.push_back(place);
    }

  private:
    friend LockstepSearch;
    Search(LockstepSearch& all, Frontier& own)
      : All(all)
      , Own(own)
    {
    }

    LockstepSearch& All;
    Frontier& Own;
  };

  /**
   * Merges the labels of all pieces around the cell that the graph joins without the cell. Pieces
   * that are known to be joined have equal labels already.
   */
  void Join(Graph& graph, int cell, Labels<N>& labels)
  {
    this->Start(graph, cell, labels);
    for (bool isOpen = true; isOpen;)
    {
      isOpen = false;
      for (Frontier& frontier : this->Frontiers)
      {
        if (this->CanMeetAnother(frontier))
        {
          isOpen = true;
          Place& place = frontier.Places[frontier.Current];
          frontier.Current += !graph.Step(cell, place, Search(*this, frontier));
        }
      }
    }
    for (int& label : labels)
    {
      label = label < 0 ? -1 : this->Frontiers[label].Label;
    }
  }

private:
  void Start(Graph& graph, int cell, const Labels<N>& labels)
  {
    ++this->Question;
    for (std::size_t i = 0; i < N; ++i)
    {
      this->Frontiers[i].Places.clear();
      this->Frontiers[i].Current = 0;
      this->Frontiers[i].Label = static_cast<int>(i);
    }
    for (std::size_t i = 0; i < N; ++i)
    {
      if (labels[i] >= 0)
      {
        Frontier& frontier = this->Frontiers[labels[i]];
        frontier.Side = graph.GetSides(cell).Of[i];
        graph.Start(cell, static_cast<int>(i), Search(*this, frontier));
      }
    }
  }

  bool CanMeetAnother(const Frontier& frontier) const
  {
    return frontier.IsRunning() &&
      std::any_of(this->Frontiers.begin(), this->Frontiers.end(),
        [&](const Frontier& other) {
          return other.IsRunning() && other.Side == frontier.Side && other.Label != frontier.Label;
        });
  }

  std::array<Frontier, N> Frontiers; ///< per label
  unsigned Question = 0;
};

} // namespace carving

#endif
