// SPDX-License-Identifier: BSD-3-Clause
#include "Contours.h"

#include "PointMath.h"

namespace models
{
namespace
{

using Polygon = std::vector<Point>;

void AddLoop(ContourModel& model, const Polygon& loop)
{
  const int start = static_cast<int>(model.Points.size());
  const int size = static_cast<int>(loop.size());
  model.Points.insert(model.Points.end(), loop.begin(), loop.end());
  for (int i = 0; i < size; ++i)
  {
    model.Edges.push_back({ start + i, start + (i + 1) % size });
  }
}

Point LeftOf(const Point& direction)
{
  return { -direction[1], direction[0], 0 };
}

/** A point on an arc between two points, whose middle is `height` to the left of their segment. */
Point OnArc(const Point& from, const Point& to, double height, double t)
{
  return from + t * (to - from) + 4 * t * (1 - t) * height * LeftOf(Normalized(to - from));
}

/**
 * Adds a side of the block with finely sampled dents. The side bulges, so that all dents begin on
 * the hull.
 */
void AddSide(Polygon& polygon, const Point& from, const Point& to, int dents)
{
  const int parts = 8;
  polygon.push_back(from);
  for (int dent = 0; dent < dents; ++dent)
  {
    const Point begin = OnArc(from, to, -0.15, (dent + 0.2) / dents);
    const Point end = OnArc(from, to, -0.15, (dent + 0.8) / dents);
    for (int i = 0; i <= parts; ++i)
    {
      polygon.push_back(OnArc(begin, end, 0.4, static_cast<double>(i) / parts));
    }
  }
  polygon.push_back(to);
}

/**
 * Adds a channel around a path: along its left bank to the end of the path, and back along its
 * right bank.
 */
void AddChannel(Polygon& polygon, const Polygon& path, double halfWidth)
{
  Polygon rightBank;
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    // Where the path turns, the banks are offset along the bisector.
    const Point before = i > 0 ? Normalized(path[i] - path[i - 1]) : Point{};
    const Point after = i + 1 < path.size() ? Normalized(path[i + 1] - path[i]) : Point{};
    const Point between = Normalized(before + after);
    const double widening = carving::Dot(between, i > 0 ? before : after);
    const Point offset = halfWidth / widening * LeftOf(between);
    polygon.push_back(path[i] + offset);
    rightBank.push_back(path[i] - offset);
  }
  polygon.insert(polygon.end(), rightBank.rbegin(), rightBank.rend());
}

/** Samples of the closed Catmull-Rom spline through points. */
Polygon Smoothed(const Polygon& controls)
{
  const int parts = 5;
  const std::size_t n = controls.size();
  Polygon curve;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point &a = controls[(i + n - 1) % n], &b = controls[i], &c = controls[(i + 1) % n],
                &d = controls[(i + 2) % n];
    for (int part = 0; part < parts; ++part)
    {
      const double t = static_cast<double>(part) / parts;
      curve.push_back(b + 0.5 * t * (c - a) + t * t * (a - 2.5 * b + 2.0 * c - 0.5 * d) +
        0.5 * t * t * t * (3.0 * (b - c) + d - a));
    }
  }
  return curve;
}

} // namespace

ContourModel SnakingContour()
{
  Polygon outline;
  AddSide(outline, { 0, 0, 0 }, { 10.9, 0.1, 0 }, 7);
  AddSide(outline, { 11, 0.2, 0 }, { 11.1, 7.9, 0 }, 5);
  AddSide(outline, { 11, 8, 0 }, { 7, 8.2, 0 }, 3);
  AddChannel(outline,
    { { 6.3, 8.3, 0 }, { 6, 6.3, 0 }, { 2.2, 6, 0 }, { 2, 4.7, 0 }, { 9.4, 5.1, 0 },
      { 9.5, 3.6, 0 }, { 2.3, 3.2, 0 }, { 2.4, 1.7, 0 }, { 9.3, 1.9, 0 } },
    0.3);
  AddSide(outline, { 5.5, 8.2, 0 }, { 1.5, 8.1, 0 }, 3);
  outline.push_back({ 1, 0.9, 0 }); // the spike's end
  outline.push_back({ 0.9, 8, 0 });
  AddSide(outline, { 0, 7.9, 0 }, { -0.1, 0.1, 0 }, 5);
  ContourModel model;
  AddLoop(model, outline);
  return model;
}

ContourModel CarvedFigure()
{
  const Polygon outline = { { -1.2, -3.3, 0 }, { 0, -3.4, 0 }, { 1.3, -3.3, 0 }, { 0.8, -2.6, 0 },
    { 1.7, -1.7, 0 }, { 2.2, -0.5, 0 }, { 2.4, 0.2, 0 }, { 3.4, 1.0, 0 }, { 3.7, 2.1, 0 },
    { 3.0, 3.0, 0 }, { 1.9, 3.1, 0 }, { 1.3, 3.6, 0 }, { 0.2, 3.3, 0 }, { -1.2, 3.5, 0 },
    { -2.1, 3.9, 0 }, { -1.3, 2.9, 0 }, { -0.9, 2.0, 0 }, { -1.5, 1.2, 0 }, { -2.2, 0.1, 0 },
    { -2.2, -1.1, 0 }, { -1.6, -2.0, 0 }, { -0.8, -2.7, 0 } };
  const Polygon hole = { { 1.3, 2.2, 0 }, { 2.0, 2.5, 0 }, { 2.8, 2.4, 0 }, { 3.1, 1.9, 0 },
    { 2.8, 1.3, 0 }, { 2.1, 0.9, 0 }, { 1.6, 1.3, 0 } };
  ContourModel model;
  AddLoop(model, Smoothed(outline));
  AddLoop(model, Smoothed(hole));
  return model;
}

} // namespace models
