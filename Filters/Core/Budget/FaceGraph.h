// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The graph in which the remaining tetrahedra are connected through faces.
 */
#ifndef carving_FaceGraph_h
#define carving_FaceGraph_h

#include "Core/Budget/LockstepSearch.h"
#include "Core/Budget/RemainingCells.h"
#include "Core/Mesh/Fetch.h"

#include <cstddef>
#include <vector>

namespace carving
{

/**
 * Every remaining tetrahedron is a node. Links lead to the neighbors behind its faces. Permanent
 * tetrahedra that are connected through faces form a block. Two searches that have reached the same
 * block have met.
 */
class FaceGraph
{
public:
  /** No cell is carved yet. `cells` must outlive this object. */
  explicit FaceGraph(const RemainingCells<3>& cells);

  /** The number of components, in linear time. */
  int CountComponents() const;

  void Carve(int cell)
  {
    this->Nodes[cell].IsCarved = true;
  }

  /**
   * Notes that the cell is kept, and that only the cell joins the neighbors with different labels.
   */
  void KeepAsBridge(int cell, const Labels<4>& labels)
  {
    this->Nodes[cell].SidesOf = Sides<4>(labels);
  }

  /** Prefetches a cell that will be needed soon. */
  void Fetch(int cell) const
  {
    Prefetch(&this->Nodes[cell]);
  }

  // For LockstepSearch:

  static constexpr std::size_t MaximumPieces = 4;

  struct Place
  {
    int Cell;
    int Entry; ///< a face on the side of the cell from which the search has entered
  };

  const Sides<4>& GetSides(int cell) const
  {
    return this->Nodes[cell].SidesOf;
  }

  template <class Search>
  void Start(int cell, int f, Search search)
  {
    this->Enter(this->Cells.GetNeighbor(cell, f), cell, search);
  }

  /** Visits all neighbors on the side of entry. */
  template <class Search>
  bool Step(int cell, const Place& place, Search search)
  {
    const auto [from, entry] = place;
    const auto& sides = this->Nodes[from].SidesOf.Of;
    for (int f = 0; f < 4; ++f)
    {
      const int neighbor = this->Cells.GetNeighbor(from, f);
      if (neighbor != Outside && neighbor != cell && sides[f] == sides[entry])
      {
        this->Enter(neighbor, from, search);
      }
    }
    return false;
  }

private:
  /** The data of a cell that a search reads on arrival, in one place. */
  struct Node
  {
    ReachedBy Reached = {};
    int Block = -1; ///< -1 for a cell that is not permanent
    Sides<4> SidesOf;
    bool IsCarved = false;
  };

  template <class Search>
  void Enter(int cell, int from, Search& search)
  {
    Node& node = this->Nodes[cell];
    if (node.IsCarved || search.Arrive(node.Reached) != Arrival::First)
    {
      return;
    }
    Prefetch(&this->Cells.Records[cell]); // for the step from there
    int entry = 0;
    while (node.SidesOf.IsBridge() && this->Cells.GetNeighbor(cell, entry) != from)
    {
      ++entry;
    }
    search.Add({ cell, entry });
    if (node.Block >= 0)
    {
      search.Arrive(this->Blocks[node.Block]);
    }
  }

  const RemainingCells<3>& Cells;
  std::vector<Node> Nodes;       ///< per cell
  std::vector<ReachedBy> Blocks; ///< per block
};

} // namespace carving

#endif
