// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Limbs of a tree, and the space that they occupy, so that limbs do not touch each other.
 */
#ifndef Limb_h
#define Limb_h

#include "Core/Mesh/Mesh.h"

#include <unordered_map>
#include <vector>

namespace models
{

/** A bent tube: a path, and the radius at each of its points. */
struct Limb
{
  std::vector<carving::Point> Path;
  std::vector<double> Radii;

  /** The point, the direction and the radius at a fraction of the path, 0 to 1. */
  carving::Point At(double fraction) const;
  carving::Point DirectionAt(double fraction) const;
  double RadiusAt(double fraction) const;

  /** Adds a closed solid with `sides` points around the path. The path must not bend much. */
  void AddTo(carving::TriangleMesh& mesh, int sides) const;
};

/** The space that limbs have claimed: balls around their paths, in a hash grid. */
class ClaimedSpace
{
public:
  explicit ClaimedSpace(double cellSize);

  /**
   * Claims the space of a limb. Returns false, and claims nothing, if another limb occupies some of
   * it.
   */
  bool Claim(const Limb& limb);

private:
  struct Ball
  {
    carving::Point Center;
    double Radius;
  };

  static std::vector<Ball> Cover(const Limb& limb);
  std::vector<long long> Cells(const Ball& ball) const;
  bool IsFree(const Ball& ball) const;

  double CellSize;
  std::unordered_map<long long, std::vector<Ball>> Balls;
};

} // namespace models

#endif
