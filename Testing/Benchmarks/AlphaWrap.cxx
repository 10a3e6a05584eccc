// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The peer of compare_levels.py that encloses meshes, too: CGAL's alpha wrap.
 *
 * usage: alpha-wrap MESH.off WRAP.off VERTICES
 *
 * Searches for the alpha whose wrap has just at most so many vertices, and prints the seconds of
 * that wrap alone.
 */
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::ifstream in(argc == 4 ? argv[1] : "");
  if (!CGAL::IO::read_OFF(in, points, triangles))
  {
    std::cerr << "usage: alpha-wrap MESH.off WRAP.off VERTICES\n";
    return 2;
  }
  const double most = std::atof(argv[3]);
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  const double diagonal = std::sqrt(std::pow(box.xmax() - box.xmin(), 2) +
    std::pow(box.ymax() - box.ymin(), 2) + std::pow(box.zmax() - box.zmin(), 2));
  Mesh best;
  double seconds = 0.0;
  // The finer the wrap, the longer each trial: alpha is halved first, and bisected then.
  double fine = 0.0, coarse = diagonal, alpha = diagonal / 4.0;
  for (int trial = 0; trial < 14; ++trial)
  {
    const auto start = std::chrono::steady_clock::now();
    Mesh wrap;
    CGAL::alpha_wrap_3(points, triangles, alpha, alpha / 30.0, wrap);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (wrap.number_of_vertices() <= most)
    {
      coarse = alpha;
      best = wrap;
      seconds = taken.count();
      if (wrap.number_of_vertices() >= 0.95 * most)
      {
        break;
      }
    }
    else
    {
      fine = alpha;
    }
    alpha = fine > 0.0 ? std::sqrt(fine * coarse) : coarse / 2.0;
  }
  std::cout << seconds << "\n";
  return CGAL::IO::write_polygon_mesh(argv[2], best, CGAL::parameters::stream_precision(17)) ? 0
                                                                                             : 1;
}
