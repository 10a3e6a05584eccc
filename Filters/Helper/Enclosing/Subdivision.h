// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The triangles of M in parts: split where points are put on them, and Delaunay in their planes.
 */
#ifndef carving_Subdivision_h
#define carving_Subdivision_h

#include "Core/Mesh/Mesh.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

/**
 * A point put on a triangle is rounded off its plane by a little. What counts from then on as M are the
 * parts: triangles through the rounded points, joined in the same vertices and edges as before. Parts of
 * one triangle swap their diagonals until they are Delaunay in its plane, since then they are mostly faces
 * of the Delaunay tetrahedralization of all points too.
 */
class Subdivision
{
public:
  struct Part
  {
    carving::Triangle Corners; ///< oriented as its triangle
    int Parent;                ///< the triangle of M; -1 once the part is gone
  };

  /** Parts by their number, which is never given again. */
  struct Change
  {
    std::vector<int> Gone;
    std::vector<int> Made;
  };

  /** Every triangle is one part, of the same number. */
  explicit Subdivision(const carving::ResolvedMesh& input);

  /** Adds a point that lies on no part yet; returns its number. */
  int AddPoint(const carving::Point& p);

  Change SplitPart(int part, int vertex);

  /** Splits all parts that have the edge. */
  Change SplitEdge(int a, int b, int vertex);

  /**
   * Swaps the diagonal of a part and a neighbor out of the same triangle, where both are as good as
   * Delaunay and `areFaces` says yes to the two parts that come of it.
   */
  template <class AreFaces>
  bool SwapTie(int part, const AreFaces& areFaces, Change& change);

  /** Whether the edge opposite to corner i is (a part of) an edge of M, not only of a part. */
  bool OnEdgeOfInput(int part, int i) const;

  const std::vector<carving::Point>& GetPoints() const
  {
    return this->Points;
  }
  const std::vector<Part>& GetParts() const
  {
    return this->Parts;
  }
  std::array<carving::Point, 3> GetCorners(int part) const
  {
    const carving::Triangle& c = this->Parts[part].Corners;
    return { this->Points[c[0]], this->Points[c[1]], this->Points[c[2]] };
  }

private:
  /** Two parts as the four corners around their common edge: apex, a, opposite, b. */
  struct Quad
  {
    int Other = -1; ///< the part across the edge; -1: none of the same triangle
    int Apex, A, Opposite, B;
    /** The sum of the cotangents of the angles at Apex and Opposite; Delaunay if not negative. */
    double Cotangents;
    bool Convex;
  };

  static std::uint64_t Key(int a, int b);
  int Make(const carving::Triangle& corners, int parent, Change& change);
  void Remove(int part, Change& change);
  Quad GetQuad(int part, int i) const;
  std::array<int, 2> Swap(int part, const Quad& quad, Change& change);
  void Legalize(std::vector<int> parts, int apex, Change& change);
  void Settle(Change& change) const;

  std::vector<carving::Point> Points;
  std::vector<Part> Parts;
  std::vector<carving::Point> Normals; ///< of the triangles of M
  std::unordered_map<std::uint64_t, std::vector<int>> PartsOfEdge;
};

template <class AreFaces>
bool Subdivision::SwapTie(int part, const AreFaces& areFaces, Change& change)
{
  constexpr double Tie = 1e-6;
  for (int i = 0; i < 3; ++i)
  {
    const Quad quad = this->GetQuad(part, i);
    if (quad.Other >= 0 && quad.Convex && quad.Cotangents < Tie &&
      areFaces(quad.Apex, quad.A, quad.Opposite) && areFaces(quad.Apex, quad.Opposite, quad.B))
    {
      this->Swap(part, quad, change);
      return true;
    }
  }
  return false;
}

#endif
