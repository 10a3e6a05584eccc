// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The topology of what is left as its surface shows it once it is cut into manifolds.
 */
#ifndef carving_GluedCells_h
#define carving_GluedCells_h

#include "GluedParts.h"
#include "GluedRemoval.h"
#include "LeftCells.h"
#include "Mesh.h"

#include <array>
#include <cstddef>
#include <utility>
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
  /** Starts from C0, a ball. Follows the states of the cells; both must outlive this object. */
  GluedCells(const Decomposition<3>& mesh, const LeftCells<3>& cells);

  /** Has the processor fetch what it needs to know of a cell that may soon be examined. */
  void Fetch(int cell) const
  {
    __builtin_prefetch(&this->Next[4 * static_cast<std::size_t>(cell)]);
  }

  GluedRemoval Examine(int cell);
  /** From now on, until it is examined again: notes when it would no longer fare as it has. */
  void Watch(int cell);
  /** Those watched of which Examine may now say something else. They are no longer watched. */
  std::vector<int> TakeChanged()
  {
    return std::exchange(this->Changed, {});
  }
  /** Makes the change in components exact where parts are joined somewhere else. */
  void JoinParts(int cell, GluedRemoval& removal);
  void Carve(int cell, const GluedRemoval& removal);
  GluedParts& GetParts()
  {
    return this->Parts;
  }

  /** At most. */
  int GetComponents() const
  {
    return this->Components;
  }
  /** At most. */
  int GetTunnels() const
  {
    return this->Components + this->Voids - this->EulerCharacteristic;
  }

  /** Makes the number of components exact. */
  void CountComponents()
  {
    this->Components = this->Parts.CountComponents();
  }

private:
  static constexpr int Nothing = GluedRemoval::Nothing;

  int FindExterior(int cell, int p, int q) const;
  int GetCorner(int cell, int vertex) const;
  int FindRoot(int corner);
  bool Merge(int cell, int corner, const GluedRemoval& removal);
  void Notify(int cell);
  void NotifyAround(int vertex);
  void NotifyAround(int cell, int p, int q);
  unsigned FindClosed(int cell, int corner, unsigned gaps, const std::array<int, 6>& exterior);

  const LeftCells<3>& Cells;
  std::vector<char> Touched; ///< per vertex: whether the exterior is somewhere around it
  std::vector<char> Watched; ///< per cell
  std::vector<int> Changed;
  struct Watcher
  {
    int Cell;
    int Next; ///< in the list, or -1
  };
  std::vector<Watcher> Watchers;
  std::vector<int> FirstWatcher; ///< per vertex: the list of those around it that have been watched
  /**
   * The link of a vertex is a sphere, of which the exterior has a part. Per corner of each cell, and then per
   * vertex for what is outside C0: another corner, of a cell that is gone, with which it hangs together
   * around the vertex, be it in an edge; itself if there is none. These are trees.
   */
  std::vector<int> Next;
  int Components = 1;
  int Voids = 0;
  int EulerCharacteristic = 1;
  GluedParts Parts;
};

} // namespace carving

#endif
