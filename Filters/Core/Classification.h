// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which tetrahedra belong to the solid that M bounds and which to its complement.
 */
#ifndef carving_Classification_h
#define carving_Classification_h

#include "Mesh.h"

#include <vector>

namespace carving
{

enum class RegionKind
{
  Outside, ///< complement, joined to the outside by a path that crosses no triangle of M
  Void,    ///< complement, enclosed by M
  Solid
};

/** A maximal set of tetrahedra that non-constraining faces join. */
struct Region
{
  RegionKind Kind = RegionKind::Outside;
  double Winding = 0.0; ///< winding number of M, 0 for a region of kind Outside
  bool Guessed = false; ///< the winding number is not within 0.1 of an integer: M is open there
};

struct Classification
{
  std::vector<int> RegionOfCell;
  std::vector<Region> Regions;

  RegionKind Kind(int cell) const
  {
    return this->Regions[this->RegionOfCell[cell]].Kind;
  }
};

/**
 * Regions, numbered in the order of their first tetrahedron, and by nonzero winding whether each is
 * solid: an enclosed region is where its winding number is at least one half in magnitude. Of a
 * closed M the numbers follow from the outside's by counting crossings; else they are the sum of
 * solid angles at the centroid of the region's largest tetrahedron.
 */
Classification Classify(const Tetrahedralization& mesh);

} // namespace carving

#endif
