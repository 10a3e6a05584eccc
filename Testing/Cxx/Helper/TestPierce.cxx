// SPDX-License-Identifier: BSD-3-Clause
#include "Helper/Enclosing/Pierce.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace carving::helper;

namespace
{

using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;

Rational::Point_3 ToRational(const Inexact::Point_3& p)
{
  return { p.x(), p.y(), p.z() };
}

/**
 * Whether a triangle, clipped by a tetrahedron in rational numbers, has a point in its interior.
 */
bool PiercesByClipping(const Corners3& triangle, const Corners4& k)
{
  std::vector<Rational::Point_3> polygon;
  for (const auto& p : triangle)
  {
    polygon.push_back(ToRational(p));
  }
  std::vector<Rational::Plane_3> planes;
  for (const auto& f : carving::FaceCorners)
  {
    planes.emplace_back(ToRational(k[f[0]]), ToRational(k[f[1]]), ToRational(k[f[2]]));
  }
  for (const auto& plane : planes)
  {
    std::vector<Rational::Point_3> clipped;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const auto& p = polygon[i];
      const auto& q = polygon[(i + 1) % polygon.size()];
      const auto at = [&plane](const Rational::Point_3& x) -> CGAL::Exact_rational
      { return plane.a() * x.x() + plane.b() * x.y() + plane.c() * x.z() + plane.d(); };
      const CGAL::Exact_rational atP = at(p), atQ = at(q);
      if (atP <= 0)
      {
        clipped.push_back(p);
      }
      if ((atP < 0 && atQ > 0) || (atP > 0 && atQ < 0))
      {
        const CGAL::Exact_rational share = atP / (atP - atQ);
        clipped.push_back(p + (q - p) * share);
      }
    }
    polygon = std::move(clipped);
  }
  if (polygon.empty())
  {
    return false;
  }
  Rational::Vector_3 sum(0, 0, 0);
  for (const auto& p : polygon)
  {
    sum = sum + (p - Rational::Point_3(0, 0, 0));
  }
  const Rational::Point_3 middle =
    Rational::Point_3(0, 0, 0) + sum / CGAL::Exact_rational(static_cast<int>(polygon.size()));
  return std::all_of(planes.begin(), planes.end(),
    [&](const auto& plane) { return plane.has_on_negative_side(middle); });
}

bool Pierces(const Corners3& triangle, const Corners4& tetrahedron)
{
  return Piercer(triangle).FindContact(tetrahedron).Pierces;
}

const Corners4 Corner = { Inexact::Point_3(0, 0, 0), Inexact::Point_3(4, 0, 0),
  Inexact::Point_3(0, 4, 0), Inexact::Point_3(0, 0, 4) };

} // namespace

// A triangle that reaches the interior pierces the tetrahedron.
TEST(Piercer, PiercesWhereItReachesTheInterior)
{
  EXPECT_TRUE(Pierces({ Inexact::Point_3(1, 1, -5), { 1, 1, 5 }, { -5, 1, 0 } }, Corner));
  EXPECT_TRUE(
    Pierces({ Inexact::Point_3(0.5, 0.5, 0.5), { 1, 0.5, 0.5 }, { 0.5, 1, 0.5 } }, Corner));
}

// A triangle in the plane of a face does not pierce, whether smaller or larger than the face.
TEST(Piercer, DoesNotPierceOnAFace)
{
  EXPECT_FALSE(Pierces({ Corner[0], Corner[1], Corner[2] }, Corner));
  EXPECT_FALSE(Pierces({ Inexact::Point_3(1, 1, 0), { 2, 1, 0 }, { 1, 2, 0 } }, Corner));
  EXPECT_FALSE(Pierces({ Inexact::Point_3(-9, -9, 0), { 20, -9, 0 }, { 0, 20, 0 } }, Corner));
}

// A triangle that touches a corner or an edge from outside does not pierce.
TEST(Piercer, DoesNotPierceByTouching)
{
  EXPECT_FALSE(Pierces({ Inexact::Point_3(0, 0, 0), { -1, 0, 0 }, { 0, -1, 0 } }, Corner));
  EXPECT_FALSE(Pierces({ Inexact::Point_3(0, 0, -1), { 0, 0, 5 }, { -1, -1, 2 } }, Corner));
  EXPECT_FALSE(Pierces({ Inexact::Point_3(2, 2, 0), { 3, 3, 1 }, { 3, 3, -1 } }, Corner));
}

// The result agrees with clipping in rational numbers on small integers, which are often
// degenerate.
TEST(Piercer, AgreesWithClippingOnRandomIntegers)
{
  std::mt19937 random(11);
  std::uniform_int_distribution<int> coordinate(0, 4);
  const auto point = [&]
  { return Inexact::Point_3(coordinate(random), coordinate(random), coordinate(random)); };
  int tried = 0, pierced = 0;
  while (tried < 20000)
  {
    const Corners3 triangle = { point(), point(), point() };
    const Corners4 k = { point(), point(), point(), point() };
    if (CGAL::collinear(triangle[0], triangle[1], triangle[2]) ||
      CGAL::orientation(k[0], k[1], k[2], k[3]) != CGAL::POSITIVE)
    {
      continue;
    }
    const bool expected = PiercesByClipping(triangle, k);
    ASSERT_EQ(Pierces(triangle, k), expected) << "case " << tried;
    ++tried;
    pierced += expected;
  }
  EXPECT_GT(pierced, 2000);
  EXPECT_LT(pierced, 18000);
}

// Triangles in one plane overlap only if their interiors meet.
TEST(CoplanarTriangles, OverlapOnlyInTheirInteriors)
{
  const Corners3 triangle = { Inexact::Point_3(0, 0, 1), { 4, 0, 1 }, { 0, 4, 1 } };
  EXPECT_TRUE(Overlap(triangle, triangle));
  EXPECT_TRUE(Overlap(triangle, { Inexact::Point_3(1, 1, 1), { 9, 9, 1 }, { 9, 8, 1 } }));
  EXPECT_TRUE(Overlap(triangle, { Inexact::Point_3(1, 1, 1), { 1, 2, 1 }, { 2, 1, 1 } }));
  EXPECT_FALSE(Overlap(triangle, { Inexact::Point_3(0, 0, 1), { 4, 0, 1 }, { 0, -4, 1 } }));
  EXPECT_FALSE(Overlap(triangle, { Inexact::Point_3(2, 2, 1), { 4, 4, 1 }, { 4, 3, 1 } }));
}

// A flipped triangle faces the other way, in every coordinate plane.
TEST(CoplanarTriangles, FaceAlikeUnlessOneIsFlipped)
{
  for (const Corners3& t : { Corners3{ Inexact::Point_3(0, 0, 0), { 1, 0, 0 }, { 0, 1, 0 } },
         Corners3{ Inexact::Point_3(0, 0, 0), { 0, 1, 0 }, { 0, 0, 1 } },
         Corners3{ Inexact::Point_3(0, 0, 0), { 0, 0, 1 }, { 1, 0, 0 } } })
  {
    EXPECT_TRUE(FaceAlike(t, { t[1], t[2], t[0] }));
    EXPECT_FALSE(FaceAlike(t, { t[1], t[0], t[2] }));
  }
}
