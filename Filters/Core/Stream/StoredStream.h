// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All that is needed to give any approximation of a carving, without the cells of the solid.
 */
#ifndef carving_StoredStream_h
#define carving_StoredStream_h

#include "Core/Carving/Priority.h"
#include "Core/Carving/Stream.h"
#include "Core/Mesh/Mesh.h"
#include "Core/Solid/Classification.h"

#include <vector>

namespace carving
{

/** What of a fold (a facet of M with the exterior on both sides) shows on a level. */
enum class FoldSides : int
{
  One, ///< the facet once, oriented as M has it
  Both ///< the facet and its opposite-facing copy
};

/** A face of a cell as a number: (D + 1) * cell + the corner that it is opposite to. */
template <int D>
struct HalfFace
{
  static int Of(int cell, int corner)
  {
    return (D + 1) * cell + corner;
  }
  static int Cell(int halfFace)
  {
    return halfFace / (D + 1);
  }
  static int Corner(int halfFace)
  {
    return halfFace % (D + 1);
  }
};

/**
 * The stored stream: the complement with the order in which it is carved, and on which side of M the
 * solid is.
 */
template <int D>
struct StoredStream
{
  /**
   * The cells of the complement only: a face on the solid has the neighbor Solid. All cells in enclosing
   * mode, since the solid and what is kept may meet in faces that are not of M, and in the plane, since
   * levels are cut across the solid there.
   */
  Decomposition<D> Mesh;
  /** Per cell of `Mesh`. */
  Stream Order;
  /** By which `Order` has been made. */
  PriorityMeasure Measure = PriorityMeasure::LongestEdge;
  FoldSides Folds = FoldSides::One;
  /** Per cell: its region, as numbered by the classification. */
  std::vector<int> Regions;
  /**
   * Per facet of M, behind it and in front of it: the half-face of a cell of `Mesh`, Outside or Solid.
   * Faces the way of `Mesh.Surface.Facets`.
   */
  std::vector<std::array<int, 2>> Sides;
};

/** Leaves the cells of the solid out where they are not needed, see StoredStream::Mesh. */
template <int D>
StoredStream<D> Store(
  const Decomposition<D>& mesh, const Classification& regions, const Stream& stream);

/**
 * Finds `Mesh.Neighbors`, `Mesh.Constraints` and `Sides` anew from the cells and the facets, where
 * `solidSides` has per facet 1 for solid behind it plus 2 for solid in front of it: a stream that has
 * been read from a file is then as `Store` made it. Returns false if a face belongs to more than two
 * cells, cells overlap facets in an impossible way, or some have a corner twice.
 */
template <int D>
bool Connect(StoredStream<D>& stream, const std::vector<int>& solidSides);

/** The `solidSides` of Connect. */
template <int D>
std::vector<int> GetSolidSides(const StoredStream<D>& stream);

} // namespace carving

#endif
