// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/Clean.h"

#include "Helper/Base/Kernels.h"

#include <algorithm>
#include <numeric>

using namespace carving;

namespace
{

/** For every point the first one with equal coordinates. */
std::vector<int> FirstEqualPoints(const std::vector<Point>& points)
{
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](int a, int b) { return points[a] != points[b] ? points[a] < points[b] : a < b; });
  std::vector<int> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool equal = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = equal ? first[order[i - 1]] : order[i];
  }
  return first;
}

bool IsDegenerate(const std::vector<Point>& points, const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
    CGAL::collinear(ToInexact(points[t[0]]), ToInexact(points[t[1]]), ToInexact(points[t[2]]));
}

/** The corners in ascending order; `sign` is the parity of the permutation that sorts them. */
Triangle Sorted(Triangle t, int& sign)
{
  sign = 1;
  for (const auto& [a, b] : { std::pair(0, 1), std::pair(1, 2), std::pair(0, 1) })
  {
    if (t[a] > t[b])
    {
      std::swap(t[a], t[b]);
      sign = -sign;
    }
  }
  return t;
}

/** Merges every triangle that equals an earlier one into that. */
void MergeEqualTriangles(ResolvedMesh& mesh)
{
  struct Key
  {
    Triangle Corners;
    int Index;
    int Sign;
  };
  std::vector<Key> keys(mesh.Facets.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    keys[i].Corners = Sorted(mesh.Facets[i], keys[i].Sign);
    keys[i].Index = static_cast<int>(i);
  }
  std::sort(keys.begin(), keys.end(),
    [](const Key& a, const Key& b)
    { return a.Corners != b.Corners ? a.Corners < b.Corners : a.Index < b.Index; });
  std::vector<char> keep(keys.size(), 1);
  const Key* first = nullptr;
  for (const Key& key : keys)
  {
    if (!first || first->Corners != key.Corners)
    {
      first = &key;
      continue;
    }
    mesh.SignedMultiplicities[first->Index] +=
      first->Sign * key.Sign * mesh.SignedMultiplicities[key.Index];
    mesh.Multiplicities[first->Index] += mesh.Multiplicities[key.Index];
    keep[key.Index] = 0;
  }
  std::size_t to = 0;
  for (std::size_t from = 0; from < keep.size(); ++from)
  {
    if (keep[from])
    {
      mesh.Facets[to] = mesh.Facets[from];
      mesh.FacetSources[to] = mesh.FacetSources[from];
      mesh.SignedMultiplicities[to] = mesh.SignedMultiplicities[from];
      mesh.Multiplicities[to] = mesh.Multiplicities[from];
      ++to;
    }
  }
  mesh.Facets.resize(to);
  mesh.FacetSources.resize(to);
  mesh.SignedMultiplicities.resize(to);
  mesh.Multiplicities.resize(to);
}

} // namespace

ResolvedMesh AsResolved(const TriangleMesh& given)
{
  ResolvedMesh mesh;
  mesh.Points = given.Points;
  mesh.PointSources.resize(given.Points.size());
  std::iota(mesh.PointSources.begin(), mesh.PointSources.end(), 0);
  mesh.Facets = given.Triangles;
  mesh.FacetSources.resize(given.Triangles.size());
  std::iota(mesh.FacetSources.begin(), mesh.FacetSources.end(), 0);
  mesh.SignedMultiplicities.assign(given.Triangles.size(), 1);
  mesh.Multiplicities.assign(given.Triangles.size(), 1);
  return mesh;
}

ResolvedMesh Clean(const ResolvedMesh& mesh)
{
  ResolvedMesh result;
  std::vector<int> newIndex = FirstEqualPoints(mesh.Points);
  std::vector<char> used(mesh.Points.size(), 0);
  for (std::size_t i = 0; i < mesh.Facets.size(); ++i)
  {
    Triangle t = mesh.Facets[i];
    for (int& corner : t)
    {
      corner = newIndex[corner];
    }
    if (IsDegenerate(mesh.Points, t))
    {
      continue;
    }
    for (const int corner : t)
    {
      used[corner] = 1;
    }
    AppendFacet<3>(mesh, i, t, result);
  }
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    if (used[i])
    {
      newIndex[i] = static_cast<int>(result.Points.size());
      result.Points.push_back(mesh.Points[i]);
      result.PointSources.push_back(mesh.PointSources[i]);
    }
  }
  for (Triangle& t : result.Facets)
  {
    for (int& corner : t)
    {
      corner = newIndex[corner];
    }
  }
  MergeEqualTriangles(result);
  return result;
}
