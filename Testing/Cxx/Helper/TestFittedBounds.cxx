// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/FittedBounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace carving;
using carving::helper::FittedBounds;

// A box with a corner of a triangle on its border always overlaps the bounds, however thin, small
// or large the triangle is.
TEST(FittedBounds, ReachTheCorners)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0), exponent(-120.0, 120.0);
  std::uniform_int_distribution<int> any(0, 2);
  const auto point = [&] {
    return Point{ coordinate(random), coordinate(random), coordinate(random) };
  };
  for (int i = 0; i < 20000; ++i)
  {
    const double scale = i % 2 == 0 ? 1.0 : std::pow(10.0, exponent(random));
    const Point a = scale * point(), b = scale * point();
    const std::array<Point, 3> triangle = { a, b,
      Between(a, b, coordinate(random)) +
        (std::pow(10.0, -8.0 * std::abs(coordinate(random))) * scale) * point() };
    const FittedBounds<3> bounds(triangle);
    Box box;
    box.Add(triangle[any(random)]);
    EXPECT_TRUE(bounds.Overlaps(box));
    const Point& corner = triangle[any(random)];
    box = {};
    for (int k = 0; k < 3; ++k)
    {
      const double width = 0.1 * scale * std::abs(coordinate(random));
      const bool below = coordinate(random) < 0.0;
      box.Lower[k] = below ? corner[k] - width : corner[k];
      box.Upper[k] = below ? corner[k] : corner[k] + width;
    }
    EXPECT_TRUE(bounds.Overlaps(box)) << i;
  }
}

// Boxes beside a thin triangle that is parallel to no axis do not overlap the bounds, although most
// of them overlap its bounding box.
TEST(FittedBounds, FitThinTriangles)
{
  const std::array<Point, 3> triangle = { { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 },
    { 1.0, 1.0, 0.99 } } };
  const FittedBounds<3> bounds(triangle);
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  int boxes = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Point p = { coordinate(random), coordinate(random), coordinate(random) };
    // All points of the triangle have x = y, and z from 0.99 x to x.
    if (std::abs(p[0] - p[1]) > 0.03 || p[2] > p[0] + 0.05 || p[2] < 0.99 * p[0] - 0.05)
    {
      ++boxes;
      EXPECT_FALSE(bounds.Overlaps({ p, p + Point{ 0.01, 0.01, 0.01 } }))
        << p[0] << ' ' << p[1] << ' ' << p[2];
    }
  }
  EXPECT_GT(boxes, 1500);
}

// Bounds of coordinates whose products overflow are those of the bounding box.
TEST(FittedBounds, OverlapWhereProductsOverflow)
{
  const std::array<Point, 3> triangle = { { { 0.0, 0.0, 0.0 }, { 1e200, 1e200, 1e200 },
    { 1e200, 1e200, 0.0 } } };
  const FittedBounds<3> bounds(triangle);
  EXPECT_TRUE(bounds.Overlaps({ { 1e200, 1e200, 0.0 }, { 2e200, 2e200, 1e199 } }));
  EXPECT_FALSE(bounds.Overlaps({ { 2e200, 2e200, 0.0 }, { 3e200, 3e200, 1e199 } }));
}
