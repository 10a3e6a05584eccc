// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which tetrahedra belong to the solid that M bounds and which to its complement.
 */
#ifndef carving_Classification_h
#define carving_Classification_h

#include "Core/Mesh/Mesh.h"

#include <vector>

namespace carving
{

enum class RegionKind
{
  Outside, ///< complement, joined to the outside by a path that crosses no triangle of M
  Void,    ///< complement, enclosed by M
  Solid,
  Kept ///< what M pierces, in enclosing mode; never carved
};

/** Which of the regions that M encloses are solid. */
enum class SolidRule : int
{
  /**
   * Where the winding number is at least one half in magnitude. Of a closed M it follows from the
   * outside's by counting crossings; else, and in enclosing mode, it is the sum of solid angles at the
   * centroid of the region's largest tetrahedron.
   */
  NonzeroWinding = 0,
  /**
   * Where the path of fewest crossings from the outside crosses an odd number of triangles; in enclosing
   * mode, where a ray from the centroid of the region's largest tetrahedron does.
   */
  EvenOdd = 1,
  /** None: M is a surface without inside. */
  SurfaceOnly = 2
};

/** A maximal set of tetrahedra that non-constraining faces join; all kept ones together are one. */
struct Region
{
  RegionKind Kind = RegionKind::Outside;
  double Winding = 0.0; ///< by NonzeroWinding: the winding number, 0 for a region of kind Outside
  /**
   * The rule had to guess, since M is open or inconsistently oriented: the winding number is not
   * within 0.1 of an integer, or parity depends on the path.
   */
  bool Guessed = false;
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
 * Regions, numbered in the order of their first tetrahedron. What reaches the outside without crossing
 * M is never solid.
 */
template <int D>
Classification Classify(const Decomposition<D>& mesh, SolidRule rule = SolidRule::NonzeroWinding);

} // namespace carving

#endif
