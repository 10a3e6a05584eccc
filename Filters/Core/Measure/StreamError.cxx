// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Measure/StreamError.h"

#include "Core/Mesh/FaceDistance.h"
#include "Core/Stream/Faces.h"

#include <algorithm>
#include <queue>

namespace carving
{
namespace
{

/** What is known of a face's distance. */
struct FaceBound
{
  double Upper;
  int Face;
  int Queries; ///< that went into it; -1 if no more can make it better

  bool operator<(const FaceBound& other) const
  {
    return this->Upper < other.Upper;
  }
};

/** The faces that may be away from M, by birth, with bounds on their distance by their size. */
template <int D>
std::vector<FaceLife<D>> CollectFaces(const StoredStream<D>& stream, bool conforming)
{
  std::vector<FaceLife<D>> faces;
  ForEachFace(stream,
    [&](const FaceLife<D>& face)
    {
      if (face.Constraint < 0 || !conforming)
      {
        faces.push_back(face);
      }
    });
  std::stable_sort(faces.begin(), faces.end(),
    [](const FaceLife<D>& a, const FaceLife<D>& b) { return a.Birth < b.Birth; });
  return faces;
}

} // namespace

template <int D>
bool ComputeErrors(const StoredStream<D>& stream, const ResolvedInput<D>& mesh, bool conforming,
  std::vector<double>& errors, const Progress& progress)
{
  const std::vector<Point>& points = stream.Mesh.Surface.Points;
  const std::vector<FaceLife<D>> faces = CollectFaces(stream, conforming);
  const FaceDistance<D> faceDistance(mesh);
  std::vector<double> vertexDistances(points.size(), -1.0);
  const auto boundBySize = [&](const FaceLife<D>& face)
  {
    double farthest = 0.0;
    for (const int vertex : face.Corners)
    {
      double& distance = vertexDistances[vertex];
      if (distance < 0.0)
      {
        distance = faceDistance.OfPoint(points[vertex]);
      }
      farthest = std::max(farthest, distance);
    }
    return farthest + BallRadius<D>(CornersOf<D>(points, face.Corners));
  };

  constexpr int mostWork = 1024; // between two calls of `progress`
  int work = 0;
  const auto goOn = [&](int step)
  {
    if (work < mostWork)
    {
      return true;
    }
    work = 0;
    return GoOn(progress, static_cast<double>(step) / errors.size());
  };
  std::priority_queue<FaceBound> candidates;
  errors.assign(stream.Order.StepPriority.size(), 0.0);
  std::size_t next = 0;
  for (int step = 0; step < static_cast<int>(errors.size()); ++step)
  {
    ++work;
    for (; next < faces.size() && faces[next].Birth <= step; ++next)
    {
      candidates.push({ boundBySize(faces[next]), static_cast<int>(next), 0 });
    }
    while (!candidates.empty())
    {
      if (!goOn(step))
      {
        return false;
      }
      const FaceBound top = candidates.top();
      const FaceLife<D>& face = faces[top.Face];
      if (face.Death > step && top.Queries < 0)
      {
        errors[step] = top.Upper;
        break;
      }
      candidates.pop();
      if (face.Death > step)
      {
        // The number of queries grows, so that faces which are not the farthest take few.
        const int queries = top.Queries == 0 ? 1 : 4 * top.Queries;
        work += queries;
        const auto bound = faceDistance.Compute(CornersOf<D>(points, face.Corners), queries);
        candidates.push({ std::min(top.Upper, bound.Upper), top.Face, bound.Final ? -1 : queries });
      }
    }
  }
  return GoOn(progress, 1.0);
}

template bool ComputeErrors<2>(
  const StoredStream<2>&, const ResolvedInput<2>&, bool, std::vector<double>&, const Progress&);
template bool ComputeErrors<3>(
  const StoredStream<3>&, const ResolvedInput<3>&, bool, std::vector<double>&, const Progress&);

} // namespace carving
