// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Steps of cleaning that triangles and edges share.
 */
#ifndef carving_Cleaning_h
#define carving_Cleaning_h

#include "Core/Mesh/Mesh.h"

#include <algorithm>
#include <numeric>

namespace carving::helper
{

/** For every point, the first point whose first D coordinates are equal. */
template <int D>
std::vector<int> FirstEqualPoints(const std::vector<Point>& points)
{
  const auto key = [&points](int i) -> decltype(auto)
  {
    if constexpr (D == 3)
    {
      return (points[i]);
    }
    else
    {
      return std::pair(points[i][0], points[i][1]);
    }
  };
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](int a, int b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<int> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool equal = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = equal ? first[order[i - 1]] : order[i];
  }
  return first;
}

/**
 * Copies the points that the facets of `to` use from `from`, in their order, and renumbers the
 * corners of these facets.
 */
template <int D>
void TakeUsedPoints(const ResolvedInput<D>& from, ResolvedInput<D>& to)
{
  std::vector<int> newIndex(from.Points.size(), -1);
  std::size_t used = 0;
  for (const auto& facet : to.Facets)
  {
    for (const int corner : facet)
    {
      used += newIndex[corner] < 0;
      newIndex[corner] = 0;
    }
  }
  to.Points.reserve(used);
  to.PointSources.reserve(used);
  for (std::size_t i = 0; i < from.Points.size(); ++i)
  {
    if (newIndex[i] >= 0)
    {
      newIndex[i] = static_cast<int>(to.Points.size());
      to.Points.push_back(from.Points[i]);
      to.PointSources.push_back(from.PointSources[i]);
    }
  }
  for (auto& facet : to.Facets)
  {
    for (int& corner : facet)
    {
      corner = newIndex[corner];
    }
  }
}

/** Removes the values whose entry in `keep` is 0. */
template <class Value>
void Compact(std::vector<Value>& values, const std::vector<char>& keep)
{
  std::size_t to = 0;
  for (std::size_t from = 0; from < values.size(); ++from)
  {
    if (keep[from])
    {
      values[to++] = values[from];
    }
  }
  values.resize(to);
}

/** Removes the facets whose entry in `keep` is 0. */
template <int D>
void CompactFacets(ResolvedInput<D>& input, const std::vector<char>& keep)
{
  Compact(input.Facets, keep);
  Compact(input.FacetSources, keep);
  Compact(input.SignedMultiplicities, keep);
  Compact(input.Multiplicities, keep);
}

} // namespace carving::helper

#endif
