// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plain mesh types that the core, the helper program and the VTK classes share.
 */
#ifndef carving_Mesh_h
#define carving_Mesh_h

#include <array>
#include <vector>

namespace carving
{

using Point = std::array<double, 3>;
using Triangle = std::array<int, 3>;

/** Triangles as the user gave them: any soup is allowed. */
struct TriangleMesh
{
  std::vector<Point> Points;
  std::vector<Triangle> Triangles;
};

/**
 * The input M after cleaning and resolving: no two points are equal, no triangle is degenerate, no
 * two triangles are equal or meet other than in a shared vertex or edge.
 *
 * `PointSources`, one per point, is the given point at these coordinates, or -1 for a point that
 * resolving made. `TriangleSources`, `Windings` and `Counts` have one entry per triangle: the given
 * triangle that it is (a part of), and of all given triangles merged into it their signed number
 * (those of opposite orientation count -1) and their number.
 */
struct ResolvedMesh
{
  std::vector<Point> Points;
  std::vector<int> PointSources;
  std::vector<Triangle> Triangles;
  std::vector<int> TriangleSources;
  std::vector<int> Windings;
  std::vector<int> Counts;
};

/**
 * The tetrahedra of the initial approximation C0, constrained by the input M.
 *
 * `Surface` is M; after M's own points its `Points` (and `PointSources`) hold the Steiner points.
 * Cells are positively oriented: (b - a) x (c - a) . (d - a) > 0. Entry f of `Neighbors` and
 * `Constraints` belongs to the face opposite to corner f: the tetrahedron behind it (-1: none, the
 * face is on C0) and the triangle of M that it lies on (-1: none).
 */
struct Tetrahedralization
{
  ResolvedMesh Surface;
  std::vector<std::array<int, 4>> Cells;
  std::vector<std::array<int, 4>> Neighbors;
  std::vector<std::array<int, 4>> Constraints;

  /** The face opposite to corner f of a cell, counter-clockwise seen from outside the cell. */
  Triangle OutwardFace(int cell, int f) const
  {
    static constexpr int corners[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
    const std::array<int, 4>& c = this->Cells[cell];
    return { c[corners[f][0]], c[corners[f][1]], c[corners[f][2]] };
  }

  Point Centroid(int cell) const
  {
    Point sum = { 0.0, 0.0, 0.0 };
    for (const int corner : this->Cells[cell])
    {
      for (int i = 0; i < 3; ++i)
      {
        sum[i] += 0.25 * this->Surface.Points[corner][i];
      }
    }
    return sum;
  }
};

} // namespace carving

#endif
