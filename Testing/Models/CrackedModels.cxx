// SPDX-License-Identifier: BSD-3-Clause
#include "CrackedModels.h"

#include "Core/Mesh/Vector.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

using carving::Point;
using carving::Triangle;

namespace models
{
namespace
{

using Place = std::array<int, 3>;

/** Cells of a grid, and the rectangles around those that are full. */
class VoxelGrid
{
public:
  VoxelGrid(int n, double share, std::mt19937_64& random)
    : Size(n)
    , IsFull(n * n * n)
  {
    std::bernoulli_distribution full(share);
    std::generate(this->IsFull.begin(), this->IsFull.end(), [&] { return full(random); });
    this->IsFull.front() = 1; // at least one
  }

  int Count() const
  {
    return static_cast<int>(std::count(this->IsFull.begin(), this->IsFull.end(), 1));
  }

  TriangleMesh MakeSurface()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int layer = 0; layer < this->Size; ++layer)
      {
        this->AddRectangles(axis, layer, 1);
        this->AddRectangles(axis, layer, -1);
      }
    }
    return std::move(this->Surface);
  }

private:
  bool Has(const Place& p) const
  {
    const auto isWithin = [this](int x) { return x >= 0 && x < this->Size; };
    return std::all_of(p.begin(), p.end(), isWithin) &&
      this->IsFull[(p[2] * this->Size + p[1]) * this->Size + p[0]];
  }

  static Place At(int axis, int layer, int u, int v)
  {
    Place p;
    p[axis] = layer;
    p[(axis + 1) % 3] = u;
    p[(axis + 2) % 3] = v;
    return p;
  }

  /** Covers the sides of a layer's cells that are open in a direction with rectangles. */
  void AddRectangles(int axis, int layer, int direction)
  {
    const int n = this->Size;
    std::vector<char> isOpen(n * n);
    for (int u = 0; u < n; ++u)
    {
      for (int v = 0; v < n; ++v)
      {
        isOpen[u * n + v] =
          this->Has(At(axis, layer, u, v)) && !this->Has(At(axis, layer + direction, u, v));
      }
    }
    const auto rowIsOpen = [&](int u, int from, int to)
    {
      return u < n &&
        std::all_of(isOpen.begin() + u * n + from, isOpen.begin() + u * n + to,
          [](char open) { return open != 0; });
    };
    for (int u = 0; u < n; ++u)
    {
      for (int v = 0; v < n; ++v)
      {
        int toU = u, toV = v;
        while (toV < n && isOpen[u * n + toV])
        {
          ++toV;
        }
        while (toV > v && rowIsOpen(toU, v, toV))
        {
          std::fill(isOpen.begin() + toU * n + v, isOpen.begin() + toU * n + toV, 0);
          ++toU;
        }
        if (toV > v)
        {
          const int at = direction > 0 ? layer + 1 : layer;
          this->AddRectangle({ At(axis, at, u, v), At(axis, at, toU, v), At(axis, at, toU, toV),
                               At(axis, at, u, toV) },
            direction > 0);
        }
      }
    }
  }

  void AddRectangle(const std::array<Place, 4>& corners, bool outward)
  {
    std::array<int, 4> ids;
    for (int i = 0; i < 4; ++i)
    {
      const Place& p = corners[outward ? i : 3 - i];
      const auto [entry, isNew] =
        this->Ids.emplace(p, static_cast<int>(this->Surface.Points.size()));
      if (isNew)
      {
        this->Surface.Points.push_back({ 1.0 * p[0], 1.0 * p[1], 1.0 * p[2] });
      }
      ids[i] = entry->second;
    }
    this->Surface.Triangles.push_back({ ids[0], ids[1], ids[2] });
    this->Surface.Triangles.push_back({ ids[0], ids[2], ids[3] });
  }

  int Size;
  std::vector<char> IsFull;
  std::map<Place, int> Ids;
  TriangleMesh Surface;
};

} // namespace

TriangleMesh TorusInTwoParts(double step, double height, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> along(-step, step);
  TriangleMesh below = Torus(1.0, 0.4, 12, 8), above = below;
  const auto isAbove = [points = below.Points, height](const Triangle& t)
  { return points[t[0]][2] + points[t[1]][2] + points[t[2]][2] > 3.0 * height; };
  const auto remove = [](std::vector<Triangle>& triangles, const auto& predicate)
  {
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(), predicate), triangles.end());
  };
  remove(below.Triangles, isAbove);
  remove(above.Triangles, [&isAbove](const Triangle& t) { return !isAbove(t); });
  const double x = along(random), y = along(random), z = along(random);
  return Rotated(Joined(below, Moved(above, { x, y, z })), random);
}

TriangleMesh WithHangingNodes(TriangleMesh mesh, int rounds, std::mt19937_64& random)
{
  std::bernoulli_distribution splits(0.4);
  std::map<std::pair<int, int>, int> midpoints;
  const auto midpointOf = [&](int a, int b)
  {
    const auto [entry, isNew] =
      midpoints.emplace(std::minmax(a, b), static_cast<int>(mesh.Points.size()));
    if (isNew)
    {
      mesh.Points.push_back(carving::Between(mesh.Points[a], mesh.Points[b], 0.5));
    }
    return entry->second;
  };
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<Triangle> triangles;
    for (const Triangle& t : mesh.Triangles)
    {
      if (!splits(random))
      {
        triangles.push_back(t);
        continue;
      }
      const auto [a, b, c] = t;
      const int ab = midpointOf(a, b), bc = midpointOf(b, c), ca = midpointOf(c, a);
      triangles.insert(
        triangles.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
    }
    mesh.Triangles = std::move(triangles);
  }
  return InSinglePrecision(Rotated(std::move(mesh), random));
}

Voxels RandomVoxels(int n, double share, std::mt19937_64& random)
{
  VoxelGrid grid(n, share, random);
  return { InSinglePrecision(Rotated(grid.MakeSurface(), random)), grid.Count() };
}

} // namespace models
