// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The topology of what is left as its surface shows it once it is cut into manifolds.
 */
#ifndef carving_GluedCells_h
#define carving_GluedCells_h

#include "Connectivity.h"
#include "DisjointSets.h"
#include "Mesh.h"

#include <array>
#include <vector>

namespace carving
{

/**
 * N: the tetrahedra that are left, the solid's too, glued to each other at faces only. Where they touch in
 * edges and vertices alone, N is cut, as levels are; its tunnels are the genus of a level's surface.
 *
 * A tetrahedron T meets the others in those of its faces that have one behind them. When it goes, an edge
 * between two such faces falls apart in two if the exterior touches it, and a vertex if the faces around
 * it are no longer joined by tetrahedra around it. From these follows the Euler characteristic, always
 * exact. The number of components is an upper bound, and with it that of tunnels, until it is counted.
 */
class GluedCells
{
public:
  /** Per face of a tetrahedron: equal for those behind which the others hang together, -1 for no other. */
  using Labels = std::array<int, 4>;

  /** What would change if a tetrahedron went. */
  struct Removal
  {
    int Components; ///< at most
    int Voids;      ///< at most
    int EulerCharacteristic;
    Labels Parts; ///< per face, those of the components around it
  };

  /** Starts from C0, a ball. Follows the states of the cells; both must outlive this object. */
  GluedCells(const Decomposition<3>& mesh, const std::vector<CellState>& states);

  Removal Examine(int cell);
  /** Whether another one around any of its vertices has gone since the tetrahedron was examined. */
  bool HasChanged(int cell) const;
  /** Makes the change in components exact where parts are joined somewhere else. */
  void JoinParts(int cell, Removal& removal);
  void Carve(int cell, const Removal& removal);
  /**
   * The tetrahedron stays although N would fall into these parts without it. They can only be joined through
   * it, for as long as it stays: no other search has to go through it from one to the other.
   */
  void KeepAsBridge(int cell, const Removal& removal);
  /** How many parts of those around the tetrahedron are known to be apart without it. */
  int CountSides(int cell, const Removal& removal) const;

  /** At most. */
  int GetComponents() const
  {
    return this->Components;
  }
  /** At most; with what a removal would change. */
  int GetTunnels(const Removal& removal = {}) const
  {
    return this->Components + removal.Components + this->Voids + removal.Voids -
      this->EulerCharacteristic - removal.EulerCharacteristic;
  }

  /** Makes the number of components exact. */
  void CountComponents();

private:
  /** All that a walk has to know of a cell, in one place. */
  struct Record
  {
    Decomposition<3>::Cell Corners;
    Decomposition<3>::Cell Behind; ///< its faces: the other cells that are left, or -1
  };

  template <class Predicate>
  DisjointSets Glue(Predicate&& isOne) const;
  bool IsTouched(int cell, int p, int q) const;
  void Join(int cell, int vertex, Labels& labels);
  void Reach(int cell, int from, int f, Labels& labels, bool everywhere);
  int SideOf(int cell, int f) const
  {
    return this->Sides[cell] >> (2 * f) & 3;
  }

  const Decomposition<3>& Mesh;
  const std::vector<CellState>& States;
  std::vector<Record> Records;
  int Time = 0;             ///< how many have gone
  std::vector<int> Touched; ///< per vertex: when the last one around it went, 0 on C0; -1: none yet
  std::vector<int> LookedAt; ///< per cell: when it was examined last
  int Components = 1;
  int Voids = 0;
  int EulerCharacteristic = 1;
  std::vector<unsigned char> Sides; ///< per cell: faces with the same number are on one side of it
  // Of a search from behind the faces of a tetrahedron: 4 times a cell, plus the face it was entered by.
  std::array<std::vector<int>, 4> Reached;
  std::vector<int> ReachedBy; ///< per cell: 4 times the number of the last search, plus the face
  /** Per cell: the part of what stays for good that it belongs to, -1 for others. And per part as above. */
  std::vector<int> Block, BlockReachedBy;
  int Search = 0;
};

} // namespace carving

#endif
