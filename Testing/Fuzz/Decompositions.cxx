// SPDX-License-Identifier: BSD-3-Clause
#include "Decompositions.h"

#include "Core/Mesh/Adjacency.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <numeric>

using namespace carving;

namespace
{

template <int D>
double SignedSize(const std::vector<Point>& points, const std::array<int, D + 1>& cell)
{
  if constexpr (D == 3)
  {
    return SixVolume(points[cell[0]], points[cell[1]], points[cell[2]], points[cell[3]]);
  }
  else
  {
    return Cross(points[cell[1]] - points[cell[0]], points[cell[2]] - points[cell[0]])[2];
  }
}

/** Adds one cell per path along the edges of each cube from its lowest to its highest corner. */
template <int D>
void FillWithCubes(Bytes& bytes, Decomposition<D>& mesh)
{
  std::array<int, 3> size = { 1, 1, 0 };
  for (int axis = 0; axis < D; ++axis)
  {
    size[axis] = 1 + bytes.Below(axis == 0 ? 4 : 2);
  }
  const std::array<int, 3> strides = { 1, size[0] + 1, (size[0] + 1) * (size[1] + 1) };
  for (int z = 0; z <= size[2]; ++z)
  {
    for (int y = 0; y <= size[1]; ++y)
    {
      for (int x = 0; x <= size[0]; ++x)
      {
        mesh.Surface.Points.push_back({ double(x), double(y), double(z) });
      }
    }
  }
  for (int corner = 0; corner < static_cast<int>(mesh.Surface.Points.size()); ++corner)
  {
    const Point& lowest = mesh.Surface.Points[corner];
    if (lowest[0] == size[0] || lowest[1] == size[1] || (D == 3 && lowest[2] == size[2]))
    {
      continue;
    }
    std::array<int, D> axes;
    std::iota(axes.begin(), axes.end(), 0);
    do
    {
      std::array<int, D + 1> cell = { corner };
      for (int i = 0; i < D; ++i)
      {
        cell[i + 1] = cell[i] + strides[axes[i]];
      }
      if (SignedSize<D>(mesh.Surface.Points, cell) < 0.0)
      {
        std::swap(cell[D - 1], cell[D]);
      }
      mesh.Cells.push_back(cell);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
}

/** Adds a point inside a cell or on an edge, unless a cell would become flat. */
template <int D>
void Split(Bytes& bytes, Decomposition<D>& mesh)
{
  const auto split = mesh.Cells[bytes.Below(std::min<int>(256, mesh.Cells.size()))];
  const int corners = bytes.Bit() ? 2 : D + 1; // the point is a combination of these
  const int first = corners == 2 ? bytes.Below(D) : 0;
  Point point = {};
  double total = 0.0;
  for (int i = first; i < first + corners; ++i)
  {
    const double weight = 1.0 + bytes.Below(8);
    for (int axis = 0; axis < D; ++axis)
    {
      point[axis] += weight * mesh.Surface.Points[split[i]][axis];
    }
    total += weight;
  }
  for (double& x : point)
  {
    x /= total;
  }
  const int added = static_cast<int>(mesh.Surface.Points.size());
  mesh.Surface.Points.push_back(point);
  std::vector<std::array<int, D + 1>> cells;
  bool flat = false;
  for (const auto& cell : mesh.Cells)
  {
    const bool around = std::all_of(split.begin() + first, split.begin() + first + corners,
      [&](int corner) { return std::find(cell.begin(), cell.end(), corner) != cell.end(); });
    if (!around)
    {
      cells.push_back(cell);
      continue;
    }
    for (int i = first; i < first + corners; ++i)
    {
      cells.push_back(cell);
      std::replace(cells.back().begin(), cells.back().end(), split[i], added);
      flat = flat || SignedSize<D>(mesh.Surface.Points, cells.back()) <= 0.0;
    }
  }
  if (flat)
  {
    mesh.Surface.Points.pop_back();
  }
  else
  {
    mesh.Cells = cells;
  }
}

/** Adds M: the boundary of some cells, other faces, or both. */
template <int D>
void Constrain(Bytes& bytes, Decomposition<D>& mesh)
{
  FindAdjacency(mesh);
  const bool bounds = bytes.Bit(), further = bytes.Bit(), consistent = bytes.Bit();
  std::vector<char> within(mesh.Cells.size() + 1, 0);
  for (std::size_t cell = 0; bounds && cell < mesh.Cells.size(); ++cell)
  {
    within[cell] = bytes.Bit();
  }
  ResolvedInput<D>& surface = mesh.Surface;
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      const int neighbor = mesh.Neighbors[cell][f];
      const bool other = neighbor >= 0 && within[neighbor];
      if (neighbor > cell || (within[cell] == other && !(further && bytes.Bit())))
      {
        continue;
      }
      const auto outward = mesh.OutwardFace(cell, f);
      const bool flipped = consistent ? !within[cell] : bytes.Bit();
      surface.Facets.push_back(flipped ? Flipped<D>(outward) : outward);
      const int multiplicity = consistent ? 1 : 1 + bytes.Below(3);
      surface.Multiplicities.push_back(multiplicity);
      surface.SignedMultiplicities.push_back(
        consistent ? 1 : bytes.Below(2 * multiplicity + 1) - multiplicity);
      surface.FacetSources.push_back(static_cast<int>(surface.FacetSources.size()));
    }
  }
  FindAdjacency(mesh);
}

/** Marks some cells as kept, as in enclosing mode. */
template <int D>
void Keep(Bytes& bytes, Decomposition<D>& mesh)
{
  mesh.Unresolved = mesh.Surface;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    const bool kept = bytes.Bit();
    mesh.Kept.push_back(kept);
    if (kept) // a kept cell has a facet of the input between its corners
    {
      std::array<int, D> facet;
      std::copy(mesh.Cells[cell].begin(), mesh.Cells[cell].begin() + D, facet.begin());
      mesh.Unresolved.Facets.push_back(facet);
      mesh.Unresolved.FacetSources.push_back(0);
      mesh.Unresolved.Multiplicities.push_back(1);
      mesh.Unresolved.SignedMultiplicities.push_back(1);
    }
  }
  mesh.MetShares.assign(mesh.Unresolved.Facets.size(), 1.0);
}

} // namespace

template <int D>
Decomposition<D> MakeDecomposition(Bytes& bytes)
{
  Decomposition<D> mesh;
  FillWithCubes(bytes, mesh);
  const int splits = bytes.Below(16);
  for (int i = 0; i < splits; ++i)
  {
    Split(bytes, mesh);
  }
  mesh.Surface.PointSources.assign(mesh.Surface.Points.size(), -1);
  Constrain(bytes, mesh);
  if (D == 3 && bytes.Below(3) == 0)
  {
    Keep(bytes, mesh);
  }
  return mesh;
}

template Decomposition<2> MakeDecomposition<2>(Bytes&);
template Decomposition<3> MakeDecomposition<3>(Bytes&);
