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

/** The farthest of the faces that are alive, whose distances are refined only as far as need be. */
template <int D>
class FarthestFace
{
public:
  FarthestFace(const StoredStream<D>& stream, const ResolvedInput<D>& mesh, bool conforming)
    : Points(stream.Mesh.Surface.Points)
    , Faces(CollectFaces(stream, conforming))
    , Distance(mesh)
    , VertexDistances(Points.size(), -1.0)
  {
  }

  /** Adds the faces of a step. The steps ascend. */
  void AddFaces(int step)
  {
    for (; this->Next < this->Faces.size() && this->Faces[this->Next].Birth <= step; ++this->Next)
    {
      this->Candidates.push(
        { this->BoundBySize(this->Faces[this->Next]), static_cast<int>(this->Next), 0 });
    }
  }

  /**
   * Takes one step towards the distance of the farthest face. Returns whether it is known: then
   * `distance` is set, to 0 if there is no face. `work` grows by the number of queries.
   */
  bool Refine(int step, int& work, double& distance)
  {
    if (this->Candidates.empty())
    {
      distance = 0.0;
      return true;
    }
    const FaceBound top = this->Candidates.top();
    const FaceLife<D>& face = this->Faces[top.Face];
    const bool isAlive = face.Death > step;
    if (isAlive && top.Queries < 0)
    {
      distance = top.Upper;
      return true;
    }
    this->Candidates.pop();
    if (isAlive)
    {
      // The number of queries grows, so that faces which are not the farthest take few.
      const int queries = top.Queries == 0 ? 1 : std::min(4 * top.Queries, MostDistanceQueries);
      const bool isLast = queries >= MostDistanceQueries;
      work += queries;
      const auto bound = this->Distance.Compute(CornersOf<D>(this->Points, face.Corners), queries);
      this->Candidates.push(
        { std::min(top.Upper, bound.Upper), top.Face, bound.Final || isLast ? -1 : queries });
    }
    return false;
  }

private:
  double BoundBySize(const FaceLife<D>& face)
  {
    double farthest = 0.0;
    for (const int vertex : face.Corners)
    {
      double& distance = this->VertexDistances[vertex];
      if (distance < 0.0)
      {
        distance = this->Distance.OfPoint(this->Points[vertex]);
      }
      farthest = std::max(farthest, distance);
    }
    return farthest + BallRadius<D>(CornersOf<D>(this->Points, face.Corners));
  }

  const std::vector<Point>& Points;
  const std::vector<FaceLife<D>> Faces;
  const FaceDistance<D> Distance;
  std::vector<double> VertexDistances; ///< or -1
  std::priority_queue<FaceBound> Candidates;
  std::size_t Next = 0;
};

} // namespace

template <int D>
bool ComputeErrors(const StoredStream<D>& stream, const ResolvedInput<D>& mesh, bool conforming,
  std::vector<double>& errors, const Progress& progress)
{
  FarthestFace<D> farthest(stream, mesh, conforming);
  errors.assign(stream.Order.StepPriority.size(), 0.0);
  constexpr int mostWork = 1024; // between two calls of `progress`
  int work = 0;
  for (int step = 0; step < static_cast<int>(errors.size()); ++step)
  {
    ++work;
    farthest.AddFaces(step);
    bool isKnown = false;
    while (!isKnown)
    {
      if (work >= mostWork)
      {
        work = 0;
        if (!GoOn(progress, static_cast<double>(step) / errors.size()))
        {
          return false;
        }
      }
      isKnown = farthest.Refine(step, work, errors[step]);
    }
  }
  return GoOn(progress, 1.0);
}

template bool ComputeErrors<2>(
  const StoredStream<2>&, const ResolvedInput<2>&, bool, std::vector<double>&, const Progress&);
template bool ComputeErrors<3>(
  const StoredStream<3>&, const ResolvedInput<3>&, bool, std::vector<double>&, const Progress&);

} // namespace carving
