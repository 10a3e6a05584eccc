// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/Carver.h"

#include "Core/Budget/Budget.h"
#include "Core/Carving/CarvableCells.h"
#include "Core/Carving/LoosePieces.h"
#include "Core/Mesh/Fetch.h"
#include "Core/Mesh/LargePages.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <queue>
#include <utility>

namespace carving
{
namespace
{

bool IsToBeCarved(RegionKind kind, const CarveOptions& options)
{
  return kind == RegionKind::Outside || (kind == RegionKind::Void && options.CarveVoids);
}

template <int D>
class Carver
{
public:
  Carver(const Decomposition<D>& mesh, const Classification& regions, const CarveOptions& options,
    Stream& stream)
    : Mesh(mesh)
    , Options(options)
    , Cells(mesh, options)
    , Out(stream)
  {
    const int numberOfCells = static_cast<int>(mesh.Cells.size());
    std::vector<Candidate> candidates;
    ReserveAtMost(candidates, numberOfCells);
    this->Queue = decltype(this->Queue)({}, std::move(candidates));
    std::vector<CellState> states = MakeLarge(numberOfCells, CellState::Carvable);
    std::vector<Candidate> seeds(regions.Regions.size(), { -1.0, -1 });
    for (int cell = 0; cell < numberOfCells; ++cell)
    {
      const RegionKind kind = regions.Kind(cell);
      if (!IsToBeCarved(kind, options))
      {
        states[cell] = CellState::Permanent;
        continue;
      }
      ++this->NumberToCarve;
      if (kind == RegionKind::Void)
      {
        Candidate& seed = seeds[regions.RegionOfCell[cell]];
        seed = std::max(seed, { this->Cells.ComputePriority(cell, 1), cell });
        continue;
      }
      for (int f = 0; f <= D; ++f)
      {
        if (mesh.Neighbors[cell][f] < 0 && !mesh.Constraints.Has(cell, f))
        {
          this->Expose(cell, 1);
        }
      }
    }
    ReserveAtMost(this->Out.StepPriority, this->NumberToCarve + 1);
    this->Out.StepPriority.assign(1, std::numeric_limits<double>::quiet_NaN());
    for (const Candidate& seed : seeds)
    {
      if (seed.Cell >= 0)
      {
        this->Expose(seed.Cell, 1);
      }
    }
    this->QueueExposed();
    if (HasLimits(options.Budget))
    {
      this->Limits = std::make_unique<Budget<D>>(mesh, states, options.Budget);
    }
  }

  bool Run(const Progress& progress)
  {
    constexpr int reportInterval = 4096;
    int carved = 0;
    std::vector<int> taken;
    Candidate next;
    for (int pops = 0; this->PopNext(next); ++pops)
    {
      if (pops % reportInterval == 0 &&
        !GoOn(progress, static_cast<double>(carved) / this->NumberToCarve))
      {
        return false;
      }
      const int step = static_cast<int>(this->Out.StepPriority.size());
      if (!this->Take(next.Cell, step))
      {
        continue;
      }
      this->Out.StepPriority.push_back(next.Priority);
      taken.assign(1, next.Cell);
      this->WalkBreadth(step, taken);
      if (this->Options.CarveExposed)
      {
        this->CascadeExposed(step, taken);
      }
      this->Requeued.clear();
      this->QueueExposed();
      carved += static_cast<int>(taken.size());
    }
    this->Cells.Write(this->Out);
    CarveLoosePieces(this->Mesh, this->Out);
    return GoOn(progress, 1.0);
  }

private:
  /** Prefetches a cell that will be needed soon. */
  void Fetch(int cell) const
  {
    Prefetch(&this->Cells[cell]);
    if (this->Limits)
    {
      this->Limits->Fetch(cell);
    }
  }

  void FetchTop() const
  {
    if (!this->Queue.empty())
    {
      this->Fetch(this->Queue.top().Cell);
    }
  }

  /** Counts an exterior face of a cell, which becomes carvable with its first one. */
  void Expose(int cell, int level)
  {
    if (this->Cells.Expose(cell, level))
    {
      this->Exposed.push_back(cell);
    }
  }

  /** Queues the cells that have become carvable, unless the same step has carved them. */
  void QueueExposed()
  {
    for (const int cell : this->Exposed)
    {
      if (!this->Cells[cell].IsCarved())
      {
        this->Queue.push({ this->Cells[cell].Priority, cell });
      }
    }
    this->Exposed.clear();
  }

  /** The carvable cell with the highest priority, from the queue or from the deferred cells. */
  bool PopNext(Candidate& next)
  {
    for (;;)
    {
      const Candidate* deferred = this->Limits ? this->Limits->GetBest() : nullptr;
      if (deferred && (this->Queue.empty() || this->Queue.top() < *deferred))
      {
        next = *deferred;
        this->Limits->PopBest();
        return true;
      }
      if (this->Queue.empty())
      {
        return false;
      }
      next = this->Queue.top();
      this->Queue.pop();
      this->FetchTop();
      // The other entries are out of date: their cells have been carved in another's step, or
      // deferred.
      if (!this->Cells[next.Cell].IsCarved() && !this->IsDeferred(next.Cell))
      {
        return true;
      }
    }
  }

  bool IsDeferred(int cell) const
  {
    return this->Limits && this->Limits->IsDeferred(cell);
  }

  /** Carves the cell unless that would exceed the budget. */
  bool Take(int cell, int step)
  {
    if (this->Limits && !this->Admit(cell))
    {
      return false;
    }
    this->Cells[cell].Step = static_cast<unsigned>(step);
    return true;
  }

  bool Admit(int cell)
  {
    // A deferred cell has been examined since its neighborhood last changed.
    if (this->IsDeferred(cell) || !this->Limits->Admit({ this->Cells[cell].Priority, cell }))
    {
      return false;
    }
    for (const int other : this->Limits->GetRequeued())
    {
      this->Queue.push({ this->Cells[other].Priority, other });
      this->Requeued.push_back(other);
    }
    return true;
  }

  /** Calls `visit` with every remaining neighbor of which carving the cell exposes a face. */
  template <class Visitor>
  void ForEachCarvableNeighbor(int cell, Visitor&& visit)
  {
    for (const int neighbor : this->Cells[cell].Next)
    {
      if (neighbor >= 0 && !this->Cells[neighbor].IsCarved())
      {
        visit(neighbor);
      }
    }
  }

  /**
   * Carves from the popped cell outward to the breadth radius (section 5.4). Appends to `taken`.
   */
  void WalkBreadth(int step, std::vector<int>& taken)
  {
    const double radius = this->Options.BreadthRadius;
    const Point center = radius > 0.0 ? this->Mesh.Centroid(taken[0]) : Point();
    for (std::size_t i = 0; i < taken.size(); ++i)
    {
      for (const int neighbor : this->Cells[taken[i]].Next)
      {
        this->Fetch(std::max(neighbor, 0)); // all four, before the first access waits
      }
      this->ForEachCarvableNeighbor(taken[i],
        [&](int neighbor)
        {
          this->Expose(neighbor, this->Cells[taken[i]].Level + 1);
          if (radius > 0.0 && Length(this->Mesh.Centroid(neighbor) - center) <= radius &&
            this->Take(neighbor, step))
          {
            taken.push_back(neighbor);
          }
        });
    }
  }

  /**
   * Carves the cells that `taken` exposes, and those exposed by these in turn (section 3.4).
   * Appends to `taken`.
   */
  void CascadeExposed(int step, std::vector<int>& taken)
  {
    const std::size_t walked = taken.size();
    for (std::size_t i = 0; i < taken.size(); ++i)
    {
      this->ForEachCarvableNeighbor(taken[i],
        [&](int neighbor)
        {
          if (i >= walked) // the breadth walk has counted the faces of its neighbors
          {
            this->Expose(neighbor, this->Cells[taken[i]].Level + 1);
          }
          if (this->Cells[neighbor].Degree > 1 && this->Take(neighbor, step))
          {
            taken.push_back(neighbor);
          }
        });
      // Cells that were exposed before and have been requeued by the budget.
      for (std::size_t j = 0; j < this->Requeued.size(); ++j)
      {
        const int cell = this->Requeued[j];
        const auto& state = this->Cells[cell];
        if (!state.IsCarved() && !this->IsDeferred(cell) && state.Degree > 1 &&
          this->Take(cell, step))
        {
          taken.push_back(cell);
        }
      }
      this->Requeued.clear();
    }
  }

  const Decomposition<D>& Mesh;
  const CarveOptions& Options;
  CarvableCells<D> Cells;
  Stream& Out;
  std::priority_queue<Candidate> Queue;
  std::vector<int> Exposed;          ///< cells that have become carvable in this step
  std::unique_ptr<Budget<D>> Limits; ///< null without a budget
  std::vector<int> Requeued;         ///< deferred cells that returned to the queue in this step
  int NumberToCarve = 0;
};

} // namespace

template <int D>
bool Carve(const Decomposition<D>& mesh, const Classification& regions, const CarveOptions& options,
  Stream& stream, const Progress& progress)
{
  return Carver<D>(mesh, regions, options, stream).Run(progress);
}

int CountLeft(const Classification& regions, const CarveOptions& options, const Stream& stream)
{
  int count = 0;
  for (int cell = 0; cell < static_cast<int>(stream.Step.size()); ++cell)
  {
    count += stream.Step[cell] == Stream::Never && IsToBeCarved(regions.Kind(cell), options);
  }
  return count;
}

template bool Carve<2>(
  const Decomposition<2>&, const Classification&, const CarveOptions&, Stream&, const Progress&);
template bool Carve<3>(
  const Decomposition<3>&, const Classification&, const CarveOptions&, Stream&, const Progress&);

} // namespace carving
