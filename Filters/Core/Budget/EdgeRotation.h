// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Rotation through the tetrahedra around an edge, those of carved cells included.
 */
#ifndef carving_EdgeRotation_h
#define carving_EdgeRotation_h

#include "Core/Budget/RemainingCells.h"

#include <array>

namespace carving
{

/** The index of a vertex among the corners of a tetrahedron, of which it must be one. */
inline int CornerOf(const std::array<int, 4>& corners, int vertex)
{
  return (corners[1] == vertex) + 2 * (corners[2] == vertex) + 3 * (corners[3] == vertex);
}

/** A tetrahedron at an edge and a direction around the edge. */
class EdgeRotation
{
public:
  /** Starts in a cell, at the edge between corners p and q. `direction`: 0 or 1. */
  EdgeRotation(const RemainingCells<3>& cells, int cell, int p, int q, int direction)
    : Cells(cells)
    , Cell(cell)
  {
    const auto& corners = cells.Records[cell].Corners;
    const std::array<int, 2> others = OtherCorners(p, q);
    this->Edge = corners[p] ^ corners[q];
    this->Face = others[direction];
    this->Apex = corners[others[1 - direction]];
  }

  /** The far side of the face ahead. */
  const RemainingCells<3>::Behind& GetNext() const
  {
    return this->Cells.Records[this->Cell].Faces[this->Face];
  }

  /** Moves into the cell behind the face ahead. */
  void Enter(int cell)
  {
    const auto& corners = this->Cells.Records[cell].Corners;
    this->Cell = cell;
    // The face just crossed joins the edge and the old apex. The next face joins the edge and the
    // fourth vertex, and is opposite to the old apex.
    const int all = corners[0] ^ corners[1] ^ corners[2] ^ corners[3];
    this->Face = CornerOf(corners, this->Apex);
    this->Apex ^= all ^ this->Edge;
  }

private:
  const RemainingCells<3>& Cells;
  int Edge; ///< the exclusive or of the edge's two vertices
  int Cell;
  int Face; ///< the corner that is opposite to the face ahead
  int Apex; ///< the third vertex of the face ahead
};

/**
 * Whether the far side of any face around an edge of the cell satisfies `isMatch`. Rotates from the
 * cell in both directions by turns, until there is a match, the directions meet, or both end at
 * Outside. So the cost depends on the nearer match only.
 */
template <class Predicate>
bool AnyAroundEdge(const RemainingCells<3>& cells, int cell, int p, int q, Predicate&& isMatch)
{
  EdgeRotation rotations[] = { { cells, cell, p, q, 0 }, { cells, cell, p, q, 1 } };
  int at[] = { cell, cell };
  for (;;)
  {
    for (const int direction : { 0, 1 })
    {
      if (at[direction] == Outside)
      {
        continue;
      }
      const auto& next = rotations[direction].GetNext();
      if (isMatch(next))
      {
        return true;
      }
      at[direction] = next.Cell;
      if (at[0] == at[1]) // the directions have met, or both have ended at Outside
      {
        return false;
      }
      if (next.Cell != Outside)
      {
        rotations[direction].Enter(next.Cell);
      }
    }
  }
}

} // namespace carving

#endif
