// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/ExposedFaces.h"

#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/FaceDistance.h"
#include "Core/Mesh/ForEach.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Corners = SurfaceDistance::Corners;

/**
 * Points on faces. Each stands for the same share of the area of all faces (systematic sampling),
 * so that millions of small faces take no longer than a few large ones.
 */
std::vector<Point> Sample(const std::vector<Corners>& faces, double spacing)
{
  constexpr std::size_t count = 50000;
  double area = 0.0;
  for (const Corners& face : faces)
  {
    area += Size(face);
  }
  const double step = area / count;
  std::vector<Point> samples;
  double next = step / 2.0, passed = 0.0;
  std::vector<Corners> pieces;
  for (const Corners& face : faces)
  {
    pieces.push_back(face);
    while (!pieces.empty())
    {
      const Corners piece = pieces.back();
      pieces.pop_back();
      if (LengthOfLongestSide<3>(piece) > spacing)
      {
        const std::vector<Corners> halves = Halve<3>(piece);
        pieces.insert(pieces.end(), halves.begin(), halves.end());
        continue;
      }
      passed += Size(piece);
      for (; step > 0.0 && next <= passed && samples.size() < count; next += step)
      {
        samples.push_back((piece[0] + piece[1] + piece[2]) / 3.0);
      }
    }
  }
  return samples;
}

/** The least value that is not below this share of the values; 0 without values. */
double FindPercentile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto rank =
    static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())) - 1.0);
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[rank];
}

/** A number that does not depend on the threads, so that the results do not either. */
constexpr int NumberOfRanges = 32;

/** Calls `work(range, first, last, distance)` for ranges of indices below `count`. */
template <class Work>
void ForEachRange(int threads, std::size_t count, const SurfaceDistance& distance, const Work& work)
{
  ForEach(threads, NumberOfRanges,
    [&](std::size_t range)
    {
      SurfaceDistance own = distance;
      work(range, count * range / NumberOfRanges, count * (range + 1) / NumberOfRanges, own);
    });
}

/**
 * Whether a cell is pierced and has an exposed face that is not within `tolerance` of M. Faces that
 * are within it are remembered.
 */
bool ReachesTooFar(
  const PiercedMesh& mesh, const Cell& cell, SurfaceDistance& distance, double tolerance)
{
  CellContacts& info = cell->info();
  for (int f = 0; f < 4 && info.IsPierced(); ++f)
  {
    if (info.Near[f] || !IsExposed(mesh, cell, f))
    {
      continue;
    }
    info.Near[f] =
      LongestEdge(cell) <= tolerance || distance.IsWithin(FacePoints(cell, f), tolerance);
    if (!info.Near[f])
    {
      return true;
    }
  }
  return false;
}

double FindMean(const std::vector<double>& values)
{
  return values.empty()
    ? 0.0
    : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

SurfaceDistance::Corners FacePoints(const PiercedMesh::Cell& cell, int f)
{
  const Corners3 face = FaceOf(cell, f);
  return { ToPoint(face[0]), ToPoint(face[1]), ToPoint(face[2]) };
}

double LongestEdge(const PiercedMesh::Cell& cell)
{
  const Corners4 corners = CornersOf(cell);
  double longest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    for (int k = 0; k < i; ++k)
    {
      longest = std::max(longest, Length(ToPoint(corners[i]) - ToPoint(corners[k])));
    }
  }
  return longest;
}

bool IsExposed(const PiercedMesh& mesh, const PiercedMesh::Cell& cell, int f)
{
  const Cell other = cell->neighbor(f);
  return mesh.GetDelaunay().is_infinite(other) || !other->info().IsPierced();
}

std::vector<Cell> FindFar(const PiercedMesh& mesh, const std::vector<Cell>& cells,
  const SurfaceDistance& distance, double tolerance, int threads)
{
  std::vector<char> isFar(cells.size());
  ForEachRange(threads, cells.size(), distance,
    [&](std::size_t, std::size_t first, std::size_t last, SurfaceDistance& own)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        isFar[i] = ReachesTooFar(mesh, cells[i], own, tolerance);
      }
    });
  std::vector<Cell> far;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (isFar[i])
    {
      far.push_back(cells[i]);
    }
  }
  return far;
}

KeptDistances MeasureKept(const PiercedMesh& mesh, const SurfaceDistance& distance,
  double negligible, double length, int threads)
{
  constexpr double spacing = 0.01;
  std::vector<Corners> faces, bare; // all that are exposed, and those on which no part of M lies
  std::vector<double> lengths;      // of the longest edges of the tetrahedra, per face
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    for (int f = 0; f < 4 && cell->info().IsPierced(); ++f)
    {
      if (!IsExposed(mesh, cell, f))
      {
        continue;
      }
      faces.push_back(FacePoints(cell, f));
      lengths.push_back(LongestEdge(cell));
      if (cell->info().PartOn(f) < 0)
      {
        bare.push_back(faces.back());
      }
    }
  }
  const std::vector<Point> points =
    Sample(bare, std::max(spacing * length, distance.GetResolution()));
  std::vector<double> samples(points.size());
  ForEachRange(threads, points.size(), distance,
    [&](std::size_t, std::size_t first, std::size_t last, SurfaceDistance& own)
    {
      std::transform(points.begin() + first, points.begin() + last, samples.begin() + first,
        [&own](const Point& point) { return own.Distance(point); });
    });
  const double sampled = samples.empty() ? 0.0 : *std::max_element(samples.begin(), samples.end());
  std::vector<double> maxima(NumberOfRanges, sampled);
  ForEachRange(threads, faces.size(), distance,
    [&](std::size_t range, std::size_t first, std::size_t last, SurfaceDistance& own)
    {
      double& maximum = maxima[range];
      for (std::size_t i = first; i < last; ++i)
      {
        if (lengths[i] > maximum)
        {
          maximum = own.Farthest(faces[i], std::max(maximum, negligible));
        }
      }
    });
  return { *std::max_element(maxima.begin(), maxima.end()), FindPercentile(samples, 0.99),
    FindMean(samples) };
}

} // namespace carving::helper
