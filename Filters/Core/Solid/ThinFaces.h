// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Faces of tetrahedra that are narrower than a crack.
 */
#ifndef carving_ThinFaces_h
#define carving_ThinFaces_h

#include "Core/Solid/Classification.h"

#include <vector>

namespace carving
{

/** A face of a cell. */
struct CellFace
{
  int Cell, Face;
};

/** The same face, of the cell on the other side; of the exterior if there is none. */
CellFace OtherSide(const Tetrahedralization& mesh, const CellFace& face);

/**
 * The faces that are no wider than a crack and lie on no facet, in regions that are connected to
 * the outside, each once.
 */
std::vector<CellFace> FindThinFaces(
  const Tetrahedralization& mesh, const Classification& regions, double width);

/** Per region: whether any of its cells is thicker than a crack. */
std::vector<char> FindThickRegions(
  const Tetrahedralization& mesh, const Classification& regions, double width);

} // namespace carving

#endif
