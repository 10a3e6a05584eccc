// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Budget/Connectivity.h"

#include "Core/Mesh/DisjointSets.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace carving
{

template <int D>
Connectivity<D>::Connectivity(const Decomposition<D>& mesh, const std::vector<CellState>& states)
  : Mesh(mesh)
  , States(states)
  , Sides(mesh.Cells.size(), 0)
{
}

template <int D>
void Connectivity<D>::FindNodes()
{
  if (!this->Node.empty())
  {
    return;
  }
  DisjointSets sets(this->Mesh.Surface.Points.size());
  for (const auto& facet : this->Mesh.Surface.Facets)
  {
    for (const int corner : facet)
    {
      sets.Unite(corner, facet[0]);
    }
  }
  for (std::size_t cell = 0; cell < this->Mesh.Cells.size(); ++cell)
  {
    if (this->States[cell] == CellState::Stays)
    {
      for (const int corner : this->Mesh.Cells[cell])
      {
        sets.Unite(corner, this->Mesh.Cells[cell][0]);
      }
    }
  }
  this->Node.resize(this->Mesh.Surface.Points.size());
  for (std::size_t vertex = 0; vertex < this->Node.size(); ++vertex)
  {
    this->Node[vertex] = sets.Find(static_cast<int>(vertex));
  }
}

template <int D>
int Connectivity<D>::CountComponents()
{
  this->FindNodes();
  DisjointSets sets(this->Node.size());
  std::vector<char> isLeft(this->Node.size(), 0); // per node
  for (const auto& facet : this->Mesh.Surface.Facets)
  {
    isLeft[this->Node[facet[0]]] = 1;
  }
  for (std::size_t cell = 0; cell < this->Mesh.Cells.size(); ++cell)
  {
    const auto& corners = this->Mesh.Cells[cell];
    isLeft[this->Node[corners[0]]] |= this->States[cell] != CellState::Carved;
    for (int corner = 0; corner <= D && this->States[cell] == CellState::Carvable; ++corner)
    {
      isLeft[this->Node[corners[corner]]] = 1;
      sets.Unite(this->Node[corners[corner]], this->Node[corners[0]]);
    }
  }
  int components = 0;
  for (int node = 0; node < static_cast<int>(this->Node.size()); ++node)
  {
    components += isLeft[node] && sets.Find(node) == node;
  }
  return components;
}

/** Calls `visit` with pairs of nodes, the lower first, that a cell which may be carved has corners of. */
template <int D>
template <class Visitor>
void Connectivity<D>::ForEachPair(Visitor&& visit) const
{
  for (int cell = 0; cell < static_cast<int>(this->Mesh.Cells.size()); ++cell)
  {
    if (this->States[cell] != CellState::Carvable)
    {
      continue;
    }
    Labels nodes;
    std::transform(this->Mesh.Cells[cell].begin(), this->Mesh.Cells[cell].end(), nodes.begin(),
      [this](int vertex) { return this->Node[vertex]; });
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

template <int D>
void Connectivity<D>::FindLinks()
{
  const int numberOfNodes = static_cast<int>(this->Node.size());
  // By their lower node. `Next` is the upper node at first.
  std::vector<int> begins(numberOfNodes + 1, 0);
  this->ForEachPair([&](int lower, int, int) { ++begins[lower + 1]; });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  this->Holders.resize(begins.back());
  std::vector<int> ends = begins;
  this->ForEachPair(
    [&](int lower, int upper, int cell) {
      this->Holders[ends[lower]++] = { cell, upper };
    });
  // Those with the same upper node become the list of an edge.
  std::vector<int> edgeTo(numberOfNodes, -1);
  this->Begins.assign(numberOfNodes + 1, 0);
  for (int lower = 0; lower < numberOfNodes; ++lower)
  {
    const int first = static_cast<int>(this->Edges.size());
    for (int holder = begins[lower]; holder < begins[lower + 1]; ++holder)
    {
      int& next = this->Holders[holder].Next;
      const int upper = next;
      if (edgeTo[upper] < first)
      {
        edgeTo[upper] = static_cast<int>(this->Edges.size());
        this->Edges.push_back({ { lower, upper }, -1 });
        ++this->Begins[lower + 1];
        ++this->Begins[upper + 1];
      }
      next = std::exchange(this->Edges[edgeTo[upper]].Holder, holder);
    }
  }
  std::partial_sum(this->Begins.begin(), this->Begins.end(), this->Begins.begin());
  this->Links.resize(this->Begins.back());
  this->Ends = this->Begins;
  for (int edge = 0; edge < static_cast<int>(this->Edges.size()); ++edge)
  {
    const auto [lower, upper] = this->Edges[edge].Nodes;
    this->Links[this->Ends[lower]++] = { upper, edge };
    this->Links[this->Ends[upper]++] = { lower, edge };
  }
}

/** Whether the cell is there and joins the two nodes; it is not a bridge from one to the other. */
template <int D>
bool Connectivity<D>::Holds(int cell, const std::array<int, 2>& nodes) const
{
  if (this->States[cell] == CellState::Carved || this->Sides[cell] == 0)
  {
    return this->States[cell] != CellState::Carved;
  }
  int sides[2] = {};
  for (int corner = 0; corner <= D; ++corner)
  {
    for (const int i : { 0, 1 })
    {
      if (this->Node[this->Mesh.Cells[cell][corner]] == nodes[i])
      {
        sides[i] = this->SideOf(cell, corner);
      }
    }
  }
  return sides[0] == sides[1];
}

/** A cell that holds an edge, another than the given one if possible; -1 if there is none. */
template <int D>
int Connectivity<D>::FindHolder(int edge, int cell)
{
  int* at = &this->Edges[edge].Holder;
  int found = -1;
  while (*at >= 0 && (found < 0 || found == cell))
  {
    Holder& holder = this->Holders[*at];
    if (!this->Holds(holder.Cell, this->Edges[edge].Nodes))
    {
      *at = holder.Next; // for good
      continue;
    }
    found = holder.Cell;
    at = &holder.Next;
  }
  return found;
}

template <int D>
void Connectivity<D>::Start(int cell, const Labels& labels)
{
  ++this->Question;
  for (Search& search : this->Searches)
  {
    search.Nodes.clear();
    search.Current = 0;
    search.NextLink = -1;
    search.Label = -1;
  }
  for (int corner = 0; corner <= D; ++corner)
  {
    if (labels[corner] >= 0)
    {
      Search& search = this->Searches[labels[corner]];
      search.Label = search.Label < 0 ? labels[corner] : search.Label;
      search.Side = this->SideOf(cell, corner);
      this->Reach(search, this->Node[this->Mesh.Cells[cell][corner]]);
    }
  }
}

/** Comes to a node; returns whether that is one which another search has come to before. */
template <int D>
bool Connectivity<D>::Reach(Search& search, int node)
{
  const long long first = this->Question * (D + 1);
  if (this->Reached[node] < first)
  {
    this->Reached[node] = first + (&search - this->Searches.data());
    search.Nodes.push_back(node);
    return false;
  }
  const int met = this->Searches[this->Reached[node] - first].Label;
  const int own = search.Label;
  for (Search& other : this->Searches)
  {
    other.Label = other.Label == met ? own : other.Label;
  }
  return met != own;
}

/** Whether a node has been reached by the search or one that it has met. */
template <int D>
bool Connectivity<D>::HasMet(const Search& search, int node) const
{
  const long long by = this->Reached[node] - this->Question * (D + 1);
  return by >= 0 && this->Searches[by].Label == search.Label;
}

/** Whether the search can still meet one that it has not met. */
template <int D>
bool Connectivity<D>::IsOpen(const Search& search) const
{
  const auto isRunning = [](const Search& s) { return s.Current < s.Nodes.size(); };
  return isRunning(search) &&
    std::any_of(this->Searches.begin(), this->Searches.end(),
      [&](const Search& other)
      { return isRunning(other) && other.Side == search.Side && other.Label != search.Label; });
}

/** One tick of a search. */
template <int D>
void Connectivity<D>::FollowLink(Search& search, int cell)
{
  const int node = search.Nodes[search.Current];
  if (search.NextLink < 0)
  {
    search.NextLink = this->Begins[node];
  }
  if (search.NextLink == this->Ends[node])
  {
    ++search.Current;
    search.NextLink = -1;
    return;
  }
  Link& link = this->Links[search.NextLink];
  if (this->HasMet(search, link.Node))
  {
    ++search.NextLink;
    return;
  }
  const int holder = this->FindHolder(link.Edge, cell);
  if (holder < 0)
  {
    link = this->Links[--this->Ends[node]];
    return;
  }
  ++search.NextLink;
  if (holder != cell && this->Reach(search, link.Node))
  {
    // What has joined two sides is likely to join them the next time.
    std::swap(link, this->Links[this->Begins[node]]);
  }
}

template <int D>
int Connectivity<D>::JoinAround(int cell, Labels& labels)
{
  this->FindNodes();
  this->Reached.resize(this->Node.size(), -1);
  this->Start(cell, labels);
  for (bool open = true; open;)
  {
    open = false;
    for (Search& search : this->Searches)
    {
      if (this->IsOpen(search))
      {
        if (this->Begins.empty())
        {
          this->FindLinks();
        }
        open = true;
        this->FollowLink(search, cell);
      }
    }
  }
  for (int& label : labels)
  {
    label = label < 0 ? -1 : this->Searches[label].Label;
  }
  return CountLabels(labels);
}

template <int D>
void Connectivity<D>::KeepAsBridge(int cell, const Labels& components)
{
  this->Sides[cell] = 0;
  for (int corner = 0; corner <= D; ++corner)
  {
    // A corner that only this cell has is on no side, which any number stands for.
    this->Sides[cell] |=
      static_cast<unsigned char>(std::max(0, components[corner]) << (2 * corner));
  }
}

template class Connectivity<2>;
template class Connectivity<3>;

} // namespace carving
