// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Rotation through the cells around a ridge. A ridge is an edge of a triangle, or an end of an edge
 * in the plane.
 */
#ifndef carving_Ridges_h
#define carving_Ridges_h

#include "Core/Mesh/Mesh.h"
#include "Core/Stream/StoredStream.h"

#include <algorithm>

namespace carving
{

/** The D - 1 corners of a facet other than corner k, in ascending order. */
template <int D>
std::array<int, D - 1> RidgeOf(const std::array<int, D>& facet, int k)
{
  std::array<int, D - 1> ridge;
  for (int i = 0, j = 0; i < D; ++i)
  {
    if (i != k)
    {
      ridge[j++] = facet[i];
    }
  }
  std::sort(ridge.begin(), ridge.end());
  return ridge;
}

/**
 * The other face of the half-face's cell that contains the ridge, as a half-face of the same cell.
 */
template <int D>
int AcrossCell(const Decomposition<D>& mesh, int halfFace, const std::array<int, D - 1>& ridge)
{
  const int cell = HalfFace<D>::Cell(halfFace);
  const int entered = HalfFace<D>::Corner(halfFace);
  for (int corner = 0; corner <= D; ++corner)
  {
    if (corner != entered &&
      std::find(ridge.begin(), ridge.end(), mesh.Cells[cell][corner]) == ridge.end())
    {
      return HalfFace<D>::Of(cell, corner);
    }
  }
  return -1; // the ridge is not one of this face
}

/** The same face as a half-face of the neighboring cell, which must exist. */
template <int D>
int AcrossFace(const Decomposition<D>& mesh, int halfFace)
{
  const int cell = HalfFace<D>::Cell(halfFace);
  const int opposite = mesh.Cells[cell][HalfFace<D>::Corner(halfFace)];
  const int neighbor = mesh.Neighbors[cell][HalfFace<D>::Corner(halfFace)];
  const auto& own = mesh.Cells[cell];
  for (int corner = 0; corner <= D; ++corner)
  {
    const int vertex = mesh.Cells[neighbor][corner];
    if (vertex == opposite || std::find(own.begin(), own.end(), vertex) == own.end())
    {
      return HalfFace<D>::Of(neighbor, corner);
    }
  }
  return -1; // no two cells have the same corners
}

/** The other side of a half-face: a half-face, Solid or Outside. */
template <int D>
int Across(const Decomposition<D>& mesh, int halfFace)
{
  const int neighbor = mesh.Neighbors[HalfFace<D>::Cell(halfFace)][HalfFace<D>::Corner(halfFace)];
  return neighbor < 0 ? neighbor : AcrossFace(mesh, halfFace);
}

} // namespace carving

#endif
