// SPDX-License-Identifier: BSD-3-Clause
#include "Carver.h"

#include "Vector.h"

#include <algorithm>
#include <queue>

namespace carving
{
namespace
{

double LongestEdge(const Tetrahedralization& mesh, int cell)
{
  double longest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      longest = std::max(longest,
        Length(
          mesh.Surface.Points[mesh.Cells[cell][i]] - mesh.Surface.Points[mesh.Cells[cell][j]]));
    }
  }
  return longest;
}

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

class Carver
{
public:
  Carver(const Tetrahedralization& mesh, const Classification& regions, const CarveOptions& options,
    Stream& stream)
    : Mesh(mesh)
    , Options(options)
    , Out(stream)
    , Degree(mesh.Cells.size(), 0)
  {
    const int numberOfCells = static_cast<int>(mesh.Cells.size());
    this->Out.Step.assign(numberOfCells, Stream::Never);
    this->Out.Priority.assign(numberOfCells, std::numeric_limits<double>::quiet_NaN());
    this->Out.Depth.assign(numberOfCells, 0);
    this->Out.StepPriority.assign(1, std::numeric_limits<double>::quiet_NaN());
    std::vector<Entry> seeds(regions.Regions.size(), { -1.0, -1 });
    for (int cell = 0; cell < numberOfCells; ++cell)
    {
      const RegionKind kind = regions.Kind(cell);
      if (kind == RegionKind::Solid)
      {
        continue;
      }
      ++this->NumberToCarve;
      if (kind == RegionKind::Void)
      {
        Entry& seed = seeds[regions.RegionOfCell[cell]];
        seed = std::max(seed, { LongestEdge(mesh, cell), cell });
        continue;
      }
      for (int f = 0; f < 4; ++f)
      {
        if (mesh.Neighbors[cell][f] < 0 && mesh.Constraints[cell][f] < 0)
        {
          this->Expose(cell, 1);
        }
      }
    }
    for (const Entry& seed : seeds)
    {
      if (seed.Cell >= 0)
      {
        this->Expose(seed.Cell, 1);
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
      if (this->Out.Step[top.Cell] != Stream::Never)
      {
        continue; // an exposed cascade was faster
      }
      const int step = static_cast<int>(this->Out.StepPriority.size());
      this->Out.StepPriority.push_back(top.Priority);
      taken.assign(1, top.Cell);
      this->Out.Step[top.Cell] = step;
      // `taken` grows while it is walked: carving a tetrahedron can expose its neighbors.
      for (std::size_t i = 0; i < taken.size(); ++i)
      {
        this->ExposeNeighbors(taken[i], step, taken);
      }
      carved += static_cast<int>(taken.size());
    }
    return GoOn(progress, 1.0);
  }

private:
  /** One more face of the cell adjoins the exterior. */
  void Expose(int cell, int depth)
  {
    if (++this->Degree[cell] == 1)
    {
      this->Out.Depth[cell] = depth;
      this->Out.Priority[cell] = LongestEdge(this->Mesh, cell);
      this->Queue.push({ this->Out.Priority[cell], cell });
    }
  }

  void ExposeNeighbors(int cell, int step, std::vector<int>& taken)
  {
    for (int f = 0; f < 4; ++f)
    {
      const int neighbor = this->Mesh.Neighbors[cell][f];
      if (neighbor < 0 || this->Mesh.Constraints[cell][f] >= 0 ||
        this->Out.Step[neighbor] != Stream::Never)
      {
        continue;
      }
      this->Expose(neighbor, this->Out.Depth[cell] + 1);
      if (this->Options.CarveExposed && this->Degree[neighbor] > 1)
      {
        this->Out.Step[neighbor] = step;
        taken.push_back(neighbor);
      }
    }
  }

  const Tetrahedralization& Mesh;
  const CarveOptions& Options;
  Stream& Out;
  std::vector<unsigned char> Degree;
  std::priority_queue<Entry> Queue;
  int NumberToCarve = 0;
};

} // namespace

bool Carve(const Tetrahedralization& mesh, const Classification& regions,
  const CarveOptions& options, Stream& stream, const Progress& progress)
{
  return Carver(mesh, regions, options, stream).Run(progress);
}

} // namespace carving
