// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plain mesh types that the core, the helper program and the VTK classes share.
 */
#ifndef carving_Mesh_h
#define carving_Mesh_h

#include <array>
#include <cstddef>
#include <utility>
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

/** Directed edges as the user gave them, in the plane of the first two coordinates. */
struct ContourSet
{
  std::vector<Point> Points;
  std::vector<std::array<int, 2>> Edges;
};

/**
 * The input M after cleaning and resolving. Its facets are triangles in space (D = 3) or edges in a
 * plane (D = 2). No two points are equal, no facet is degenerate, no two facets are equal or meet
 * other than in a shared vertex or edge.
 *
 * `PointSources`, one per point, is the given point at these coordinates, or -1 for a point that
 * resolving made. `FacetSources`, `SignedMultiplicities` and `Multiplicities` have one entry per facet: the given facet
 * that it is (a part of), and of all given facets merged into it their signed number (those of
 * opposite orientation count -1) and their number.
 */
template <int D>
struct ResolvedInput
{
  std::vector<Point> Points;
  std::vector<int> PointSources;
  std::vector<std::array<int, D>> Facets;
  std::vector<int> FacetSources;
  std::vector<int> SignedMultiplicities;
  std::vector<int> Multiplicities;
};
using ResolvedMesh = ResolvedInput<3>;

/** Appends a facet that is (a part of) facet i of `from`, with all that is known of that. */
template <int D>
void AppendFacet(const ResolvedInput<D>& from, std::size_t i, const std::array<int, D>& corners,
  ResolvedInput<D>& to)
{
  to.Facets.push_back(corners);
  to.FacetSources.push_back(from.FacetSources[i]);
  to.SignedMultiplicities.push_back(from.SignedMultiplicities[i]);
  to.Multiplicities.push_back(from.Multiplicities[i]);
}

/** What a cell has for a neighbor where there is no other cell. */
constexpr int Outside = -1; ///< the exterior of C0
constexpr int Solid = -2;   ///< the solid of M, where its cells have been left out

/** The corners of each face of a positively oriented tetrahedron, which lies behind it. */
constexpr int FaceCorners[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

/** The two corners of a tetrahedron other than p and q, the smaller first. */
constexpr std::array<int, 2> OtherCorners(int p, int q)
{
  const int first = p > 0 && q > 0 ? 0 : p + q > 1 ? 1 : 2;
  return { first, 6 - p - q - first };
}

/**
 * The cells of the initial approximation C0, constrained by the input M: tetrahedra in space (D = 3),
 * triangles in a plane (D = 2).
 *
 * `Surface` is M; after M's own points its `Points` (and `PointSources`) hold the Steiner points.
 * Cells are positively oriented: (b - a) x (c - a) . (d - a) > 0, or counter-clockwise in the plane.
 * Entry f of `Neighbors` and `Constraints` belongs to the face opposite to corner f: the cell behind
 * it (or Outside or Solid) and the facet of M that it lies on (-1: none).
 */
template <int D>
struct Decomposition
{
  using Cell = std::array<int, D + 1>;
  using Facet = std::array<int, D>;

  ResolvedInput<D> Surface;
  std::vector<Cell> Cells;
  std::vector<Cell> Neighbors;
  std::vector<Cell> Constraints;

  // In enclosing mode, where M need not be a union of faces. `Surface` is then the faces that overlap a
  // triangle of M in an area.
  std::vector<char> Kept;      ///< per cell: M pierces it, it is never carved; empty in exact mode
  ResolvedInput<D> Unresolved; ///< M itself; empty in exact mode

  bool IsKept(int cell) const
  {
    return !this->Kept.empty() && this->Kept[cell];
  }

  /** The face opposite to corner f of a cell, oriented so that the cell lies behind it. */
  Facet OutwardFace(int cell, int f) const
  {
    const Cell& c = this->Cells[cell];
    if constexpr (D == 3)
    {
      return { c[FaceCorners[f][0]], c[FaceCorners[f][1]], c[FaceCorners[f][2]] };
    }
    else
    {
      return { c[(f + 1) % 3], c[(f + 2) % 3] };
    }
  }

  Point Centroid(int cell) const
  {
    Point sum = { 0.0, 0.0, 0.0 };
    for (const int corner : this->Cells[cell])
    {
      for (int i = 0; i < 3; ++i)
      {
        sum[i] += this->Surface.Points[corner][i] / (D + 1);
      }
    }
    return sum;
  }
};
using Tetrahedralization = Decomposition<3>;

/** Whether two facets with the same corners have the same orientation. */
template <int D>
bool SameDirection(const std::array<int, D>& a, const std::array<int, D>& b)
{
  if constexpr (D == 3)
  {
    const int i = b[0] == a[0] ? 0 : b[1] == a[0] ? 1 : 2;
    return b[(i + 1) % 3] == a[1];
  }
  else
  {
    return a[0] == b[0];
  }
}

/** The same facet with the opposite orientation. */
template <int D>
std::array<int, D> Flipped(std::array<int, D> facet)
{
  std::swap(facet[D - 2], facet[D - 1]);
  return facet;
}

} // namespace carving

#endif
