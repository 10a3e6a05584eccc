// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include "PointMath.h"
#include "Spindle.h"

namespace models
{
namespace
{

/** Adds leaf i of n: the lowest leaf is nearly horizontal, the uppermost nearly upright. */
void AddLeaf(TriangleMesh& mesh, int i, int n)
{
  const int rows = 6, columns = 5;
  const double age = 1.0 - (i + 0.5) / n;
  const double azimuth = i * GoldenAngle;
  const double elevation = (0.06 + 0.4 * (1.0 - age)) * Pi;
  const double length = 1.0 + 0.25 * std::sin(5.0 * i);
  const double droop = 0.3 * age + 0.08 * std::sin(3.0 * i);
  const Point out = { std::cos(azimuth), std::sin(azimuth), 0 };
  const Point side = { -out[1], out[0], 0 };
  const Point up = { 0, 0, 1 };
  const Point base = (0.02 + 0.03 * age) * out + 0.15 * (1.0 - age) * up;

  const auto spine = [&](double t)
  {
    return base + length * t * std::cos(elevation) * out +
      (length * t * std::sin(elevation) - droop * t * t) * up;
  };
  std::vector<std::vector<Point>> points(rows);
  for (int row = 0; row < rows; ++row)
  {
    const double t = (row + 1.0) / (rows + 1.0);
    const double halfWidth = 0.04 * std::sqrt(t) * (1.0 - t) / 0.385;
    const Point along = Normalized(spine(t + 0.01) - spine(t - 0.01));
    const Point above = carving::Cross(along, side);
    for (int column = 0; column < columns; ++column)
    {
      // A leaf is curved across, so that it is not flat.
      const double s = 2.0 * column / (columns - 1) - 1.0;
      points[row].push_back(spine(t) + s * halfWidth * side + 0.6 * s * s * halfWidth * above);
    }
  }
  AddSpindle(mesh, spine(0), points, spine(1), false);
}

} // namespace

TriangleMesh YuccaLeaves()
{
  const int leaves = 25;
  TriangleMesh mesh;
  for (int i = 0; i < leaves; ++i)
  {
    AddLeaf(mesh, i, leaves);
  }
  return mesh;
}

} // namespace models
