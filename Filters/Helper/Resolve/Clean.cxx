// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/Clean.h"

#include "Helper/Base/Cleaning.h"
#include "Helper/Base/Kernels.h"

#include <algorithm>
#include <numeric>

namespace carving::helper
{
namespace
{

bool IsDegenerate(const std::vector<Point>& points, const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
    CGAL::collinear(ToInexact(points[t[0]]), ToInexact(points[t[1]]), ToInexact(points[t[2]]));
}

/** The corners in ascending order; `sign` is that of the permutation that sorts them. */
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

/** Merges every triangle into the first triangle that is equal, in whatever orientation. */
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
  CompactFacets(mesh, keep);
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
  result.Facets.reserve(mesh.Facets.size());
  const std::vector<int> first = FirstEqualPoints<3>(mesh.Points);
  for (std::size_t i = 0; i < mesh.Facets.size(); ++i)
  {
    const auto& [a, b, c] = mesh.Facets[i];
    const Triangle t = { first[a], first[b], first[c] };
    if (!IsDegenerate(mesh.Points, t))
    {
      AppendFacet<3>(mesh, i, t, result);
    }
  }
  TakeUsedPoints(mesh, result);
  MergeEqualTriangles(result);
  return result;
}

} // namespace carving::helper
