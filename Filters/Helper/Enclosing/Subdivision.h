// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The triangles of M, split into parts where points are added on them.
 */
#ifndef carving_Subdivision_h
#define carving_Subdivision_h

#include "Core/Mesh/Mesh.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace carving::helper
{

/** The two ends of an edge, in any order, as one number. */
inline std::uint64_t EdgeKey(int a, int b)
{
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
    static_cast<std::uint32_t>(std::max(a, b));
}

/**
 * A point added on a triangle is off its plane by a rounding. From then on, M consists of the
 * parts: triangles through the rounded points that share vertices and edges as before.
 */
class Subdivision
{
public:
  struct Part
  {
    Triangle Corners; ///< oriented as its triangle
    int Parent;       ///< the triangle of M; -1 after the part has been removed
  };

  /** Indices of parts. An index is never used again. */
  struct Change
  {
    std::vector<int> Gone;
    std::vector<int> Made;
  };

  /** At first, every triangle is one part, with the same index. */
  explicit Subdivision(const ResolvedMesh& input);

  /** Adds a point without splitting a part; returns its index. */
  int AddPoint(const Point& p);

  /** Puts a point that no part has as a corner elsewhere. */
  void MovePoint(int index, const Point& p)
  {
    this->Points[index] = p;
  }

  /** Removes the point that was added last, which is no corner of a part. */
  void RemoveLastPoint()
  {
    this->Points.pop_back();
  }

  /** Splits a part into three. */
  void SplitPart(int part, int vertex, Change& change);

  /** Splits all parts that share an edge, if there are any, into two each. */
  void SplitEdge(int a, int b, int vertex, Change& change);

  /**
   * Swaps the edges that are opposite to a new vertex until the parts of each triangle are Delaunay
   * in its plane. Most of them are then faces of the Delaunay tetrahedralization of all points, too.
   */
  void Legalize(int vertex, Change& change);

  /**
   * Swaps the diagonal between a part and a neighbor of the same triangle if both diagonals are
   * Delaunay, except for rounding, and `areFaces` returns true for both new parts. Returns whether
   * it did.
   */
  template <class AreFaces>
  bool SwapTie(int part, const AreFaces& areFaces, Change& change);

  /** Whether the edge opposite to corner i is (a part of) an edge of M. */
  bool OnEdgeOfInput(int part, int i) const;

  /** Removes a part. */
  void Take(int part);

  /** Adds a part of a triangle of M; returns its index. */
  int Give(const Triangle& corners, int parent);

  const std::vector<Point>& GetPoints() const
  {
    return this->Points;
  }
  const std::vector<Part>& GetParts() const
  {
    return this->Parts;
  }
  std::array<Point, 3> GetCorners(int part) const
  {
    const Triangle& c = this->Parts[part].Corners;
    return { this->Points[c[0]], this->Points[c[1]], this->Points[c[2]] };
  }

private:
  using EdgeMap = std::unordered_map<std::uint64_t, std::vector<int>>;

  /**
   * Two parts of one triangle as the cycle of their corners (Apex, A, Opposite, B); the edge AB is
   * common.
   */
  struct Quad
  {
    int Other = -1; ///< the part with the corner Opposite; -1: there is none
    int Apex, A, Opposite, B;
    /**
     * The sum of the cotangents of the angles at Apex and Opposite. The edge AB is Delaunay if it
     * is not negative.
     */
    double Cotangents;
    bool Convex;
  };

  EdgeMap& GetPartsOfEdge() const;
  Quad GetQuad(int part, int i) const;
  void Swap(int part, const Quad& quad, Change& change);
  void Make(const Triangle& corners, int parent, Change& change);
  void Remove(int part, Change& change);

  std::vector<Point> Points;
  std::vector<Part> Parts;
  /** Filled when it is first needed: a mesh whose parts are not split does without. */
  mutable EdgeMap PartsOfEdge;
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

} // namespace carving::helper

#endif
