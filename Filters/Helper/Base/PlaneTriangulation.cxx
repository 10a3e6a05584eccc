// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Base/PlaneTriangulation.h"

#include "Helper/Base/Kernels.h"

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <numeric>

namespace carving::helper
{

std::vector<PlaneTriangulation::Vertex_handle> InsertInOrder(
  const std::vector<PlaneKernel::Point_2>& points, PlaneTriangulation& triangulation)
{
  std::vector<Inexact::Point_2> rounded;
  rounded.reserve(points.size());
  for (const auto& point : points)
  {
    rounded.emplace_back(CGAL::to_double(point.x()), CGAL::to_double(point.y()));
  }
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  using Map = CGAL::Pointer_property_map<Inexact::Point_2>::type;
  CGAL::spatial_sort(order.begin(), order.end(),
    CGAL::Spatial_sort_traits_adapter_2<Inexact, Map>(CGAL::make_property_map(rounded)));
  std::vector<PlaneTriangulation::Vertex_handle> vertices(points.size());
  PlaneTriangulation::Face_handle hint;
  for (const std::size_t i : order)
  {
    vertices[i] = triangulation.insert(points[i], hint);
    hint = vertices[i]->face();
  }
  return vertices;
}

std::vector<PlaneTriangulation::Vertex_handle> InsertPoints(
  const std::vector<Point>& points, PlaneTriangulation& triangulation)
{
  std::vector<PlaneKernel::Point_2> places;
  places.reserve(points.size());
  for (const Point& point : points)
  {
    places.emplace_back(point[0], point[1]);
  }
  const auto vertices = InsertInOrder(places, triangulation);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    vertices[i]->info().Value = static_cast<int>(i);
  }
  return vertices;
}

} // namespace carving::helper
