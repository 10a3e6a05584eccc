// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The triangles of M, split into parts where points are added on them.
 */
#ifndef carving_Subdivision_h
#define carving_Subdivision_h

#include "Core/Mesh/Mesh.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cstdint>
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

  /** Splits a part into three. */
  void SplitPart(int part, int vertex, Change& change);

  /** Splits a part into two at its edge from a to b, in any order. */
  void SplitAtEdge(int part, int a, int b, int vertex, Change& change);

  /** Puts another vertex in the place of a corner of a part. */
  void MoveCorner(int part, int from, int to);

  /** Removes a part. */
  void Take(int part)
  {
    this->Parts[part].Parent = -1;
  }

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
  double AreaOf(const Triangle& corners) const
  {
    const Point& a = this->Points[corners[0]];
    return Length(Cross(this->Points[corners[1]] - a, this->Points[corners[2]] - a)) / 2.0;
  }
  /** Whether a part has an edge between two vertices. */
  bool HasEdge(int part, int a, int b) const
  {
    const Triangle& corners = this->Parts[part].Corners;
    const auto has = [&corners](int vertex)
    { return std::find(corners.begin(), corners.end(), vertex) != corners.end(); };
    return has(a) && has(b);
  }

private:
  void Replace(int part, const std::vector<Triangle>& pieces, Change& change);

  std::vector<Point> Points;
  std::vector<Part> Parts;
};

} // namespace carving::helper

#endif
