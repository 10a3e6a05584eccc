// SPDX-License-Identifier: BSD-3-Clause
#include "Carver.h"

#include "Vector.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace carving
{
namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

struct Entry
{
  double Priority;
  int Cell;

  /** Order of a std::priority_queue: the greatest is popped first. */
  bool operator<(const Entry& other) const
  {
    return this->Priority != other.Priority ? this->Priority < other.Priority
                                            : this->Cell > other.Cell;
  }
};

/** What carving needs to know of a cell, in one place: it goes from cell to cell all over memory. */
template <int D>
struct State
{
  typename Decomposition<D>::Cell Next; ///< the neighbors that carving exposes a face of, or -1
  int Step = Stream::Never;
  int Degree = 0;
  double Priority; ///< until it becomes carvable, without regard to depth
  double Depth = 0.0;
};

template <int D>
class Carver
{
public:
  Carver(const Decomposition<D>& mesh, const Classification& regions, const CarveOptions& options,
    Stream& stream)
    : Mesh(mesh)
    , Options(options)
    , Out(stream)
  {
    this->PrepareCells();
    const int numberOfCells = static_cast<int>(mesh.Cells.size());
    this->Out.StepPriority.assign(1, NaN);
    std::vector<Entry> seeds(regions.Regions.size(), { -1.0, -1 });
    for (int cell = 0; cell < numberOfCells; ++cell)
    {
      const RegionKind kind = regions.Kind(cell);
      if (kind == RegionKind::Solid || kind == RegionKind::Kept ||
        (kind == RegionKind::Void && !options.CarveVoids))
      {
        continue;
      }
      ++this->NumberToCarve;
      if (kind == RegionKind::Void)
      {
        Entry& seed = seeds[regions.RegionOfCell[cell]];
        seed = std::max(seed, { this->ComputePriority(cell, this->ComputeDepth(cell, 1.0)), cell });
        continue;
      }
      for (int f = 0; f <= D; ++f)
      {
        if (mesh.Neighbors[cell][f] < 0 && mesh.Constraints[cell][f] < 0)
        {
          this->Expose(cell, 1.0);
        }
      }
    }
    for (const Entry& seed : seeds)
    {
      if (seed.Cell >= 0)
      {
        this->Expose(seed.Cell, 1.0);
      }
    }
  }

  bool Run(const Progress& progress)
  {
    constexpr int reportInterval = 4096;
    int carved = 0;
    std::vector<int> taken;
    for (int pops = 0; !this->Queue.empty(); ++pops)
    {
      if (pops % reportInterval == 0 &&
        !GoOn(progress, static_cast<double>(carved) / this->NumberToCarve))
      {
        return false;
      }
      const Entry top = this->Queue.top();
      this->Queue.pop();
      this->FetchTop();
      if (this->Cells[top.Cell].Step != Stream::Never)
      {
        continue; // carved along with another one
      }
      const int step = static_cast<int>(this->Out.StepPriority.size());
      this->Out.StepPriority.push_back(top.Priority);
      taken.assign(1, top.Cell);
      this->Cells[top.Cell].Step = step;
      this->WalkBreadth(step, taken);
      if (this->Options.CarveExposed)
      {
        this->CascadeExposed(step, taken);
      }
      carved += static_cast<int>(taken.size());
    }
    this->Write();
    return GoOn(progress, 1.0);
  }

private:
  void PrepareCells()
  {
    const std::vector<double> measure = ComputePriorities(this->Mesh, this->Options.Measure);
    this->Cells.resize(measure.size());
    for (std::size_t cell = 0; cell < this->Cells.size(); ++cell)
    {
      State<D>& state = this->Cells[cell];
      state.Priority = measure[cell];
      for (int f = 0; f <= D; ++f)
      {
        const int neighbor = this->Mesh.Neighbors[cell][f];
        const bool open =
          neighbor >= 0 && this->Mesh.Constraints[cell][f] < 0 && !this->Mesh.IsKept(neighbor);
        state.Next[f] = open ? neighbor : -1;
      }
    }
  }

  void Write()
  {
    this->Out.Step.clear();
    this->Out.Priority.clear();
    this->Out.Depth.clear();
    this->Out.Step.reserve(this->Cells.size());
    this->Out.Priority.reserve(this->Cells.size());
    this->Out.Depth.reserve(this->Cells.size());
    for (const State<D>& state : this->Cells)
    {
      this->Out.Step.push_back(state.Step);
      this->Out.Priority.push_back(state.Degree > 0 ? state.Priority : NaN);
      this->Out.Depth.push_back(state.Depth);
    }
  }

  /** Has the processor fetch a cell that will be needed soon. */
  void Fetch(int cell) const
  {
    __builtin_prefetch(&this->Cells[cell]);
  }

  void FetchTop() const
  {
    if (!this->Queue.empty())
    {
      this->Fetch(this->Queue.top().Cell);
    }
  }

  /** The given depth, or the one in the hierarchy. */
  double ComputeDepth(int cell, double hierarchical) const
  {
    return this->Options.Depths.empty() ? hierarchical : this->Options.Depths[cell];
  }

  /** Equation (2). */
  double ComputePriority(int cell, double depth) const
  {
    const double measure = this->Cells[cell].Priority;
    const double exponent = this->Options.DepthExponent;
    return exponent == 0.0 ? measure : measure * std::pow(depth, -exponent);
  }

  /** One more face of the cell adjoins the exterior. */
  void Expose(int cell, double hierarchicalDepth)
  {
    State<D>& state = this->Cells[cell];
    if (++state.Degree == 1)
    {
      state.Depth = this->ComputeDepth(cell, hierarchicalDepth);
      state.Priority = this->ComputePriority(cell, state.Depth);
      this->Queue.push({ state.Priority, cell });
    }
  }

  /** Calls `visit` with every tetrahedron that carving the cell exposes one more face of. */
  template <class Visitor>
  void ForEachCarvableNeighbor(int cell, Visitor&& visit)
  {
    for (const int neighbor : this->Cells[cell].Next)
    {
      if (neighbor >= 0 && this->Cells[neighbor].Step == Stream::Never)
      {
        visit(neighbor);
      }
    }
  }

  /** Carves from the popped tetrahedron outward to the radius; `taken` grows while it is walked. */
  void WalkBreadth(int step, std::vector<int>& taken)
  {
    const double radius = this->Options.BreadthRadius;
    const Point center = radius > 0.0 ? this->Mesh.Centroid(taken[0]) : Point();
    for (std::size_t i = 0; i < taken.size(); ++i)
    {
      for (const int neighbor : this->Cells[taken[i]].Next)
      {
        this->Fetch(std::max(neighbor, 0)); // all at once, before they are waited for one by one
      }
      this->ForEachCarvableNeighbor(taken[i],
        [&](int neighbor)
        {
          this->Expose(neighbor, this->Cells[taken[i]].Depth + 1.0);
          if (radius > 0.0 && Length(this->Mesh.Centroid(neighbor) - center) <= radius)
          {
            this->Cells[neighbor].Step = step;
            taken.push_back(neighbor);
          }
        });
    }
  }

  /** Carves what `taken` exposed, and what that exposes in turn. */
  void CascadeExposed(int step, std::vector<int>& taken)
  {
    const std::size_t walked = taken.size();
    for (std::size_t i = 0; i < taken.size(); ++i)
    {
      this->ForEachCarvableNeighbor(taken[i],
        [&](int neighbor)
        {
          if (i >= walked) // the walk has counted the faces of its own neighbors
          {
            this->Expose(neighbor, this->Cells[taken[i]].Depth + 1.0);
          }
          if (this->Cells[neighbor].Degree > 1)
          {
            this->Cells[neighbor].Step = step;
            taken.push_back(neighbor);
          }
        });
    }
  }

  const Decomposition<D>& Mesh;
  const CarveOptions& Options;
  Stream& Out;
  std::vector<State<D>> Cells;
  std::priority_queue<Entry> Queue;
  int NumberToCarve = 0;
};

} // namespace

template <int D>
bool Carve(const Decomposition<D>& mesh, const Classification& regions, const CarveOptions& options,
  Stream& stream, const Progress& progress)
{
  return Carver<D>(mesh, regions, options, stream).Run(progress);
}

template bool Carve<2>(
  const Decomposition<2>&, const Classification&, const CarveOptions&, Stream&, const Progress&);
template bool Carve<3>(
  const Decomposition<3>&, const Classification&, const CarveOptions&, Stream&, const Progress&);

} // namespace carving
