// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The cells that are left while others are carved, as walks from one to the next need them.
 */
#ifndef carving_RemainingCells_h
#define carving_RemainingCells_h

#include "Core/Mesh/Mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace carving
{

enum class CellState : char
{
  Carvable,
  Carved,
  Stays ///< for good
};

/** How many different labels there are, not counting -1. */
template <std::size_t N>
int CountLabels(std::array<int, N> labels)
{
  std::sort(labels.begin(), labels.end());
  const auto first = std::upper_bound(labels.begin(), labels.end(), -1);
  return static_cast<int>(std::unique(first, labels.end()) - first);
}

/** Which corner of a tetrahedron a vertex is. It has to be one. */
inline int CornerOf(const std::array<int, 4>& corners, int vertex)
{
  return (corners[1] == vertex) + 2 * (corners[2] == vertex) + 3 * (corners[3] == vertex);
}

/** A number for the edge between two corners of a tetrahedron, the second of which is the smaller. */
constexpr int EdgeIndex(int p, int q)
{
  return p * (p - 1) / 2 + q;
}

template <int D>
struct RemainingCells
{
  using Cell = typename Decomposition<D>::Cell;

  /** All that a walk has to know of a cell, in one place. */
  struct Record
  {
    Cell Corners;
    Cell Behind; ///< its faces: another cell, Outside, or below that a facet of M
  };

  RemainingCells(const Decomposition<D>& mesh, const std::vector<CellState>& states)
    : Records(mesh.Cells.size())
    , States(states)
  {
    for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
    {
      this->Records[cell] = { mesh.Cells[cell], mesh.Neighbors[cell] };
      for (int f = 0; f <= D; ++f)
      {
        int& behind = this->Records[cell].Behind[f];
        behind = std::max(behind, Outside);
        behind = mesh.Constraints[cell][f] >= 0 ? Across(behind) : behind;
      }
    }
  }

  static bool IsFacet(int behind)
  {
    return behind < Outside;
  }
  /** The cell that is behind a facet, or Outside; or the other way around. */
  static int Across(int behind)
  {
    return Outside - 2 - behind;
  }
  /** The cell that is behind, whether there is a facet between or not, or Outside. */
  static int Past(int behind)
  {
    return IsFacet(behind) ? Across(behind) : behind;
  }
  int GetNeighbor(int cell, int f) const
  {
    return Past(this->Records[cell].Behind[f]);
  }

  /** Whether the cell, or Outside, is a cell that is left. */
  bool IsLeft(int cell) const
  {
    return cell >= 0 && this->States[cell] != CellState::Carved;
  }

  std::vector<Record> Records;
  std::vector<CellState> States;
};

/** A turn around the edge between two corners of a tetrahedron, from cell to cell. */
class EdgeTurn
{
public:
  /** Either of two ways, 0 or 1. */
  EdgeTurn(const RemainingCells<3>& cells, int cell, int p, int q, int way)
    : Cells(cells)
    , At(cell)
  {
    const auto& corners = cells.Records[cell].Corners;
    const std::array<int, 2> others = OtherCorners(p, q);
    this->Edge = corners[p] ^ corners[q];
    this->Through = others[way];
    this->Ahead = corners[others[1 - way]];
  }

  /** What is behind the face that is ahead: another cell, Outside or a facet. */
  int GetBehind() const
  {
    return this->Cells.Records[this->At].Behind[this->Through];
  }

  /** Goes to the cell behind that face, past a facet if there is one. */
  void Enter(int cell)
  {
    const auto& corners = this->Cells.Records[cell].Corners;
    this->At = cell;
    this->Through = CornerOf(corners, this->Ahead);
    this->Ahead ^= this->Edge ^ corners[0] ^ corners[1] ^ corners[2] ^ corners[3];
  }

private:
  const RemainingCells<3>& Cells;
  int Edge;    ///< its two vertices, combined by exclusive or
  int At;      ///< the cell
  int Through; ///< the face that is ahead is opposite to this corner
  int Ahead;   ///< of that face, the vertex off the edge
};

} // namespace carving

#endif
