// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tetrahedralizations small enough to be worked out by hand.
 */
#ifndef SmallMeshes_h
#define SmallMeshes_h

#include "Core/Carving/Carver.h"
#include "Core/Mesh/Mesh.h"
#include "Core/Stream/Level.h"
#include "Core/Stream/StoredStream.h"

namespace small
{

/** Points and positively oriented cells, constrained by triangles; finds neighbors by itself. */
carving::Tetrahedralization Assemble(const std::vector<carving::Point>& points,
  const std::vector<std::array<int, 4>>& cells, const std::vector<carving::Triangle>& triangles);

/**
 * A tetrahedron (points 0 to 3) around a smaller one (points 4 to 7): twelve cells between them and
 * cell 12 inside. M is `triangles`.
 */
carving::Tetrahedralization NestedTetrahedra(const std::vector<carving::Triangle>& triangles);
/** The faces of its outer and of its inner tetrahedron, oriented outward. */
std::vector<carving::Triangle> OuterFaces();
std::vector<carving::Triangle> InnerFaces();

std::vector<carving::Triangle> Flipped(std::vector<carving::Triangle> triangles);
std::vector<carving::Triangle> Joined(
  std::vector<carving::Triangle> a, const std::vector<carving::Triangle>& b);

/**
 * A row of `n` tetrahedra, each of which shares a face with the next; cell i has the points i to
 * i + 3, and its longest edge gets shorter with i. M is the last cell's last face.
 */
carving::Tetrahedralization Row(int n);

/**
 * A row of `n` congruent tetrahedra, each of which shares a face with the next; cell i has the
 * points i to i + 3, and its centroid is exactly 1 away from that of the next. M is `triangles`.
 */
carving::Tetrahedralization EvenRow(int n, const std::vector<carving::Triangle>& triangles = {});

/** Both faces, the inner ones facing inward: a solid around a hollow. */
carving::Tetrahedralization HollowTetrahedron();

carving::Stream Carved(const carving::Tetrahedralization& mesh,
  const carving::CarveOptions& options = {},
  carving::SolidRule rule = carving::SolidRule::NonzeroWinding);
/** Options for one tetrahedron a step. */
carving::CarveOptions OneByOne();

/** A stream with one tetrahedron a step, stored. Only numbers of cells change if M has no solid. */
carving::StoredStream<3> StoreOneByOne(const carving::Tetrahedralization& mesh);

/** The faces' corners. */
std::vector<carving::Triangle> Triangles(const carving::Level<3>& level);

/** A mesh that needs no resolving. */
carving::ResolvedMesh Resolved(const carving::TriangleMesh& mesh);

} // namespace small

#endif
