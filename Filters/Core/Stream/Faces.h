// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The faces of a stream, and the range of steps in which each is part of the approximation.
 */
#ifndef carving_Faces_h
#define carving_Faces_h

#include "Core/Mesh/Fetch.h"
#include "Core/Stream/Ridges.h"
#include "Core/Stream/StoredStream.h"

#include <algorithm>

namespace carving
{

/** A face that is unchanged on every approximation C_j with Birth <= j < Death. */
template <int D>
struct FaceLife
{
  std::array<int, D> Corners; ///< oriented outward; those of a fold as in M
  int Constraint;             ///< the facet of M that it lies on, or -1
  int Behind;                 ///< the half-face behind it, or Outside or Solid
  bool Fold;                  ///< the exterior is on both sides
  int Birth;
  int Death;
};

/** The step from which on the cell of a half-face is exterior. */
template <int D>
int StepAt(const StoredStream<D>& stream, int halfFace)
{
  return halfFace == Outside ? 0
    : halfFace == Solid      ? Stream::Never
                             : stream.Order.Step[HalfFace<D>::Cell(halfFace)];
}

/**
 * The cell of the stored stream that has the data of a face: the facet of M that it lies on, which
 * is numbered after the cells, or the cell behind it.
 */
template <int D>
int CellWithDataOf(const StoredStream<D>& stream, const FaceLife<D>& face)
{
  return face.Constraint >= 0 ? static_cast<int>(stream.Mesh.Cells.size()) + face.Constraint
                              : HalfFace<D>::Cell(face.Behind);
}

/**
 * The half-face in front of a face, or Outside. Solid is possible only on approximations without
 * the face.
 */
template <int D>
int InFront(const StoredStream<D>& stream, const FaceLife<D>& face)
{
  if (face.Constraint >= 0)
  {
    const bool ownSide =
      SameDirection<D>(face.Corners, stream.Mesh.Surface.Facets[face.Constraint]);
    return stream.Sides[face.Constraint][ownSide ? 1 : 0];
  }
  return Across(stream.Mesh, face.Behind);
}

/**
 * Calls `visit(const FaceLife<D>&)` for each face that is part of some approximation from C_first
 * to C_last: first the carved faces, then the facets of M. A carved face is part of an
 * approximation while exactly one of its sides is exterior. A facet of M is, from the first step on
 * in which a side is exterior, and becomes a fold when both are. Linear in the number of cells.
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
    FetchAhead(mesh, cell, stream.Order.Step);
    // A face is visited from the cell behind it, the one of its two cells that is carved later.
    const int death = stream.Order.Step[cell];
    if (death <= first)
    {
      continue;
    }
    for (int f = 0; f <= D; ++f)
    {
      const int neighbor = mesh.Neighbors[cell][f];
      const int birth = neighbor < 0 ? 0 : stream.Order.Step[neighbor];
      // The first condition rejects nearly all faces when a single level is extracted.
      if (birth <= last && birth < death && !mesh.Constraints.Has(cell, f))
      {
        visit(FaceLife<D>{
          mesh.OutwardFace(cell, f), -1, HalfFace<D>::Of(cell, f), false, birth, death });
      }
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
      visitIfItShows({ corners, facet, behind, false, birth, fold });
    }
    else
    {
      visitIfItShows({ Flipped<D>(corners), facet, inFront, false, birth, fold });
    }
    visitIfItShows({ corners, facet, behind, true, fold, Stream::Never });
    if (stream.Folds == FoldSides::Both)
    {
      visitIfItShows({ Flipped<D>(corners), facet, inFront, true, fold, Stream::Never });
    }
  }
}

} // namespace carving

#endif
