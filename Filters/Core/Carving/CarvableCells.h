// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The cells of a mesh while they are carved.
 */
#ifndef carving_CarvableCells_h
#define carving_CarvableCells_h

#include "Core/Carving/Carver.h"
#include "Core/Mesh/LargePages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace carving
{

/** The priorities, depths and neighbors of cells, and which of them have been carved. */
template <int D>
class CarvableCells
{
public:
  /** The data of a cell, in one line of the cache: carving accesses cells in random order. */
  struct alignas(32) State
  {
    /** Per face: the neighbor that carving this cell exposes, or -1. */
    typename Decomposition<D>::Cell Next = {};
    unsigned Step : 29;    ///< in which the cell was carved, or 0; at most MaximumCells
    unsigned Degree : 3;   ///< the number of exterior faces
    int Level = 0;         ///< in the hierarchy of carvable cells (section 5.3), from 1 on
    double Priority = 0.0; ///< the measure until the cell becomes carvable, then equation (2)

    State()
      : Step(0)
      , Degree(0)
    {
    }

    bool IsCarved() const
    {
      return this->Step != 0;
    }
  };

  CarvableCells(const Decomposition<D>& mesh, const CarveOptions& options)
    : Options(options)
  {
    const std::vector<double> measure = ComputePriorities(mesh, options.Measure, options.Threads);
    this->States = MakeLarge<State>(measure.size());
    for (int cell = 0; cell < static_cast<int>(measure.size()); ++cell)
    {
      State& state = this->States[cell];
      state.Priority = measure[cell];
      for (int f = 0; f <= D; ++f)
      {
        const int neighbor = mesh.Neighbors[cell][f];
        const bool open = neighbor >= 0 && !mesh.Constraints.Has(cell, f) && !mesh.IsKept(neighbor);
        state.Next[f] = open ? neighbor : -1;
      }
    }
  }

  State& operator[](int cell)
  {
    return this->States[cell];
  }

  const State& operator[](int cell) const
  {
    return this->States[cell];
  }

  /**
   * The priority of a cell that becomes carvable, equation (2). Finite even if the power is not; 0
   * for a measure of 0.
   */
  double ComputePriority(int cell, int level) const
  {
    const double measure = this->States[cell].Priority;
    const double exponent = this->Options.DepthExponent;
    if (exponent == 0.0 || measure == 0.0)
    {
      return measure; // never 0 times a power, which may be infinite
    }
    return std::min(measure * std::pow(this->ComputeDepth(cell, level), -exponent),
      std::numeric_limits<double>::max());
  }

  /** Counts an exterior face. Returns whether it is the first, with which the cell is carvable. */
  bool Expose(int cell, int level)
  {
    State& state = this->States[cell];
    if (++state.Degree > 1)
    {
      return false;
    }
    state.Level = level;
    state.Priority = this->ComputePriority(cell, level);
    return true;
  }

  /** Writes the results per cell. Cells that stay have neither a priority nor a depth. */
  void Write(Stream& stream) const
  {
    const std::size_t count = this->States.size();
    stream.Step = MakeLarge<int>(count, Stream::Never);
    stream.Priority = MakeLarge<double>(count, std::numeric_limits<double>::quiet_NaN());
    stream.Depth = MakeLarge<double>(count);
    for (int cell = 0; cell < static_cast<int>(count); ++cell)
    {
      const State& state = this->States[cell];
      if (state.IsCarved())
      {
        stream.Step[cell] = static_cast<int>(state.Step);
        stream.Priority[cell] = state.Priority;
        stream.Depth[cell] = this->ComputeDepth(cell, state.Level);
      }
    }
  }

private:
  /** The given depth, or the level in the hierarchy. */
  double ComputeDepth(int cell, int level) const
  {
    return this->Options.Depths.empty() ? level : this->Options.Depths[cell];
  }

  const CarveOptions& Options;
  std::vector<State> States;
};

} // namespace carving

#endif
