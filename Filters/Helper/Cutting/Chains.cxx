// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Cutting/Chains.h"

#include "Helper/Enclosing/Subdivision.h"

#include <algorithm>

namespace carving::helper
{

void Chains::Need(int a, int b)
{
  ++this->Needs[EdgeKey(a, b)];
}

void Chains::Release(int a, int b)
{
  const std::uint64_t edge = EdgeKey(a, b);
  const auto found = this->OfEdge.find(edge);
  if (--this->Needs[edge] > 0 || found == this->OfEdge.end())
  {
    return;
  }
  const int chain = found->second;
  this->OfEdge.erase(found);
  std::vector<int>& vertices = this->All[chain];
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
  {
    Drop(this->AtLink, EdgeKey(vertices[i], vertices[i + 1]), chain);
    if (i > 0)
    {
      Drop(this->AtVertex, vertices[i], chain);
    }
  }
  vertices = {};
}

bool Chains::Has(int a, int b) const
{
  return this->OfEdge.count(EdgeKey(a, b)) > 0;
}

void Chains::Add(const std::vector<int>& vertices)
{
  const int chain = static_cast<int>(this->All.size());
  this->All.push_back(vertices);
  this->OfEdge[EdgeKey(vertices.front(), vertices.back())] = chain;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
  {
    this->AtLink[EdgeKey(vertices[i], vertices[i + 1])].push_back(chain);
    if (i > 0)
    {
      this->AtVertex[vertices[i]].push_back(chain);
    }
  }
}

void Chains::Append(int a, int b, std::vector<int>& vertices) const
{
  const auto found = this->OfEdge.find(EdgeKey(a, b));
  if (found == this->OfEdge.end())
  {
    return;
  }
  const std::vector<int>& chain = this->All[found->second];
  if (chain.front() == a)
  {
    vertices.insert(vertices.end(), chain.begin() + 1, chain.end() - 1);
  }
  else
  {
    vertices.insert(vertices.end(), chain.rbegin() + 1, chain.rend() - 1);
  }
}

bool Chains::IsLink(int a, int b) const
{
  return this->AtLink.count(EdgeKey(a, b)) > 0;
}

void Chains::Split(int a, int b, int vertex)
{
  const auto found = this->AtLink.find(EdgeKey(a, b));
  if (found == this->AtLink.end())
  {
    return;
  }
  const std::vector<int> chains = std::move(found->second);
  this->AtLink.erase(found);
  for (const int chain : chains)
  {
    std::vector<int>& vertices = this->All[chain];
    const auto first = std::adjacent_find(vertices.begin(), vertices.end(),
      [&](int u, int v) { return EdgeKey(u, v) == EdgeKey(a, b); });
    vertices.insert(first + 1, vertex);
    this->AtLink[EdgeKey(a, vertex)].push_back(chain);
    this->AtLink[EdgeKey(vertex, b)].push_back(chain);
    this->AtVertex[vertex].push_back(chain);
  }
}

bool Chains::MayMove(int vertex, int target) const
{
  const auto found = this->AtVertex.find(vertex);
  return found == this->AtVertex.end() ||
    std::all_of(found->second.begin(), found->second.end(),
      [&](int chain)
      {
        const std::vector<int>& vertices = this->All[chain];
        const auto at = std::find(vertices.begin(), vertices.end(), vertex);
        return at[-1] == target || at[1] == target;
      });
}

void Chains::Remove(int vertex)
{
  const auto found = this->AtVertex.find(vertex);
  if (found == this->AtVertex.end())
  {
    return;
  }
  const std::vector<int> chains = std::move(found->second);
  this->AtVertex.erase(found);
  for (const int chain : chains)
  {
    std::vector<int>& vertices = this->All[chain];
    const auto at = std::find(vertices.begin(), vertices.end(), vertex);
    Drop(this->AtLink, EdgeKey(at[-1], vertex), chain);
    Drop(this->AtLink, EdgeKey(vertex, at[1]), chain);
    this->AtLink[EdgeKey(at[-1], at[1])].push_back(chain);
    vertices.erase(at);
  }
}

void Chains::Drop(Indices& indices, std::uint64_t key, int chain)
{
  const auto found = indices.find(key);
  std::vector<int>& chains = found->second;
  chains.erase(std::find(chains.begin(), chains.end(), chain));
  if (chains.empty())
  {
    indices.erase(found);
  }
}

} // namespace carving::helper
