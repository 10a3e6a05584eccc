// SPDX-License-Identifier: BSD-3-Clause
#include "Contours.h"
#include "PointMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

using namespace models;

namespace
{

double Area(const ContourModel& contour)
{
  double sum = 0.0;
  for (const auto& [a, b] : contour.Edges)
  {
    const Point &p = contour.Points[a], &q = contour.Points[b];
    sum += 0.5 * (p[0] * q[1] - p[1] * q[0]);
  }
  return sum;
}

/** Expects that one edge ends and one edge starts at each point, and counts the loops. */
void ExpectLoops(const ContourModel& contour, int number)
{
  ASSERT_EQ(contour.Edges.size(), contour.Points.size());
  std::vector<int> next(contour.Points.size(), -1), before = next;
  for (const auto& [a, b] : contour.Edges)
  {
    next[a] = b;
    before[b] = a;
  }
  EXPECT_EQ(std::count(next.begin(), next.end(), -1), 0);
  EXPECT_EQ(std::count(before.begin(), before.end(), -1), 0);
  int loops = 0;
  for (std::size_t start = 0; start < next.size(); ++start)
  {
    loops += next[start] >= 0;
    for (int i = static_cast<int>(start); next[i] >= 0;)
    {
      i = std::exchange(next[i], -1); // each loop is counted once
    }
  }
  EXPECT_EQ(loops, number);
}

int CountCrossings(const ContourModel& contour)
{
  const auto point = [&](int i) -> const Point& { return contour.Points[i]; };
  const auto separates = [&](const std::array<int, 2>& e, const std::array<int, 2>& f)
  {
    const auto side = [&](int i)
    { return carving::Cross(point(e[1]) - point(e[0]), point(i) - point(e[0]))[2]; };
    return side(f[0]) * side(f[1]) <= 0.0;
  };
  int crossings = 0;
  for (const auto& e : contour.Edges)
  {
    for (const auto& f : contour.Edges)
    {
      const bool adjacent = e[0] == f[0] || e[0] == f[1] || e[1] == f[0];
      crossings += !adjacent && separates(e, f) && separates(f, e);
    }
  }
  return crossings;
}

} // namespace

// The contours are closed, do not cross themselves and bound the right area, without the jug's
// hole.
TEST(ContourModels, LoopsBoundSolids)
{
  const ContourModel snake = SnakingContour(), jug = CarvedFigure();
  ExpectLoops(snake, 1);
  ExpectLoops(jug, 2);
  EXPECT_EQ(CountCrossings(snake), 0);
  EXPECT_EQ(CountCrossings(jug), 0);
  EXPECT_NEAR(Area(snake), 66.4, 0.1);
  EXPECT_NEAR(Area(jug), 24.9, 0.1);
}
