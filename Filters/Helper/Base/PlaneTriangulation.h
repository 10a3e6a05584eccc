// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The constrained Delaunay triangulation of a plane, in which constraints may cross. Points of
 * intersection are exact.
 */
#ifndef carving_PlaneTriangulation_h
#define carving_PlaneTriangulation_h

#include "Core/Mesh/Mesh.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <vector>

namespace carving::helper
{

/** The index of the point at a vertex; -1 at a vertex where constraints cross. */
struct PointIndex
{
  int Value = -1;
};
using PlaneKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using PlaneTriangulation =
  CGAL::Constrained_triangulation_plus_2<CGAL::Constrained_Delaunay_triangulation_2<PlaneKernel,
    CGAL::Triangulation_data_structure_2<
      CGAL::Triangulation_vertex_base_with_info_2<PointIndex, PlaneKernel>,
      CGAL::Constrained_triangulation_face_base_2<PlaneKernel>>,
    CGAL::Exact_intersections_tag>>;

/**
 * Inserts points along a space-filling curve, so that each point is found quickly from the point
 * inserted before it. Returns the vertex of each point.
 */
std::vector<PlaneTriangulation::Vertex_handle> InsertInOrder(
  const std::vector<PlaneKernel::Point_2>& points, PlaneTriangulation& triangulation);

/**
 * Inserts points, no two of which have the same first two coordinates, with their indices. Returns
 * the vertex of each point.
 */
std::vector<PlaneTriangulation::Vertex_handle> InsertPoints(
  const std::vector<Point>& points, PlaneTriangulation& triangulation);

} // namespace carving::helper

#endif
