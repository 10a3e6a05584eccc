// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Budget/VertexGraph.h"

#include "Core/Mesh/DisjointSets.h"

#include <algorithm>

namespace carving
{

template <int D>
VertexGraph<D>::VertexGraph(const Decomposition<D>& mesh, const std::vector<CellState>& states)
  : Mesh(mesh)
  , States(states)
  , SidesOf(mesh.Cells.size())
{
}

/** Unites the vertices of each component of M and the permanent cells, on the first call. */
template <int D>
void VertexGraph<D>::FindNodes()
{
  if (!this->NodeOf.empty())
  {
    return;
  }
  const std::size_t numberOfVertices = this->Mesh.Surface.Points.size();
  DisjointSets sets(numberOfVertices);
  const auto uniteAll = [&](const auto& corners)
  {
    for (const int corner : corners)
    {
      sets.Unite(corner, corners[0]);
    }
  };
  for (const auto& facet : this->Mesh.Surface.Facets)
  {
    uniteAll(facet);
  }
  for (std::size_t cell = 0; cell < this->Mesh.Cells.size(); ++cell)
  {
    if (this->States[cell] == CellState::Permanent)
    {
      uniteAll(this->Mesh.Cells[cell]);
    }
  }
  this->NodeOf.resize(numberOfVertices);
  for (std::size_t vertex = 0; vertex < numberOfVertices; ++vertex)
  {
    this->NodeOf[vertex] = sets.Find(static_cast<int>(vertex));
  }
  this->Reached.resize(numberOfVertices, {});
}

template <int D>
int VertexGraph<D>::CountComponents()
{
  this->FindNodes();
  DisjointSets sets(this->NodeOf.size());
  std::vector<char> remains(this->NodeOf.size(), 0); // per node
  for (const auto& facet : this->Mesh.Surface.Facets)
  {
    remains[this->NodeOf[facet[0]]] = 1;
  }
  for (std::size_t cell = 0; cell < this->Mesh.Cells.size(); ++cell)
  {
    if (this->States[cell] == CellState::Carved)
    {
      continue;
    }
    const int first = this->NodeOf[this->Mesh.Cells[cell][0]];
    for (const int corner : this->Mesh.Cells[cell])
    {
      remains[this->NodeOf[corner]] = 1;
      sets.Unite(this->NodeOf[corner], first);
    }
  }
  int components = 0;
  for (int node = 0; node < static_cast<int>(this->NodeOf.size()); ++node)
  {
    components += remains[node] && sets.Find(node) == node;
  }
  return components;
}

/** Calls `visit(lower, upper, cell)` for every pair of nodes that a carvable cell joins. */
template <int D>
template <class Visitor>
void VertexGraph<D>::ForEachPair(Visitor&& visit) const
{
  for (int cell = 0; cell < static_cast<int>(this->Mesh.Cells.size()); ++cell)
  {
    if (this->States[cell] != CellState::Carvable)
    {
      continue;
    }
    std::array<int, D + 1> nodes;
    std::transform(this->Mesh.Cells[cell].begin(), this->Mesh.Cells[cell].end(), nodes.begin(),
      [this](int vertex) { return this->NodeOf[vertex]; });
    std::sort(nodes.begin(), nodes.end());
    const auto end = std::unique(nodes.begin(), nodes.end());
    for (auto upper = nodes.begin(); upper != end; ++upper)
    {
      for (auto lower = nodes.begin(); lower != upper; ++lower)
      {
        visit(*lower, *upper, cell);
      }
    }
  }
}

/** Sorts the pairs by nodes: bucketed by the lower node, then sorted by the upper node. */
template <int D>
void VertexGraph<D>::FindEdges()
{
  struct Pair
  {
    int Upper, Cell;
  };
  Buckets<Pair> pairs(this->NodeOf.size(),
    [this](auto&& visit) {
      this->ForEachPair([&](int lower, int upper, int cell) { visit(lower, Pair{ upper, cell }); });
    });
  this->JoiningCells.reserve(pairs.GetItems().size());
  for (int lower = 0; lower < pairs.GetNumberOfBuckets(); ++lower)
  {
    const auto [first, last] = pairs[lower];
    std::sort(first, last,
      [](const Pair& a, const Pair& b)
      { return a.Upper != b.Upper ? a.Upper < b.Upper : a.Cell < b.Cell; });
    for (auto pair = first; pair != last; ++pair)
    {
      const int begin = static_cast<int>(this->JoiningCells.size());
      if (pair == first || pair[-1].Upper != pair->Upper)
      {
        this->Edges.push_back({ { lower, pair->Upper }, begin, begin });
      }
      this->JoiningCells.push_back(pair->Cell);
      ++this->Edges.back().End;
    }
  }
}

/** Lists the edges of every node. */
template <int D>
void VertexGraph<D>::FindLinks()
{
  this->Links.emplace(this->NodeOf.size(),
    [this](auto&& visit)
    {
      for (int edge = 0; edge < static_cast<int>(this->Edges.size()); ++edge)
      {
        const auto [lower, upper] = this->Edges[edge].Nodes;
        visit(lower, Link{ upper, edge });
        visit(upper, Link{ lower, edge });
      }
    });
  for (int node = 0; node < this->Links->GetNumberOfBuckets(); ++node)
  {
    const auto [first, last] = (*this->Links)[node];
    this->LinkCount.push_back(static_cast<int>(last - first));
  }
}

/** Whether the cell remains, and is not a bridge from one of the two nodes to the other. */
template <int D>
bool VertexGraph<D>::Joins(int cell, const std::array<int, 2>& nodes) const
{
  const Sides<D + 1>& sides = this->SidesOf[cell];
  if (this->States[cell] == CellState::Carved || !sides.IsBridge())
  {
    return this->States[cell] != CellState::Carved;
  }
  int sideOf[2] = {};
  for (int corner = 0; corner <= D; ++corner)
  {
    for (const int i : { 0, 1 })
    {
      if (this->NodeOf[this->Mesh.Cells[cell][corner]] == nodes[i])
      {
        sideOf[i] = sides.Of[corner];
      }
    }
  }
  return sideOf[0] == sideOf[1];
}

/**
 * A cell that joins the nodes of an edge: not the given one if there is another; -1 if there is
 * none. Drops the cells that no longer join the nodes, since they never will again.
 */
template <int D>
int VertexGraph<D>::FindJoiningCell(Edge& edge, int cell)
{
  int found = -1;
  for (int i = edge.Begin; i < edge.End && (found < 0 || found == cell);)
  {
    if (this->Joins(this->JoiningCells[i], edge.Nodes))
    {
      found = this->JoiningCells[i++];
    }
    else
    {
      this->JoiningCells[i] = this->JoiningCells[--edge.End];
    }
  }
  return found;
}

template class VertexGraph<2>;
template class VertexGraph<3>;

} // namespace carving
