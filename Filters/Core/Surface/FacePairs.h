// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The pairing of faces at ridges where more than two faces of a level meet.
 */
#ifndef carving_FacePairs_h
#define carving_FacePairs_h

#include "Core/Stream/Level.h"
#include "Core/Stream/Ridges.h"
#include "Core/Stream/StoredStream.h"

#include <vector>

namespace carving
{

/**
 * The joined sides of a level's faces. Side D * i + k of a level is the ridge opposite to corner k
 * of face i.
 */
struct FacePairs
{
  /** Per side: the side that it is joined to at their common ridge; -1 at a boundary. */
  std::vector<int> Partner;
  /** Per ridge that is not shared by just two matching faces: the sides there. */
  std::vector<std::vector<int>> Crowded;

  void Join(int a, int b)
  {
    this->Partner[a] = b;
    this->Partner[b] = a;
  }
};

/**
 * Pairs the faces around each ridge by rotation through the cells around the ridge, never by
 * angles. Two paired faces have the exterior between them in space, and the solid between them in
 * the plane, where two parts can only touch in a point. Folds that show one side do not bound the
 * exterior and are paired with each other. Folds that show both sides are paired across the
 * exterior, as are the other faces at their ridges.
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

/** Whether the face traverses the ridge towards its greater corner. */
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
