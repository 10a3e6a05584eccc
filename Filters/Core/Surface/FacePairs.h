// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which two faces of a level belong together at a ridge where more than two meet.
 */
#ifndef carving_FacePairs_h
#define carving_FacePairs_h

#include "Core/Stream/Level.h"
#include "Core/Stream/Ridges.h"
#include "Core/Stream/StoredStream.h"

#include <vector>

namespace carving
{

/** The ridges of a level: that opposite to corner k of face i is its side D * i + k. */
struct FacePairs
{
  /** Per side: the side that it is joined with at their ridge, -1 for a boundary. */
  std::vector<int> Partner;
  /** The sides at each ridge that is more than two faces' of one kind and orientation. */
  std::vector<std::vector<int>> Crowded;

  void Join(int a, int b)
  {
    this->Partner[a] = b;
    this->Partner[b] = a;
  }
};

/**
 * Pairs the faces around each ridge by turns through the cells around it, never by angles: in space across
 * the exterior between them, in the plane, where two parts can only touch in a point, across the solid.
 * Folds of one side only are no part of the exterior's boundary, and paired with each other. With both sides
 * of folds, faces at a ridge of one are paired across the exterior.
 */
template <int D>
FacePairs PairFaces(const StoredStream<D>& stream, const Level<D>& level);

template <int D>
const FaceLife<D>& FaceAt(const Level<D>& level, int side)
{
  return level.Faces[side / D];
}

template <int D>
std::array<int, D - 1> RidgeAt(const Level<D>& level, int side)
{
  return RidgeOf<D>(FaceAt(level, side).Corners, side % D);
}

/** Whether the face passes the ridge in the ascending direction of its corners. */
template <int D>
bool IsForward(const Level<D>& level, int side)
{
  const std::array<int, D>& corners = FaceAt(level, side).Corners;
  const int k = side % D;
  if constexpr (D == 3)
  {
    return corners[(k + 1) % 3] < corners[(k + 2) % 3];
  }
  else
  {
    return k == 0; // the ridge is the end of the edge
  }
}

} // namespace carving

#endif
