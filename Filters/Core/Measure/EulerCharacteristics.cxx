// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Measure/EulerCharacteristics.h"

#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/Fetch.h"
#include "Core/Mesh/LargePages.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace carving
{
namespace
{

/** An edge whose cells are all removed after `Step`, as recorded by one of them. */
struct EdgeEnd
{
  std::array<int, 2> Edge;
  int Step;
};

/**
 * The changes of V - E + F - T, step by step.
 *
 * A face vanishes with the later of its two cells. An edge vanishes with the last of the cells
 * around it, which is removed after both of its neighbors in the rotation around the edge. So each
 * cell records the faces that are its own alone when it is removed, and the edges between two such
 * faces.
 */
template <int D>
class EulerCharacteristics
{
public:
  EulerCharacteristics(const Decomposition<D>& mesh, const Stream& stream)
    : Mesh(mesh)
    , Step(stream.Step)
    , Changes(MakeLarge<int>(stream.LastStep() + 1))
    , IsOfSurface(mesh.Surface.Points.size(), 0)
    , VertexEnds(MakeLarge<int>(mesh.Surface.Points.size()))
  {
  }

  std::vector<int> Compute()
  {
    this->Changes[0] = 1; // C0 is a ball
    // Most cells record one edge.
    ReserveAtMost(
      this->EdgeEnds, 3 * this->Mesh.Surface.Facets.size() + 3 * this->Mesh.Cells.size() / 2);
    for (const auto& facet : this->Mesh.Surface.Facets)
    {
      this->AddSurfaceFacet(facet);
    }
    for (int cell = 0; cell < static_cast<int>(this->Mesh.Cells.size()); ++cell)
    {
      FetchAhead(this->Mesh, cell, this->Step);
      for (const int vertex : this->Mesh.Cells[cell])
      {
        this->VertexEnds[vertex] = std::max(this->VertexEnds[vertex], this->Step[cell]);
      }
      if (this->Step[cell] == Stream::Never)
      {
        this->AddKeptCell(cell);
      }
      else
      {
        this->AddCarvedCell(cell);
      }
    }
    for (std::size_t vertex = 0; vertex < this->VertexEnds.size(); ++vertex)
    {
      if (!this->IsOfSurface[vertex])
      {
        this->Vanish(0, this->VertexEnds[vertex]);
      }
    }
    this->CountEdges();
    std::partial_sum(this->Changes.begin(), this->Changes.end(), this->Changes.begin());
    return std::move(this->Changes);
  }

private:
  /** A vertex or an edge vanishes. Step 0 stands for vertices without cells. */
  void Vanish(int dimension, int step)
  {
    if (step > 0 && step != Stream::Never)
    {
      this->Changes[step] += dimension == 0 ? -1 : 1;
    }
  }

  /** The facets of M stay, with their edges and vertices. */
  void AddSurfaceFacet(const std::array<int, D>& facet)
  {
    for (int i = 0; i < D; ++i)
    {
      this->IsOfSurface[facet[i]] = 1;
      if constexpr (D == 3)
      {
        this->AddEdge(facet[i], facet[(i + 1) % 3], Stream::Never);
      }
    }
  }

  /** Records the edges at which this cell, which stays, adjoins a carved one. */
  void AddKeptCell(int cell)
  {
    if constexpr (D == 3)
    {
      for (int f = 0; f < 4; ++f)
      {
        const int neighbor = this->Mesh.Neighbors[cell][f];
        if (neighbor >= 0 && this->Step[neighbor] != Stream::Never &&
          !this->Mesh.Constraints.Has(cell, f))
        {
          const auto [a, b, c] = this->Mesh.OutwardFace(cell, f);
          this->AddEdge(a, b, Stream::Never);
          this->AddEdge(b, c, Stream::Never);
          this->AddEdge(c, a, Stream::Never);
        }
      }
    }
  }

  void AddCarvedCell(int cell)
  {
    const int step = this->Step[cell];
    // A bit per face that is this cell's alone. Branch-free, since no branch could be predicted.
    unsigned int ended = 0;
    for (int f = 0; f <= D; ++f)
    {
      const int neighbor = this->Mesh.Neighbors[cell][f];
      const int other = this->Step[std::max(neighbor, 0)];
      const bool before = (neighbor < 0) | (other < step) | ((other == step) & (neighbor < cell));
      ended |= static_cast<unsigned int>(before & !this->Mesh.Constraints.Has(cell, f)) << f;
    }
    constexpr int bits[16] = { 0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4 };
    this->Changes[step] += D % 2 == 0 ? bits[ended] - 1 : 1 - bits[ended];
    if constexpr (D == 3)
    {
      // Edge i is shared by the faces opposite to the other two corners.
      constexpr unsigned int opposite[6] = { 0b1100, 0b1010, 0b0110, 0b1001, 0b0101, 0b0011 };
      constexpr int edges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
      const auto& corners = this->Mesh.Cells[cell];
      for (int i = 0; bits[ended] > 1 && i < 6; ++i)
      {
        if ((ended & opposite[i]) == opposite[i])
        {
          this->AddEdge(corners[edges[i][0]], corners[edges[i][1]], step);
        }
      }
    }
  }

  void AddEdge(int a, int b, int step)
  {
    this->EdgeEnds.push_back({ { std::min(a, b), std::max(a, b) }, step });
  }

  /** An edge vanishes in the latest step that any of its cells recorded for it. */
  void CountEdges()
  {
    using End = std::pair<int, int>; // the other vertex, the step
    Buckets<End> ends(this->Mesh.Surface.Points.size(),
      [this](auto&& visit)
      {
        for (const EdgeEnd& end : this->EdgeEnds)
        {
          visit(end.Edge[0], End(end.Edge[1], end.Step));
        }
      });
    // Per other vertex: the last vertex that it shared an edge with, and the edge's entry in
    // `steps`.
    auto last = MakeLarge<std::pair<int, int>>(this->Mesh.Surface.Points.size(), { -1, 0 });
    std::vector<int> steps;
    for (int vertex = 0; vertex < ends.GetNumberOfBuckets(); ++vertex)
    {
      steps.clear();
      for (const auto& [other, step] : ends[vertex])
      {
        if (last[other].first != vertex)
        {
          last[other] = { vertex, static_cast<int>(steps.size()) };
          steps.push_back(step);
        }
        int& latest = steps[last[other].second];
        latest = std::max(latest, step);
      }
      for (const int step : steps)
      {
        this->Vanish(1, step);
      }
    }
  }

  const Decomposition<D>& Mesh;
  const std::vector<int>& Step;
  std::vector<int> Changes;
  std::vector<char> IsOfSurface; ///< per vertex: it is one of M and stays
  std::vector<int> VertexEnds;   ///< per vertex: the step of the last cell around it
  std::vector<EdgeEnd> EdgeEnds;
};

} // namespace

template <int D>
std::vector<int> ComputeEulerCharacteristics(const Decomposition<D>& mesh, const Stream& stream)
{
  return EulerCharacteristics<D>(mesh, stream).Compute();
}

template std::vector<int> ComputeEulerCharacteristics<2>(const Decomposition<2>&, const Stream&);
template std::vector<int> ComputeEulerCharacteristics<3>(const Decomposition<3>&, const Stream&);

} // namespace carving
