// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The faces of a stored stream and the steps at which each is part of the approximation.
 */
#ifndef carving_Faces_h
#define carving_Faces_h

#include "Carver.h"
#include "Mesh.h"

#include <algorithm>

namespace carving
{

/** A face that shows on every approximation C_j with Birth <= j < Death. */
struct FaceLife
{
  int Cell;       ///< one of its tetrahedra
  int Corner;     ///< the corner of `Cell` that it is opposite to
  int Neighbor;   ///< the other tetrahedron, -1 for the outside of C0
  int Constraint; ///< the triangle of M that it lies on, -1 if none
  int Birth;
  int Death;
};

/**
 * Calls `visit(const FaceLife&)` once for each face that shows on some approximation. A face of the
 * carved surface shows while it has the exterior on one side only, a triangle of M from the moment
 * it has it on any side.
 */
template <class Visitor>
void ForEachFace(const Tetrahedralization& mesh, const Stream& stream, Visitor&& visit)
{
  const int numberOfCells = static_cast<int>(mesh.Cells.size());
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      const int neighbor = mesh.Neighbors[cell][f];
      if (neighbor >= 0 && neighbor < cell)
      {
        continue; // visited from there
      }
      const int constraint = mesh.Constraints[cell][f];
      const int here = stream.Step[cell];
      const int there = neighbor < 0 ? 0 : stream.Step[neighbor];
      const int birth = std::min(here, there);
      const int death = constraint < 0 ? std::max(here, there) : Stream::Never;
      if (birth < death)
      {
        visit(FaceLife{ cell, f, neighbor, constraint, birth, death });
      }
    }
  }
}

} // namespace carving

#endif
