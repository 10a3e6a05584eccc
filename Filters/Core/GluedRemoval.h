// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What glued tetrahedra lose with one of them, as far as those around it tell.
 */
#ifndef carving_GluedRemoval_h
#define carving_GluedRemoval_h

#include <array>

namespace carving
{

/** The pairs of faces of a tetrahedron, and its edges, are numbered by EdgeIndex. */
struct GluedRemoval
{
  // Changes of these numbers.
  int Components = 0; ///< at most
  int Voids = 0;      ///< at most
  int EulerCharacteristic = 0;
  int GetTunnels() const ///< at most
  {
    return this->Components + this->Voids - this->EulerCharacteristic;
  }

  /** Per face: equal for those behind which the others hang together, -1 for no other. */
  std::array<int, 4> Parts = { -1, -1, -1, -1 };
  /**
   * Per corner: the others around it leave gaps along the boundary of the tetrahedron, which the exterior is
   * in. A bit for each edge at the corner that stands for one of them.
   */
  std::array<unsigned char, 4> Gaps = {};
  bool HasSeveralGaps = false; ///< at some corner

  /** What of the exterior is around each edge: a cell that is gone, Outside or Nothing. */
  std::array<int, 6> Exterior = {};
  static constexpr int Nothing = -2;
};

/**
 * Of a tetrahedron with others behind the faces in `held`, and the exterior around the edges in `touched`
 * between two such faces. An edge is in `closed` of a corner if others around that join the two.
 */
GluedRemoval Assess(unsigned held, unsigned touched, const std::array<unsigned, 4>& closed);

/** The same, with nothing closed, out of a table. */
const GluedRemoval& AssessApart(unsigned held, unsigned touched);

} // namespace carving

#endif
