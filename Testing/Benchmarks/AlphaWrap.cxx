// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The peer that encloses meshes, too: CGAL's alpha wrap.
 *
 * usage: alpha-wrap MESH.off WRAP.off VERTICES|d/N
 *
 * Searches for the alpha whose wrap has just at most so many vertices, or takes the diagonal of the
 * mesh's bounds divided by N. Prints the seconds of that wrap alone.
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
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace
{

struct Soup
{
  std::vector<Kernel::Point_3> Points;
  std::vector<std::array<std::size_t, 3>> Triangles;
};

/** Returns the seconds. */
double Wrap(const Soup& soup, double alpha, Mesh& wrap)
{
  const auto start = std::chrono::steady_clock::now();
  CGAL::alpha_wrap_3(soup.Points, soup.Triangles, alpha, alpha / 30.0, wrap);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double Diagonal(const Soup& soup)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(soup.Points.begin(), soup.Points.end());
  return std::sqrt(std::pow(box.xmax() - box.xmin(), 2) + std::pow(box.ymax() - box.ymin(), 2) +
    std::pow(box.zmax() - box.zmin(), 2));
}

/** Returns the seconds of the best wrap alone. */
double WrapTo(const Soup& soup, double vertices, Mesh& best)
{
  double seconds = 0.0;
  // The finer the wrap, the longer each trial: alpha is halved first, and bisected then.
  double fine = 0.0, coarse = Diagonal(soup), alpha = coarse / 4.0;
  for (int trial = 0; trial < 14; ++trial)
  {
    Mesh wrap;
    const double taken = Wrap(soup, alpha, wrap);
    if (wrap.number_of_vertices() <= vertices)
    {
      coarse = alpha;
      best = wrap;
      seconds = taken;
      if (wrap.number_of_vertices() >= 0.95 * vertices)
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
  return seconds;
}

} // namespace

int main(int argc, char* argv[])
{
  Soup soup;
  std::ifstream in(argc == 4 ? argv[1] : "");
  if (!CGAL::IO::read_OFF(in, soup.Points, soup.Triangles))
  {
    std::cerr << "usage: alpha-wrap MESH.off WRAP.off VERTICES|d/N\n";
    return 2;
  }
  const std::string size = argv[3];
  Mesh wrap;
  const double seconds = size.rfind("d/", 0) == 0
    ? Wrap(soup, Diagonal(soup) / std::atof(size.c_str() + 2), wrap)
    : WrapTo(soup, std::atof(size.c_str()), wrap);
  std::cout << seconds << "\n";
  return CGAL::IO::write_polygon_mesh(argv[2], wrap, CGAL::parameters::stream_precision(17)) ? 0
                                                                                             : 1;
}
