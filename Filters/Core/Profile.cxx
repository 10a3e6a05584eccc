// SPDX-License-Identifier: BSD-3-Clause
#include "Profile.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace carving
{
namespace
{

/** One more during [birth, death), as differences that a prefix sum turns into counts. */
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

} // namespace

template <int D>
Profile ComputeProfile(const StoredStream<D>& stream)
{
  Profile profile;
  profile.Vertices.assign(stream.Order.StepPriority.size(), 0);
  profile.Triangles.assign(stream.Order.StepPriority.size(), 0);
  // A vertex shows on C_j while some face around it does.
  const std::size_t numberOfPoints = stream.Mesh.Surface.Points.size();
  std::vector<int> birth(numberOfPoints, Stream::Never);
  std::vector<int> death(numberOfPoints, 0);
  ForEachFace(stream,
    [&](const FaceLife<D>& face)
    {
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
  SetPriorities<D>(profile, stream.Order.StepPriority, stream.Measure);
  return profile;
}

template <int D>
void SetPriorities(
  Profile& profile, const std::vector<double>& stepPriorities, PriorityMeasure measure)
{
  profile.Priority = stepPriorities;
  profile.FeatureSize.clear();
  double smallest = std::numeric_limits<double>::infinity();
  for (const double priority : stepPriorities)
  {
    // The priority of step 0 is NaN, which fmin passes over.
    smallest = std::fmin(smallest, PriorityAsLength<D>(priority, measure));
    profile.FeatureSize.push_back(smallest);
  }
}

template void SetPriorities<2>(Profile&, const std::vector<double>&, PriorityMeasure);
template void SetPriorities<3>(Profile&, const std::vector<double>&, PriorityMeasure);

template Profile ComputeProfile<2>(const StoredStream<2>&);
template Profile ComputeProfile<3>(const StoredStream<3>&);

} // namespace carving
