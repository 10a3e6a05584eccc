// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/FlushFrame.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace carving::helper
{
namespace
{

/** The area of parallel triangles, and their normal. */
struct Facing
{
  Point Normal; ///< of length 1
  double Area;
};

/** The sine of an angle far above those that rounding makes, and far below those that are meant. */
constexpr double Parallel = 1e-9;

/** Parallel faces with less than this share of the area are not worth an attempt. */
constexpr double LeastShare = 0.05;

/** The normals and areas of all triangles. Of two opposite normals, one is turned over. */
std::vector<Facing> FindFacings(const ResolvedMesh& mesh)
{
  std::vector<Facing> facings;
  for (const auto& [a, b, c] : mesh.Facets)
  {
    const Point& p = mesh.Points[a];
    const Point normal = Cross(mesh.Points[b] - p, mesh.Points[c] - p);
    const double length = Length(normal);
    if (length > 0.0)
    {
      const auto first = std::find_if(
        normal.begin(), normal.end(), [&](double x) { return std::abs(x) > Parallel * length; });
      facings.push_back({ normal / (*first < 0.0 ? -length : length), length / 2.0 });
    }
  }
  return facings;
}

/** The mean normal and the greatest area of parallel triangles perpendicular to `axis`, if any. */
std::optional<Facing> FindLargest(std::vector<Facing> facings, const Point& axis)
{
  facings.erase(std::remove_if(facings.begin(), facings.end(),
                  [&](const Facing& f) { return std::abs(Dot(f.Normal, axis)) > Parallel; }),
    facings.end());
  constexpr double cellSize = 8.0 * Parallel; // so that few cells divide parallel normals
  const auto cell = [](double x) { return std::llround(x / cellSize); };
  std::sort(facings.begin(), facings.end(),
    [&](const Facing& a, const Facing& b)
    {
      for (int i = 0; i < 3; ++i)
      {
        if (cell(a.Normal[i]) != cell(b.Normal[i]))
        {
          return cell(a.Normal[i]) < cell(b.Normal[i]);
        }
      }
      return false;
    });
  std::optional<Facing> largest;
  for (auto begin = facings.begin(), end = begin; begin != facings.end(); begin = end)
  {
    Point sum = {};
    double area = 0.0;
    for (; end != facings.end() && Length(end->Normal - begin->Normal) <= 2.0 * cellSize; ++end)
    {
      sum = sum + end->Area * end->Normal;
      area += end->Area;
    }
    if (!largest || area > largest->Area)
    {
      largest = Facing{ sum / Length(sum), area };
    }
  }
  return largest;
}

bool IsCoordinateAxis(const Point& axis)
{
  return std::count_if(axis.begin(), axis.end(), [](double x) { return std::abs(x) > Parallel; }) ==
    1;
}

} // namespace

std::optional<FlushFrame> FlushFrame::Find(const ResolvedMesh& mesh)
{
  const std::vector<Facing> facings = FindFacings(mesh);
  const double all = std::accumulate(facings.begin(), facings.end(), 0.0,
    [](double area, const Facing& facing) { return area + facing.Area; });
  const std::optional<Facing> largest = FindLargest(facings, {});
  if (!largest || largest->Area < LeastShare * all)
  {
    return std::nullopt;
  }
  const Point third = largest->Normal;
  Point across;
  if (const std::optional<Facing> next = FindLargest(facings, third))
  {
    across = next->Normal;
  }
  else
  {
    const auto least = std::min_element(
      third.begin(), third.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    across = {};
    across[least - third.begin()] = 1.0;
  }
  const Point normal = Cross(third, across);
  const Point second = normal / Length(normal);
  const std::array<Point, 3> axes = { Cross(second, third), second, third };
  if (std::all_of(axes.begin(), axes.end(), IsCoordinateAxis))
  {
    return std::nullopt;
  }
  return FlushFrame(axes);
}

Point FlushFrame::ToFrame(const Point& p) const
{
  return { Dot(this->Axes[0], p), Dot(this->Axes[1], p), Dot(this->Axes[2], p) };
}

Point FlushFrame::FromFrame(const Point& p) const
{
  return p[0] * this->Axes[0] + p[1] * this->Axes[1] + p[2] * this->Axes[2];
}

} // namespace carving::helper
