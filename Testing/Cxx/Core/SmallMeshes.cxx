// SPDX-License-Identifier: BSD-3-Clause
#include "SmallMeshes.h"

#include "Core/Mesh/Vector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

using namespace carving;

namespace small
{

Tetrahedralization Assemble(const std::vector<Point>& points,
  const std::vector<std::array<int, 4>>& cells, const std::vector<Triangle>& triangles)
{
  Tetrahedralization mesh;
  mesh.Surface.Points = points;
  mesh.Surface.PointSources.resize(points.size());
  std::iota(mesh.Surface.PointSources.begin(), mesh.Surface.PointSources.end(), 0);
  mesh.Surface.Facets = triangles;
  mesh.Surface.FacetSources.resize(triangles.size());
  std::iota(mesh.Surface.FacetSources.begin(), mesh.Surface.FacetSources.end(), 0);
  mesh.Surface.SignedMultiplicities.assign(triangles.size(), 1);
  mesh.Surface.Multiplicities.assign(triangles.size(), 1);
  mesh.Cells = cells;
  mesh.Neighbors.assign(cells.size(), { -1, -1, -1, -1 });
  std::vector<std::array<int, 4>> facets(cells.size(), { -1, -1, -1, -1 });
  for (std::array<int, 4>& cell : mesh.Cells)
  {
    if (SixVolume(points[cell[0]], points[cell[1]], points[cell[2]], points[cell[3]]) < 0)
    {
      std::swap(cell[2], cell[3]);
    }
  }
  const auto sorted = [](Triangle t)
  {
    std::sort(t.begin(), t.end());
    return t;
  };
  std::map<Triangle, int> constraints;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    constraints[sorted(triangles[i])] = static_cast<int>(i);
  }
  std::map<Triangle, std::pair<int, int>> open;
  for (int cell = 0; cell < static_cast<int>(cells.size()); ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      const Triangle key = sorted(mesh.OutwardFace(cell, f));
      if (const auto found = constraints.find(key); found != constraints.end())
      {
        facets[cell][f] = found->second;
      }
      if (const auto found = open.find(key); found != open.end())
      {
        const auto [other, otherFace] = found->second;
        mesh.Neighbors[cell][f] = other;
        mesh.Neighbors[other][otherFace] = cell;
      }
      open[key] = { cell, f };
    }
  }
  mesh.Constraints = FaceConstraints<3>(facets);
  return mesh;
}

std::vector<Triangle> OuterFaces()
{
  return { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
}

std::vector<Triangle> InnerFaces()
{
  std::vector<Triangle> faces = OuterFaces();
  for (Triangle& face : faces)
  {
    for (int& corner : face)
    {
      corner += 4;
    }
  }
  return faces;
}

std::vector<Triangle> Flipped(std::vector<Triangle> triangles)
{
  for (Triangle& t : triangles)
  {
    std::swap(t[1], t[2]);
  }
  return triangles;
}

std::vector<Triangle> Joined(std::vector<Triangle> a, const std::vector<Triangle>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Tetrahedralization NestedTetrahedra(const std::vector<Triangle>& triangles)
{
  std::vector<Point> points = { { 0, 0, 0 }, { 8, 0, 0 }, { 0, 8, 0 }, { 0, 0, 8 } };
  for (int i = 0; i < 4; ++i)
  {
    points.push_back(Point{ 1.5, 1.5, 1.5 } + points[i] / 4.0);
  }
  std::vector<std::array<int, 4>> cells;
  for (Triangle face : OuterFaces())
  {
    // The prism between an outer face and the inner one; since its corners are sorted, prisms that
    // share a side agree on its diagonal.
    std::sort(face.begin(), face.end());
    const auto [a, b, c] = face;
    cells.push_back({ a, b, c, c + 4 });
    cells.push_back({ a, b, b + 4, c + 4 });
    cells.push_back({ a, a + 4, b + 4, c + 4 });
  }
  cells.push_back({ 4, 5, 6, 7 });
  return Assemble(points, cells, triangles);
}

Tetrahedralization Row(int n)
{
  std::vector<Point> points;
  std::vector<std::array<int, 4>> cells;
  for (int i = 0; i < n + 3; ++i)
  {
    // A helix that narrows: any four points in a row span a tetrahedron.
    const double shrink = std::pow(0.9, i);
    points.push_back({ shrink * std::cos(2.0 * i), shrink * std::sin(2.0 * i), -5.0 * shrink });
    if (i >= 3)
    {
      cells.push_back({ i - 3, i - 2, i - 1, i });
    }
  }
  return Assemble(points, cells, { { n, n + 1, n + 2 } });
}

Tetrahedralization EvenRow(int n, const std::vector<Triangle>& triangles)
{
  std::vector<Point> points;
  std::vector<std::array<int, 4>> cells;
  for (int i = 0; i < n + 3; ++i)
  {
    // Around the corners of a square: any four in a row have the same mean of y and of z.
    const int corner = i % 4;
    points.push_back(
      { static_cast<double>(i), corner == 1 || corner == 2 ? 1.0 : 0.0, corner < 2 ? 0.0 : 1.0 });
    if (i >= 3)
    {
      cells.push_back({ i - 3, i - 2, i - 1, i });
    }
  }
  return Assemble(points, cells, triangles);
}

Tetrahedralization HollowTetrahedron()
{
  return NestedTetrahedra(Joined(OuterFaces(), Flipped(InnerFaces())));
}

Stream Carved(const Tetrahedralization& mesh, const CarveOptions& options, SolidRule rule)
{
  Stream stream;
  EXPECT_TRUE(Carve(mesh, Classify(mesh, rule), options, stream));
  return stream;
}

CarveOptions OneByOne()
{
  CarveOptions options;
  options.CarveExposed = false;
  return options;
}

StoredStream<3> StoreOneByOne(const Tetrahedralization& mesh)
{
  return Store(mesh, Classify(mesh), Carved(mesh, OneByOne()));
}

ResolvedMesh Resolved(const TriangleMesh& mesh)
{
  ResolvedMesh result;
  result.Points = mesh.Points;
  result.Facets = mesh.Triangles;
  result.SignedMultiplicities.assign(mesh.Triangles.size(), 1);
  result.Multiplicities = result.SignedMultiplicities;
  return result;
}

std::vector<Triangle> Triangles(const Level<3>& level)
{
  std::vector<Triangle> triangles;
  for (const FaceLife<3>& face : level.Faces)
  {
    triangles.push_back(face.Corners);
  }
  return triangles;
}

} // namespace small
