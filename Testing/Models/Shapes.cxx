// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"

#include "PointMath.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

using carving::Triangle;

namespace models
{
namespace
{

/**
 * Adds two triangles per cell of a grid of n x m points; `wrap` closes the grid in both directions.
 */
void AddGrid(TriangleMesh& mesh, int n, int m, bool wrap)
{
  const int cellsN = wrap ? n : n - 1;
  const int cellsM = wrap ? m : m - 1;
  for (int i = 0; i < cellsN; ++i)
  {
    for (int j = 0; j < cellsM; ++j)
    {
      const int a = i * m + j;
      const int b = (i + 1) % n * m + j;
      const int c = (i + 1) % n * m + (j + 1) % m;
      const int d = i * m + (j + 1) % m;
      mesh.Triangles.push_back({ a, b, c });
      mesh.Triangles.push_back({ a, c, d });
    }
  }
}

} // namespace

TriangleMesh Tetrahedron()
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } } };
}

TriangleMesh Box(const Point& lower, const Point& upper)
{
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
  {
    mesh.Points.push_back(
      { i & 1 ? upper[0] : lower[0], i & 2 ? upper[1] : lower[1], i & 4 ? upper[2] : lower[2] });
  }
  const int sides[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto& s : sides)
  {
    mesh.Triangles.push_back({ s[0], s[1], s[2] });
    mesh.Triangles.push_back({ s[0], s[2], s[3] });
  }
  return mesh;
}

TriangleMesh Sphere(int subdivisions)
{
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  TriangleMesh mesh;
  mesh.Points = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g }, { 0, 1, g },
    { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } };
  mesh.Triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  for (; subdivisions > 0; --subdivisions)
  {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b)
    {
      const auto [found, isNew] =
        middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.Points.size()));
      if (isNew)
      {
        mesh.Points.push_back((mesh.Points[a] + mesh.Points[b]) / 2.0);
      }
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.Triangles)
    {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
    }
    mesh.Triangles = finer;
  }
  for (Point& p : mesh.Points)
  {
    p = Normalized(p);
  }
  return mesh;
}

TriangleMesh Torus(double majorRadius, double minorRadius, int n, int m)
{
  TriangleMesh mesh;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      const double u = 2 * Pi * i / n, v = 2 * Pi * j / m;
      const double r = majorRadius + minorRadius * std::cos(v);
      mesh.Points.push_back({ r * std::cos(u), r * std::sin(u), minorRadius * std::sin(v) });
    }
  }
  AddGrid(mesh, n, m, true);
  return mesh;
}

TriangleMesh CrossingTori()
{
  const TriangleMesh torus = Torus(1.0, 0.4, 12, 8);
  return Joined(torus, Moved(torus, { 1.0, 0.1, 0.2 }));
}

TriangleMesh BumpyTorus(int points)
{
  const double ratio = 3.0; // of the two circumferences
  const int m = static_cast<int>(std::lround(std::sqrt(points / ratio)));
  const int n = points / m;
  TriangleMesh mesh;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      // Bumps across both directions leave no symmetry, and so no more than four points on a
      // sphere.
      const double u = 2 * Pi * i / n, v = 2 * Pi * j / m;
      const double bumps = std::sin(7 * u + 2 * v + 1) * std::sin(3 * v - 2 * u + 2) +
        0.5 * std::sin(11 * u - 4 * v + 3);
      const double minorRadius = 0.33 * (1 + 0.3 * bumps);
      const double r = 1 + minorRadius * std::cos(v);
      mesh.Points.push_back({ r * std::cos(u), r * std::sin(u), minorRadius * std::sin(v) });
    }
  }
  AddGrid(mesh, n, m, true);
  return mesh;
}

TriangleMesh Sheet(int n)
{
  TriangleMesh mesh;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      mesh.Points.push_back({ double(i) / n, double(j) / n, 0.0 });
    }
  }
  AddGrid(mesh, n + 1, n + 1, false);
  return mesh;
}

TriangleMesh Prism(int sides, double from, double to)
{
  TriangleMesh mesh;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / sides;
    const int next = (i + 1) % sides;
    mesh.Points.push_back({ std::cos(angle), std::sin(angle), from });
    mesh.Points.push_back({ std::cos(angle), std::sin(angle), to });
    mesh.Triangles.push_back({ 2 * i, 2 * next, 2 * next + 1 });
    mesh.Triangles.push_back({ 2 * i, 2 * next + 1, 2 * i + 1 });
  }
  for (int i = 1; i + 1 < sides; ++i)
  {
    mesh.Triangles.push_back({ 0, 2 * i + 2, 2 * i });
    mesh.Triangles.push_back({ 1, 2 * i + 1, 2 * i + 3 });
  }
  return mesh;
}

TriangleMesh PatchedBox(const Point& size, const std::array<int, 6>& n)
{
  TriangleMesh mesh;
  for (int side = 0; side < 6; ++side)
  {
    const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int first = static_cast<int>(mesh.Points.size()), row = n[side] + 1;
    for (int i = 0; i < row * row; ++i)
    {
      Point& p = mesh.Points.emplace_back();
      p[axis] = side % 2 == 0 ? 0.0 : size[axis];
      p[u] = size[u] * (i % row) / n[side];
      p[v] = size[v] * (i / row) / n[side];
    }
    for (int i = 0; i < n[side]; ++i)
    {
      for (int j = 0; j < n[side]; ++j)
      {
        const int a = first + i * row + j, b = a + 1, c = a + row, d = c + 1;
        for (Triangle t : { Triangle{ a, b, d }, Triangle{ a, d, c } })
        {
          mesh.Triangles.push_back(side % 2 == 0 ? carving::Flipped<3>(t) : t);
        }
      }
    }
  }
  return mesh;
}

TriangleMesh Lattice(int n)
{
  TriangleMesh mesh;
  for (int i = 0; i < 2 * n; ++i)
  {
    const int along = i % 2;
    for (const Point& p :
      { Point{ 0.0, 0.0, 0.0 }, Point{ n + 1.0, 0.0, 0.0 }, Point{ 0.0, 0.0, 9.0 } })
    {
      Point corner = { 0.0, 0.0, p[2] };
      corner[along] = p[0];
      corner[1 - along] = i / 2 + 1.0;
      mesh.Points.push_back(corner);
    }
    mesh.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return mesh;
}

TriangleMesh CloseSpheres()
{
  const TriangleMesh sphere = Sphere(3);
  TriangleMesh turned = Flipped(Moved(sphere, {}, 0.99));
  for (Point& p : turned.Points)
  {
    p = { 0.8 * p[0] - 0.6 * p[1], 0.6 * p[0] + 0.8 * p[1], p[2] };
  }
  return Joined(sphere, Joined(turned, Moved(sphere, {}, 0.98)));
}

TriangleMesh Moved(TriangleMesh mesh, const Point& translation, double scale)
{
  for (Point& p : mesh.Points)
  {
    p = scale * p + translation;
  }
  return mesh;
}

TriangleMesh Sheared(TriangleMesh mesh)
{
  for (Point& p : mesh.Points)
  {
    p[0] += 2.0 * p[2];
  }
  return mesh;
}

TriangleMesh InSinglePrecision(TriangleMesh mesh)
{
  for (Point& p : mesh.Points)
  {
    for (double& x : p)
    {
      x = static_cast<float>(x);
    }
  }
  return mesh;
}

TriangleMesh Flipped(TriangleMesh mesh)
{
  for (Triangle& t : mesh.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

TriangleMesh Joined(const TriangleMesh& a, const TriangleMesh& b)
{
  TriangleMesh mesh = a;
  const int offset = static_cast<int>(a.Points.size());
  mesh.Points.insert(mesh.Points.end(), b.Points.begin(), b.Points.end());
  for (const Triangle& t : b.Triangles)
  {
    mesh.Triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
  }
  return mesh;
}

} // namespace models
