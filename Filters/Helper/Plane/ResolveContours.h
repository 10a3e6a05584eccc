// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_ResolveContours_h
#define carving_ResolveContours_h

#include "Core/Mesh/Mesh.h"
#include "Core/Mesh/Progress.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <string>
#include <vector>

/**
 * Edges in the plane of the first two coordinates, from which points get their identity; the third
 * goes with them. `Initial` has per edge whether the boundary of C0 runs along it; one that is no
 * edge of M has a count of 0.
 */
struct Contours : carving::ResolvedInput<2>
{
  std::vector<char> Initial;
};

/** Of vertices that come from Contours the number of their point, else -1. */
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

/** Inserts points, neighbors one after the other so that each is found from the one before it. */
std::vector<PlaneTriangulation::Vertex_handle> InsertInOrder(
  const std::vector<PlaneKernel::Point_2>& places, PlaneTriangulation& triangulation);

/** Inserts points, no two of them equal, with their numbers. */
std::vector<PlaneTriangulation::Vertex_handle> InsertPoints(
  const std::vector<carving::Point>& points, PlaneTriangulation& triangulation);

/** The given edges: those of M, or the boundary of C0, all of whose points are new. */
Contours AsContours(const carving::ContourSet& given, bool initial);

/** Puts the edges of another set after those of the first. */
void Append(const Contours& other, Contours& contours);

/**
 * Merges equal points (the first one's source stays), drops edges without length and points that no
 * edge uses, and merges equal edges into the first of them. Points and edges keep their order.
 */
Contours Clean(const Contours& contours);

/**
 * Splits edges where they meet until they do so in common ends only. Points of intersection are
 * exact, then rounded to double; since rounding can make new ones, it looks again until there is none.
 *
 * `contours` has been cleaned and stays so. `meetings` is the number of points inside given edges at
 * which others meet them. Returns an empty string or why the end was not reached.
 */
std::string Resolve(Contours& contours, int& meetings, const carving::Progress& progress);

#endif
