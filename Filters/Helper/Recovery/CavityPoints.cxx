// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/CavityPoints.h"

#include <cmath>

namespace carving::helper
{
namespace
{

using Point3 = Inexact::Point_3;

double Draw(std::mt19937& random)
{
  return random() / static_cast<double>(std::mt19937::max());
}

/** A point in the convex hull of the corners. */
template <std::size_t N>
Point3 DrawWithin(const std::array<Point3, N>& corners, std::mt19937& random)
{
  double total = 0.0;
  Inexact::Vector_3 sum(0.0, 0.0, 0.0);
  for (const Point3& p : corners)
  {
    const double weight = 1e-3 + Draw(random);
    total += weight;
    sum = sum + weight * (p - CGAL::ORIGIN);
  }
  return CGAL::ORIGIN + sum / total;
}

/** A point in front of a triangle, often close to it. */
Point3 DrawAbove(const Corners3& t, double sign, std::mt19937& random)
{
  const auto normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
  const double scale = std::sqrt((t[1] - t[0]).squared_length() / normal.squared_length());
  const double height = sign * std::exp(-6.0 * Draw(random)) * scale;
  return DrawWithin(t, random) + height * normal;
}

std::vector<Point3> DrawSamples(const std::vector<Corners4>& cells, const Corners3& triangle,
  const Cavity& cavity, std::mt19937& random)
{
  constexpr int Rounds = 16;
  std::vector<Point3> samples;
  for (int i = 0; i < Rounds; ++i)
  {
    samples.push_back(DrawWithin(cells[i % cells.size()], random));
    samples.push_back(DrawAbove(triangle, i % 2 == 0 ? 1.0 : -1.0, random));
    const auto& [a, b, c] = cavity.Front[i % cavity.Front.size()];
    samples.push_back(
      DrawAbove({ cavity.Points[a], cavity.Points[b], cavity.Points[c] }, 1.0, random));
  }
  return samples;
}

} // namespace

void AddCavityPoints(const std::vector<Corners4>& cells, const Corners3& triangle, int maximum,
  std::mt19937& random, Cavity& cavity)
{
  const std::vector<Point3> samples = DrawSamples(cells, triangle, cavity, random);
  std::vector<std::vector<char>> visible;
  for (const Point3& p : samples)
  {
    Cavity with = cavity;
    with.AddPoint(p, false, false);
    visible.push_back(Filling(with).FindVisible(static_cast<int>(cavity.Points.size())));
  }
  std::vector<char> covered(cavity.Front.size(), 0);
  for (int n = 0; n < maximum; ++n)
  {
    int most = 0;
    std::size_t best = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      int gain = 0;
      for (std::size_t k = 0; k < covered.size(); ++k)
      {
        gain += visible[i][k] && !covered[k];
      }
      if (gain > most)
      {
        most = gain;
        best = i;
      }
    }
    if (most == 0)
    {
      return;
    }
    for (std::size_t k = 0; k < covered.size(); ++k)
    {
      covered[k] = covered[k] || visible[best][k];
    }
    cavity.AddPoint(samples[best], false, false);
  }
}

} // namespace carving::helper
