// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Measure/Profile.h"

#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/LargePages.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace carving
{
namespace
{

/** Counts one more in [birth, death). A prefix sum turns the differences into counts. */
void Count(std::vector<int>& differences, int birth, int death)
{
  if (birth < death)
  {
    ++differences[birth];
    if (death != Stream::Never)
    {
      --differences[death];
    }
  }
}

/**
 * The volume that oriented triangles bound, by the divergence theorem, or the area that oriented
 * edges bound: half the length of the sum of their moments. An origin near the faces keeps rounding
 * errors small.
 */
class BoundedVolume
{
public:
  explicit BoundedVolume(const Point& origin)
    : Origin(origin)
  {
  }

  void Add(const std::vector<Point>& points, const Triangle& face)
  {
    this->SixVolumes += SixVolume(this->Origin, points[face[0]], points[face[1]], points[face[2]]);
  }
  void Add(const std::vector<Point>& points, const std::array<int, 2>& edge)
  {
    this->Moments =
      this->Moments + Cross(points[edge[0]] - this->Origin, points[edge[1]] - this->Origin);
  }

  double Get() const
  {
    return std::max(0.0, this->SixVolumes / 6.0) + Length(this->Moments) / 2.0;
  }

private:
  Point Origin;
  double SixVolumes = 0.0;
  Point Moments = {};
};

/**
 * Sets the volumes from the final one, `left`, and from the volumes of the cells that each step
 * removes.
 */
template <int D>
void SetVolumes(Profile& profile, const StoredStream<D>& stream, double left)
{
  profile.Volume = MakeLarge<double>(stream.Order.StepPriority.size());
  for (std::size_t cell = 0; cell < stream.Mesh.Cells.size(); ++cell)
  {
    const int step = stream.Order.Step[cell];
    if (step != Stream::Never)
    {
      profile.Volume[step - 1] += Size(CornersOfCell(stream.Mesh, static_cast<int>(cell)));
    }
  }
  for (auto volume = profile.Volume.rbegin(); volume != profile.Volume.rend(); ++volume)
  {
    left = *volume += left;
  }
}

} // namespace

template <int D>
Profile ComputeProfile(const StoredStream<D>& stream)
{
  Profile profile;
  profile.Vertices = MakeLarge<int>(stream.Order.StepPriority.size());
  profile.Triangles = MakeLarge<int>(stream.Order.StepPriority.size());
  // A vertex is part of C_j if some face around it is.
  const std::size_t numberOfPoints = stream.Mesh.Surface.Points.size();
  std::vector<int> birth = MakeLarge<int>(numberOfPoints, Stream::Never);
  std::vector<int> death = MakeLarge<int>(numberOfPoints);
  BoundedVolume left(stream.Mesh.Surface.Points.front());
  ForEachFace(stream,
    [&](const FaceLife<D>& face)
    {
      if (face.Death == Stream::Never && !face.Fold)
      {
        left.Add(stream.Mesh.Surface.Points, face.Corners);
      }
      Count(profile.Triangles, face.Birth, face.Death);
      for (const int vertex : face.Corners)
      {
        birth[vertex] = std::min(birth[vertex], face.Birth);
        death[vertex] = std::max(death[vertex], face.Death);
      }
    });
  for (std::size_t vertex = 0; vertex < numberOfPoints; ++vertex)
  {
    Count(profile.Vertices, birth[vertex], death[vertex]);
  }
  for (std::vector<int>* counts : { &profile.Vertices, &profile.Triangles })
  {
    std::partial_sum(counts->begin(), counts->end(), counts->begin());
  }
  SetVolumes(profile, stream, left.Get());
  SetPriorities<D>(profile, stream.Order.StepPriority, stream.Measure);
  return profile;
}

template <int D>
void SetPriorities(
  Profile& profile, const std::vector<double>& stepPriorities, PriorityMeasure measure)
{
  profile.Priority = stepPriorities;
  profile.FeatureSize.clear();
  ReserveLarge(profile.FeatureSize, stepPriorities.size());
  double smallest = std::numeric_limits<double>::infinity();
  for (const double priority : stepPriorities)
  {
    // fmin ignores the priority of step 0, which is NaN.
    smallest = std::fmin(smallest, PriorityAsLength<D>(priority, measure));
    profile.FeatureSize.push_back(smallest);
  }
}

template void SetPriorities<2>(Profile&, const std::vector<double>&, PriorityMeasure);
template void SetPriorities<3>(Profile&, const std::vector<double>&, PriorityMeasure);

template Profile ComputeProfile<2>(const StoredStream<2>&);
template Profile ComputeProfile<3>(const StoredStream<3>&);

} // namespace carving
