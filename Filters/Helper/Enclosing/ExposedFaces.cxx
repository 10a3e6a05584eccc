// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/ExposedFaces.h"

#include "Core/Mesh/FaceDistance.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Corners = SurfaceDistance::Corners;

double AreaOf(const Corners& t)
{
  return Length(Cross(t[1] - t[0], t[2] - t[0])) / 2.0;
}

/** The distances of a face's samples from M, each with the area that the sample stands for. */
class Samples
{
public:
  Samples(const SurfaceDistance& distance, double spacing)
    : Distance(distance)
    , Spacing(spacing)
  {
  }

  void Add(const Corners& face)
  {
    std::vector<Corners> pieces = { face };
    while (!pieces.empty())
    {
      const Corners piece = pieces.back();
      pieces.pop_back();
      const int longest = LongestSide<3>(piece);
      if (Length(piece[(longest + 1) % 3] - piece[longest]) > this->Spacing)
      {
        const std::vector<Corners> halves = Halve<3>(piece);
        pieces.insert(pieces.end(), halves.begin(), halves.end());
        continue;
      }
      const Point centroid = (piece[0] + piece[1] + piece[2]) / 3.0;
      const double area = AreaOf(piece);
      this->All.emplace_back(this->Distance.Farthest({ centroid, centroid, centroid }, 0.0), area);
      this->Area += area;
    }
  }

  double FindMean() const
  {
    double sum = 0.0;
    for (const auto& [distance, area] : this->All)
    {
      sum += distance * area;
    }
    return this->Area > 0.0 ? sum / this->Area : 0.0;
  }

  /** The least distance that so large a share of the area does not exceed. */
  double FindPercentile(double share)
  {
    std::sort(this->All.begin(), this->All.end());
    double sum = 0.0;
    for (const auto& [distance, area] : this->All)
    {
      sum += area;
      if (sum >= share * this->Area)
      {
        return distance;
      }
    }
    return 0.0;
  }

private:
  const SurfaceDistance& Distance;
  double Spacing;
  double Area = 0.0;
  std::vector<std::pair<double, double>> All;
};

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

bool ReachesTooFar(const PiercedMesh& mesh, const PiercedMesh::Cell& cell,
  const SurfaceDistance& distance, double tolerance)
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

KeptDistances MeasureKept(
  const PiercedMesh& mesh, const SurfaceDistance& distance, double negligible, double length)
{
  constexpr double spacing = 0.01;
  Samples samples(distance, spacing * length);
  double maximum = 0.0;
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    for (int f = 0; f < 4 && cell->info().IsPierced(); ++f)
    {
      if (!IsExposed(mesh, cell, f))
      {
        continue;
      }
      const Corners face = FacePoints(cell, f);
      if (LongestEdge(cell) > maximum)
      {
        maximum = distance.Farthest(face, std::max(maximum, negligible));
      }
      if (cell->info().PartOn(f) < 0)
      {
        samples.Add(face);
      }
    }
  }
  return { maximum, samples.FindPercentile(0.99), samples.FindMean() };
}

} // namespace carving::helper
