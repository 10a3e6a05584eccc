// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The classification of tetrahedra into the solid of M, its complement and voids (section 3).
 */
#ifndef carving_Classification_h
#define carving_Classification_h

#include "Core/Mesh/Mesh.h"

#include <vector>

namespace carving
{

enum class RegionKind
{
  Outside, ///< complement, connected to the outside by a path that crosses no triangle of M
  Void,    ///< complement, enclosed by M
  Solid,
  Kept ///< in enclosing mode: the tetrahedra that M pierces; never carved
};

/** The rule that decides which of the regions enclosed by M are solid. Not in the paper. */
enum class SolidRule : int
{
  /**
   * Regions with a winding number of at least one half in magnitude. Closed parts of M count by
   * their crossings on a path from the outside. Open parts, and all parts in enclosing mode, count
   * by the sum of their solid angles at the centroid of the region's largest tetrahedron.
   */
  NonzeroWinding = 0,
  /**
   * Regions that the path of fewest crossings from the outside reaches through an odd number of
   * triangles. In enclosing mode, a ray from the centroid of the region's largest tetrahedron
   * replaces the path.
   */
  EvenOdd = 1,
  /** No region: M is a surface without an inside. */
  SurfaceOnly = 2
};

/**
 * A maximal set of tetrahedra connected through non-constraining faces. All kept tetrahedra are one
 * region.
 */
struct Region
{
  RegionKind Kind = RegionKind::Outside;
  double Winding = 0.0; ///< with NonzeroWinding: the winding number; 0 for kind Outside
  /**
   * The rule had to guess because M is open wider than a crack, or inconsistently oriented: the
   * winding number is not within 0.1 of an integer, or the parity depends on the path or the ray.
   */
  char Guessed = 0;
};

struct Classification
{
  std::vector<int> RegionOfCell;
  std::vector<Region> Regions;
  /**
   * Per facet of M, behind it and in front of it: the region of the solid there, or -1. Filled by
   * DropSolid; empty while the mesh has the tetrahedra of the solid.
   */
  std::vector<std::array<int, 2>> SolidRegions;

  RegionKind Kind(int cell) const
  {
    return this->Regions[this->RegionOfCell[cell]].Kind;
  }
};

/**
 * Finds the regions, which are numbered in the order of their first tetrahedron. All enclosed ones
 * are marked as Void.
 */
template <int D>
Classification FindRegions(const Decomposition<D>& mesh);

/**
 * Classifies the regions that are marked as Void. A region that is connected to the outside is
 * never solid. The solid angles are measured by several threads.
 */
template <int D>
void ClassifyRegions(
  const Decomposition<D>& mesh, SolidRule rule, int threads, Classification& result);

/** Finds and classifies the regions. */
template <int D>
Classification Classify(
  const Decomposition<D>& mesh, SolidRule rule = SolidRule::NonzeroWinding, int threads = 1);

} // namespace carving

#endif
