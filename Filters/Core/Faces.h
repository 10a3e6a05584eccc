// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The faces of a stored stream and the steps at which each is part of the approximation.
 */
#ifndef carving_Faces_h
#define carving_Faces_h

#include "Ridges.h"
#include "StoredStream.h"

#include <algorithm>

namespace carving
{

/** A face that looks the same on every approximation C_j with Birth <= j < Death. */
template <int D>
struct FaceLife
{
  std::array<int, D> Corners; ///< oriented outward; of a fold, as M has it
  int Constraint;             ///< the facet of M that it lies on, -1 if none
  int Behind;                 ///< the half-face behind it, or Outside or Solid
  int InFront;                ///< the half-face in front of it, or Outside or Solid
  bool Fold;                  ///< the exterior is on both sides
  int Birth;
  int Death;
};

/** The step at which the exterior comes to a half-face. */
template <int D>
int StepAt(const StoredStream<D>& stream, int halfFace)
{
  return halfFace == Outside ? 0
    : halfFace == Solid      ? Stream::Never
                             : stream.Order.Step[HalfFace<D>::Cell(halfFace)];
}

/**
 * Calls `visit(const FaceLife<D>&)` for each face that shows on some approximation, first those of the
 * carved surface, then those of M. A face of the carved surface shows while it has the exterior on one
 * side only; a facet of M from the moment it has it on any side, and it changes into a fold when it has
 * it on both. Faces that show on none of C_first to
 * C_last are passed over.
 */
template <int D, class Visitor>
void ForEachFace(
  const StoredStream<D>& stream, Visitor&& visit, int first = 0, int last = Stream::Never)
{
  const Decomposition<D>& mesh = stream.Mesh;
  const auto visitIfItShows = [&](const FaceLife<D>& face)
  {
    if (face.Birth < face.Death && face.Birth <= last && face.Death > first)
    {
      visit(face);
    }
  };
  const int numberOfCells = static_cast<int>(mesh.Cells.size());
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      const int neighbor = mesh.Neighbors[cell][f];
      if (mesh.Constraints[cell][f] >= 0 || (neighbor >= 0 && neighbor < cell))
      {
        continue; // a facet of M, or visited from the neighbor
      }
      const int here = stream.Order.Step[cell];
      const int there = neighbor < 0 ? 0 : stream.Order.Step[neighbor];
      if (here == there || std::min(here, there) > last || std::max(here, there) <= first)
      {
        continue;
      }
      const int own = HalfFace<D>::Of(cell, f);
      const int other = neighbor < 0 ? neighbor : AcrossFace(mesh, own);
      const std::array<int, D> corners = mesh.OutwardFace(cell, f);
      visitIfItShows(here > there
          ? FaceLife<D>{ corners, -1, own, other, false, there, here }
          : FaceLife<D>{ Flipped<D>(corners), -1, other, own, false, here, there });
    }
  }
  for (int facet = 0; facet < static_cast<int>(stream.Sides.size()); ++facet)
  {
    const std::array<int, D>& corners = mesh.Surface.Facets[facet];
    const auto [behind, inFront] = stream.Sides[facet];
    const int stepBehind = StepAt(stream, behind);
    const int stepInFront = StepAt(stream, inFront);
    const int birth = std::min(stepBehind, stepInFront);
    const int fold = std::max(stepBehind, stepInFront);
    if (stepInFront <= stepBehind)
    {
      visitIfItShows({ corners, facet, behind, inFront, false, birth, fold });
    }
    else
    {
      visitIfItShows({ Flipped<D>(corners), facet, inFront, behind, false, birth, fold });
    }
    visitIfItShows({ corners, facet, behind, inFront, true, fold, Stream::Never });
    if (stream.Folds == FoldSides::Both)
    {
      visitIfItShows({ Flipped<D>(corners), facet, inFront, behind, true, fold, Stream::Never });
    }
  }
}

} // namespace carving

#endif
