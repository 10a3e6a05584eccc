// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Where edges of triangles cross other triangles.
 */
#ifndef carving_CutPoints_h
#define carving_CutPoints_h

#include "Helper/Base/Kernels.h"

#include <boost/functional/hash.hpp>

#include <array>
#include <unordered_map>
#include <vector>

using ExactPoint = std::array<Exact::FT, 3>;

/**
 * The points of a mesh and those at which its edges cross its triangles. A point that triangles have in
 * common is made once for all of them and has one number.
 */
class CutPoints
{
public:
  explicit CutPoints(const carving::ResolvedMesh& mesh);

  /** What two triangles that meet, but lie in different planes, have in common: a segment or a point. */
  std::array<int, 2> Intersect(int a, int b);

  ExactPoint Get(int point) const;

  /** Appends the new points, rounded: equal ones give equal results, however they were made. */
  void AppendRounded(carving::ResolvedMesh& result) const;

private:
  using ExactVector = std::array<Exact::Exact_kernel::FT, 3>;
  using Crossing = std::array<int, 3>; ///< the ends of an edge, the lower first, and a triangle

  void AddEnds(int a, int b, std::vector<int>& ends);
  int Find(const Crossing& crossing);
  const ExactVector& NormalOf(int triangle);
  ExactVector ToExactVector(int point) const;
  Inexact::Point_3 At(int point) const;
  bool AreEqual(int a, int b) const;

  const carving::ResolvedMesh& Mesh;
  std::vector<ExactPoint> Made;
  std::unordered_map<Crossing, int, boost::hash<Crossing>> Known;
  std::unordered_map<int, ExactVector> Normals; ///< of triangles
};

#endif
