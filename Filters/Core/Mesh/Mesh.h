// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plain mesh types that the core, the helper program and the VTK classes share.
 */
#ifndef carving_Mesh_h
#define carving_Mesh_h

#include "Core/Mesh/FaceConstraints.h"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace carving
{

using Point = std::array<double, 3>;
using Triangle = std::array<int, 3>;

/** Triangles as the user gave them. Any triangle soup is allowed. */
struct TriangleMesh
{
  std::vector<Point> Points;
  std::vector<Triangle> Triangles;
};

/** Directed edges as the user gave them. They lie in the plane of the first two coordinates. */
struct ContourSet
{
  std::vector<Point> Points;
  std::vector<std::array<int, 2>> Edges;
};

/**
 * The input M after cleaning and resolving. Facets are triangles in space (D = 3) or edges in a
 * plane (D = 2). No two points are equal, no facet is degenerate, and any two facets meet in shared
 * vertices and edges only.
 */
template <int D>
struct ResolvedInput
{
  std::vector<Point> Points;
  /** Per point: the given point with these coordinates, or -1 for a point that resolving made. */
  std::vector<int> PointSources;
  std::vector<std::array<int, D>> Facets;
  /** Per facet: the given facet that it is, or is a part of. */
  std::vector<int> FacetSources;
  /**
   * Per facet: the number of given facets merged into it. Those of opposite orientation count -1.
   */
  std::vector<int> SignedMultiplicities;
  /** Per facet: the number of given facets merged into it, whatever their orientation. */
  std::vector<int> Multiplicities;
};
using ResolvedMesh = ResolvedInput<3>;

/** Appends a facet that is, or is a part of, facet i of `from`, with the attributes of facet i. */
template <int D>
void AppendFacet(const ResolvedInput<D>& from, std::size_t i, const std::array<int, D>& corners,
  ResolvedInput<D>& to)
{
  to.Facets.push_back(corners);
  to.FacetSources.push_back(from.FacetSources[i]);
  to.SignedMultiplicities.push_back(from.SignedMultiplicities[i]);
  to.Multiplicities.push_back(from.Multiplicities[i]);
}

/** Neighbors that are not cells. */
constexpr int Outside = -1; ///< the exterior of C0
constexpr int Solid = -2;   ///< the solid of M, if its cells are not stored

/**
 * The corners of each face of a positively oriented tetrahedron. The tetrahedron lies behind the
 * face.
 */
constexpr int FaceCorners[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

/** The two corners of a tetrahedron other than p and q, the smaller first. */
constexpr std::array<int, 2> OtherCorners(int p, int q)
{
  const int first = p > 0 && q > 0 ? 0 : p + q > 1 ? 1 : 2;
  return { first, 6 - p - q - first };
}

/** A face of a cell has a number of 32 bits: four times the cell's, plus the corner's. */
constexpr int MaximumCells = std::numeric_limits<int>::max() / 4;

/**
 * The cells of the initial approximation C0, constrained by the input M: tetrahedra in space
 * (D = 3), triangles in a plane (D = 2).
 *
 * Cells are positively oriented: (b - a) x (c - a) . (d - a) > 0 in space, counter-clockwise in the
 * plane. Face f of a cell is opposite to corner f. A face is constraining if it lies on a facet of
 * M.
 */
template <int D>
struct Decomposition
{
  using Cell = std::array<int, D + 1>;
  using Facet = std::array<int, D>;

  /** M. The Steiner points follow the points of M. */
  ResolvedInput<D> Surface;
  std::vector<Cell> Cells;     ///< corners
  std::vector<Cell> Neighbors; ///< per face: the other cell, Outside or Solid
  FaceConstraints<D> Constraints;

  // In enclosing mode M need not be a union of faces. `Surface` then consists of the faces that
  // overlap a triangle of M in an area.
  std::vector<char>
    Kept; ///< per cell: M pierces the cell, which is never carved; empty in exact mode
  ResolvedInput<D> Unresolved; ///< M, resolved if more of it is met then; empty in exact mode
  /** Per facet of `Unresolved`: the share of its area that pierces no cell; empty in exact mode. */
  std::vector<double> MetShares;

  /** M, whether or not its facets are faces. */
  const ResolvedInput<D>& GetInput() const
  {
    return this->Unresolved.Facets.empty() ? this->Surface : this->Unresolved;
  }

  bool IsKept(int cell) const
  {
    return !this->Kept.empty() && this->Kept[cell];
  }

  /** Face f of a cell, oriented so that the cell lies behind it. */
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

/** The side on which a cell lies of the facet at its face f: 0 behind, 1 in front. */
template <int D>
int SideOfFacet(const Decomposition<D>& mesh, int cell, int f)
{
  const int facet = mesh.Constraints.Get(cell, f);
  return SameDirection<D>(mesh.OutwardFace(cell, f), mesh.Surface.Facets[facet]) ? 0 : 1;
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
