// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Tetrahedra that fill the space within a border.
 */
#ifndef carving_SpaceFilling_h
#define carving_SpaceFilling_h

#include "Helper/Enclosing/PiercedMesh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <vector>

namespace carving::helper
{

using VertexTriangle = std::array<PiercedMesh::Vertex, 3>;

/** Triangles around a space. Tetrahedra with a fourth corner in it are oriented positively. */
using Border = std::vector<VertexTriangle>;

inline bool Has(const VertexTriangle& t, const PiercedMesh::Vertex& v)
{
  return std::find(t.begin(), t.end(), v) != t.end();
}

/** Tetrahedra between the triangles of a space's border and other vertices. */
struct SpaceFilling
{
  std::vector<PiercedMesh::Vertex> Vertices; ///< none for a vertex that is yet to be made
  std::vector<Inexact::Point_3> Points;      ///< per vertex
  std::vector<std::array<int, 4>> Cells;
};

/** The filling with one apex, which may be a vertex of the border, or else is made at a point. */
SpaceFilling MakeStar(
  const Border& border, const PiercedMesh::Vertex& apex, const Inexact::Point_3& p);

/** The star of the vertex of a border that sees all of it best; nothing if no vertex does. */
std::optional<SpaceFilling> FillFromVertex(const Border& border);

/**
 * The star of a point that sees all of a border. Points on the ways from `from`, which saw all of
 * it before, to the centers of the triangles are tried, ever closer to `from`.
 */
std::optional<SpaceFilling> FillFromPoint(const Border& border, const Inexact::Point_3& from);

/**
 * A filling of the space of cells around `v` within a border that has been searched for, with up to
 * `points` further points.
 */
std::optional<SpaceFilling> SearchFilling(const std::vector<PiercedMesh::Cell>& cells,
  const Border& border, const PiercedMesh::Vertex& v, int points, std::mt19937& random);

} // namespace carving::helper

#endif
