// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The cells of a decomposition while carving removes some of them.
 */
#ifndef carving_RemainingCells_h
#define carving_RemainingCells_h

#include "Core/Mesh/Mesh.h"

#include <algorithm>
#include <array>
#include <vector>

namespace carving
{

enum class CellState : char
{
  Carvable,
  Carved,
  Permanent ///< never carved: in the solid, kept, or in a void that is not opened
};

template <int D>
struct RemainingCells
{
  using Cell = typename Decomposition<D>::Cell;

  /** The far side of a face. */
  struct Behind
  {
    int Cell : 31;        ///< or Outside
    unsigned IsFacet : 1; ///< whether the face lies on M
  };

  /** The data of a cell that walks from cell to cell read, in one place. */
  struct Record
  {
    std::array<int, D + 1> Corners;
    std::array<Behind, D + 1> Faces; ///< entry f: the far side of the face opposite to corner f
  };

  /** `states`: one per cell. */
  RemainingCells(const Decomposition<D>& mesh, const std::vector<CellState>& states)
    : Records(mesh.Cells.size())
    , States(states)
  {
    for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
    {
      this->Records[cell].Corners = mesh.Cells[cell];
      for (int f = 0; f <= D; ++f)
      {
        this->Records[cell].Faces[f] = { std::max(mesh.Neighbors[cell][f], Outside),
          mesh.Constraints.Has(cell, f) };
      }
    }
  }

  /** The cell behind the face opposite to corner f, or Outside. */
  int GetNeighbor(int cell, int f) const
  {
    return this->Records[cell].Faces[f].Cell;
  }

  /** Whether a cell has not been carved. False for Outside. */
  bool IsRemaining(int cell) const
  {
    return cell >= 0 && this->States[cell] != CellState::Carved;
  }

  /** Whether a face, given its far side, lies on M or belongs to the remaining cell behind it. */
  bool IsShared(const Behind& behind) const
  {
    return behind.IsFacet || this->IsRemaining(behind.Cell);
  }

  std::vector<Record> Records;
  std::vector<CellState> States;
};

} // namespace carving

#endif
