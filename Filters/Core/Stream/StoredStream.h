// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The data from which any approximation of a carving can be extracted.
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

/** How a level shows a fold, a facet of M with the exterior on both sides. */
enum class FoldSides : int
{
  One, ///< the facet once, oriented as M has it
  Both ///< the facet and its opposite-facing copy
};

/** A face as seen from one of its cells, as a number: (D + 1) * cell + opposite corner. */
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
 * The complement with the order in which it is carved, and the sides of M on which the solid lies.
 * The priorities, the depths and the regions are empty once they have been written, and in a stream
 * that was read: levels do not need them.
 */
template <int D>
struct StoredStream
{
  /**
   * The cells of the complement; a face on the solid has the neighbor Solid. In two cases also the
   * cells of the solid: in enclosing mode, where solid and kept cells may share faces that are not
   * of M, and in the plane, where levels are cut across the solid.
   */
  Decomposition<D> Mesh;
  /** Per cell of `Mesh`. */
  Stream Order;
  /** The measure that `Order` was carved with. */
  PriorityMeasure Measure = PriorityMeasure::LongestEdge;
  FoldSides Folds = FoldSides::One;
  /** Per cell: its region in the classification. */
  std::vector<int> Regions;
  /**
   * Per facet of M, behind it and in front of it: the half-face of a cell of `Mesh`, Outside or
   * Solid.
   */
  std::vector<std::array<int, 2>> Sides;
};

/**
 * Stores a carving. Omits the cells of the solid where levels do not need them; see
 * StoredStream::Mesh.
 */
template <int D>
StoredStream<D> Store(
  const Decomposition<D>& mesh, const Classification& regions, const Stream& stream);

/**
 * Stores a carving of a mesh without the cells of the solid; see DropSolid. The arrays of the mesh
 * and of the stream are moved.
 */
StoredStream<3> Store(Tetrahedralization&& mesh, const Classification& regions, Stream&& stream);

/**
 * Restores a stream that was read from a file: computes `Mesh.Neighbors`, `Mesh.Constraints` and
 * `Sides` from cells and facets. `solidSides` has per facet 1 for solid behind it plus 2 for solid
 * in front of it. Returns false if more than two cells share a face, two facets are equal, or a
 * cell or facet has a corner twice.
 */
template <int D>
bool Connect(StoredStream<D>& stream, const std::vector<int>& solidSides);

/** The `solidSides` that Connect needs. */
template <int D>
std::vector<int> GetSolidSides(const StoredStream<D>& stream);

} // namespace carving

#endif
