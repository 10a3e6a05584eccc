// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Measure/StreamTopology.h"

#include "Core/Measure/EulerCharacteristics.h"
#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/Fetch.h"
#include "Core/Mesh/LargePages.h"

#include <algorithm>
#include <numeric>

namespace carving
{
namespace
{

/** The number of components of a growing set of simplices. */
class GrowingComponents
{
public:
  explicit GrowingComponents(std::size_t numberOfPoints)
    : Sets(numberOfPoints)
    , Present(numberOfPoints, 0)
  {
  }

  template <class Simplex>
  void Add(const Simplex& corners)
  {
    for (const int vertex : corners)
    {
      this->Count += !this->Present[vertex];
      this->Present[vertex] = 1;
    }
    this->Join(corners);
  }

  /** Connects vertices that are present. */
  template <class Vertices>
  void Join(const Vertices& vertices)
  {
    int set = this->Sets.Find(vertices[0]);
    for (const int vertex : vertices)
    {
      const int other = this->Sets.Find(vertex);
      if (other != set)
      {
        this->Sets.Unite(set, other);
        set = std::min(set, other);
        --this->Count;
      }
    }
  }

  /** Per vertex: the number of its component, or -1 if it is in none. */
  std::vector<int> GetLabels()
  {
    std::vector<int> labels = MakeLarge<int>(this->Present.size(), -1);
    for (int vertex = 0; vertex < static_cast<int>(labels.size()); ++vertex)
    {
      labels[vertex] = this->Present[vertex] ? this->Sets.Find(vertex) : -1;
    }
    return labels;
  }

  int Count = 0;

private:
  DisjointSets Sets;
  std::vector<char> Present;
};

/** Connects the facets of M around each region of the solid whose cells the mesh lacks. */
template <int D>
void JoinAroundSolid(
  const Decomposition<D>& mesh, const Classification& regions, GrowingComponents& components)
{
  constexpr int none = -1;
  std::vector<int> vertexOf(regions.Regions.size(), none);
  for (std::size_t facet = 0; facet < regions.SolidRegions.size(); ++facet)
  {
    const int vertex = mesh.Surface.Facets[facet][0];
    for (const int region : regions.SolidRegions[facet])
    {
      if (region >= 0)
      {
        vertexOf[region] = vertexOf[region] == none ? vertex : vertexOf[region];
        components.Join(std::array<int, 2>{ vertex, vertexOf[region] });
      }
    }
  }
}

/**
 * The carved cells that join components, by the step that carves them. `components` are those of
 * the last approximation: a cell within one of them never changes the number.
 */
template <int D>
Buckets<int> FindJoiningCells(
  const Decomposition<D>& mesh, const Stream& stream, GrowingComponents& components)
{
  const std::vector<int> labels = components.GetLabels();
  const auto isWithinOne = [&](const auto& corners)
  {
    const int label = labels[corners[0]];
    bool within = label >= 0; // no early exit: no branch could be predicted
    for (const int vertex : corners)
    {
      within &= labels[vertex] == label;
    }
    return within;
  };
  std::vector<int> joining;
  ReserveAtMost(joining, mesh.Cells.size());
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    if (stream.Step[cell] != Stream::Never && !isWithinOne(mesh.Cells[cell]))
    {
      joining.push_back(cell);
    }
  }
  return Buckets<int>(stream.LastStep() + 1,
    [&](auto&& visit)
    {
      for (const int cell : joining)
      {
        visit(stream.Step[cell], cell);
      }
    });
}

template <int D>
std::vector<int> CountComponents(
  const Decomposition<D>& mesh, const Classification& regions, const Stream& stream)
{
  GrowingComponents components(mesh.Surface.Points.size());
  for (const auto& facet : mesh.Surface.Facets)
  {
    components.Add(facet);
  }
  JoinAroundSolid(mesh, regions, components);
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    if (stream.Step[cell] == Stream::Never)
    {
      components.Add(mesh.Cells[cell]);
    }
  }
  const Buckets<int> byStep = FindJoiningCells(mesh, stream, components);
  const std::vector<int>& sorted = byStep.GetItems();
  std::vector<int> counts = MakeLarge<int>(stream.LastStep() + 1);
  constexpr int ahead = 16; // cells are scattered in memory and are prefetched
  auto next = sorted.rbegin();
  for (int step = stream.LastStep(); step >= 0; --step)
  {
    for (; next != sorted.rend() && stream.Step[*next] > step; ++next)
    {
      if (sorted.rend() - next > ahead)
      {
        Prefetch(&mesh.Cells[next[ahead]]);
        Prefetch(&stream.Step[next[ahead]]);
      }
      components.Add(mesh.Cells[*next]);
    }
    counts[step] = components.Count;
  }
  return counts;
}

std::vector<int> CountVoids(const Classification& regions, const Stream& stream)
{
  std::vector<int> opening(regions.Regions.size(), Stream::Never);
  for (std::size_t cell = 0; cell < stream.Step.size(); ++cell)
  {
    int& first = opening[regions.RegionOfCell[cell]];
    first = std::min(first, stream.Step[cell]);
  }
  std::vector<int> counts = MakeLarge<int>(stream.LastStep() + 1);
  for (std::size_t region = 0; region < opening.size(); ++region)
  {
    if (regions.Regions[region].Kind == RegionKind::Void && opening[region] != Stream::Never)
    {
      ++counts[opening[region]];
    }
  }
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
  return counts;
}

} // namespace

template <int D>
StreamTopology ComputeTopology(
  const Decomposition<D>& mesh, const Classification& regions, const Stream& stream)
{
  StreamTopology result;
  result.Components = CountComponents(mesh, regions, stream);
  result.Voids = D == 3 ? CountVoids(regions, stream) : std::vector<int>(stream.LastStep() + 1, 0);
  result.Tunnels = ComputeEulerCharacteristics(mesh, stream);
  for (std::size_t step = 0; step < result.Tunnels.size(); ++step)
  {
    result.Tunnels[step] = result.Components[step] + result.Voids[step] - result.Tunnels[step];
  }
  return result;
}

template StreamTopology ComputeTopology<2>(
  const Decomposition<2>&, const Classification&, const Stream&);
template StreamTopology ComputeTopology<3>(
  const Decomposition<3>&, const Classification&, const Stream&);

} // namespace carving
