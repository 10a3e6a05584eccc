// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The points at which edges of triangles cross other triangles.
 */
#ifndef carving_CutPoints_h
#define carving_CutPoints_h

#include "Helper/Base/Kernels.h"

#include <boost/functional/hash.hpp>

#include <array>
#include <unordered_map>
#include <vector>

namespace carving::helper
{

using ExactPoint = std::array<Exact::FT, 3>;

/**
 * The points of a mesh, followed by the points at which its edges cross its triangles. A point that
 * several triangles have in common is constructed once and has one index.
 */
class CutPoints
{
public:
  explicit CutPoints(const ResolvedMesh& mesh);

  /**
   * The segment that two intersecting triangles of different planes have in common; equal ends: a
   * point.
   */
  std::array<int, 2> Intersect(int a, int b);

  ExactPoint Get(int point) const;

  /** Equal points give equal results, however they were constructed. */
  Point GetRounded(int point) const;

  /** Appends the new points, rounded. */
  void AppendRounded(ResolvedMesh& result) const;

private:
  using ExactVector = std::array<Exact::Exact_kernel::FT, 3>;
  using Crossing = std::array<int, 3>; ///< the ends of an edge, the lower first, and a triangle

  void AddEnds(int a, int b, std::vector<int>& ends);
  int Find(const Crossing& crossing);
  const ExactVector& NormalOf(int triangle);
  ExactVector ToExactVector(int point) const;
  Inexact::Point_3 At(int point) const;
  bool AreEqual(int a, int b) const;

  const ResolvedMesh& Mesh;
  std::vector<ExactPoint> Made;
  std::unordered_map<Crossing, int, boost::hash<Crossing>> Known;
  std::unordered_map<int, ExactVector> Normals; ///< of triangles
};

} // namespace carving::helper

#endif
