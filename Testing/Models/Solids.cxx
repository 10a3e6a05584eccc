// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include "Implicit.h"
#include "PointMath.h"
#include "Shapes.h"

#include <algorithm>

namespace models
{
namespace
{

/** Negative inside tunnel i through the flat scone. The tunnels are spread evenly. */
double SconeTunnel(int i, const Point& p)
{
  const double angle = i * GoldenAngle;
  const double distance = 0.8 * std::sqrt((i + 0.5) / SconeGenus);
  const double radius = 0.065 + 0.07 * ((i * 7) % SconeGenus) / SconeGenus;
  const double x = p[0] - distance * std::cos(angle) - 0.02 * std::sin(9 * p[2] + i);
  const double y = p[1] - distance * std::sin(angle) - 0.02 * std::cos(7 * p[2] + 2 * i);
  return std::hypot(x, y) - radius * (1 + 0.2 * std::sin(9 * p[2] + 3 * i));
}

double SconeSolid(const Point& p)
{
  const double bumps = std::sin(9 * p[0] + 1) * std::sin(8 * p[1] + 2) * std::sin(9 * p[2] + 3);
  const double out = std::hypot(p[0], p[1]), up = p[2] / 0.25;
  double solid = 0.25 * (std::pow(std::pow(out, 4) + std::pow(up, 4), 0.25) - 1) + 0.03 * bumps;
  for (int i = 0; i < SconeGenus; ++i)
  {
    solid = SmoothMax(solid, -SconeTunnel(i, p), 0.06);
  }
  return solid;
}

/** A pair of ribs: an ellipse from the spine at the back down to the sternum at the front. */
struct RibPair
{
  static constexpr int Number = 10;
  static constexpr int Attached = 8;
  static constexpr double Back = -0.3;

  double Height, HalfWidth, HalfDepth;

  explicit RibPair(int i)
  {
    const double t = i / (Number - 1.0);
    this->Height = 0.8 - 1.6 * t;
    this->HalfWidth = 0.2 + 0.32 * std::sin(2.2 * t);
    this->HalfDepth = 0.18 + 0.17 * t;
  }

  Point BackEnd() const
  {
    return { 0, Back, this->Height };
  }

  Point FrontEnd() const
  {
    return { 0, Back + 2 * this->HalfDepth, this->Height - 0.8 * this->HalfDepth };
  }

  double Solid(const Point& p) const
  {
    const double depth = p[1] - Back;
    const double across = std::min(this->HalfWidth, this->HalfDepth) *
      (std::hypot(p[0] / this->HalfWidth, depth / this->HalfDepth - 1) - 1);
    return std::hypot(across, p[2] - this->Height + 0.4 * depth) - 0.044;
  }
};

double RibsSolid(const Point& p)
{
  const double roundness = 0.03;
  const RibPair first(0), lastAttached(RibPair::Attached - 1), last(RibPair::Number - 1);
  const Point neck = first.BackEnd() + Point{ 0, 0, 0.15 };
  const Point tail = last.BackEnd() - Point{ 0, 0, 0.15 };
  double solid = SegmentDistance(p, neck, tail) - 0.06;
  solid = SmoothMin(
    solid, SegmentDistance(p, first.FrontEnd(), lastAttached.FrontEnd()) - 0.05, roundness);
  for (int i = 0; i < RibPair::Number; ++i)
  {
    const RibPair pair(i);
    double ribs = pair.Solid(p);
    if (i >= RibPair::Attached)
    {
      ribs = SmoothMax(ribs, p[1] - RibPair::Back - 0.9 * pair.HalfDepth, roundness);
    }
    const Point thorn = pair.BackEnd() - Point{ 0, 0.14, 0.05 };
    solid = SmoothMin(solid, ribs, roundness);
    solid = SmoothMin(solid, SegmentDistance(p, pair.BackEnd(), thorn) - 0.035, roundness);
  }
  return solid;
}

} // namespace

TriangleMesh TwoSpheres()
{
  return Joined(Sphere(3), Moved(Sphere(3), { 2.5, 0.1, 0.2 }));
}

TriangleMesh EightSpheres()
{
  TriangleMesh all;
  for (int i = 0; i < 8; ++i)
  {
    const Point center = { double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1) };
    all = Joined(all, Moved(Sphere(3), center, 0.3));
  }
  return all;
}

TriangleMesh Scone()
{
  return Isosurface(SconeSolid, { -1.15, -1.15, -0.35 }, { 1.15, 1.15, 0.35 }, { 30, 30, 9 });
}

TriangleMesh Ribs()
{
  return Isosurface(RibsSolid, { -0.62, -0.54, -1.1 }, { 0.62, 0.54, 1.1 }, { 26, 23, 46 });
}

} // namespace models
