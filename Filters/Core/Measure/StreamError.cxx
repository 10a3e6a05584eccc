// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Measure/StreamError.h"

#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Vector.h"
#include "Core/Stream/Faces.h"

#include <algorithm>
#include <queue>

namespace carving
{
namespace
{

/** The factor by which a distance may be too large. */
constexpr double Tolerance = 1.01;

/** The longest side of a piece of a face, which will be halved. */
template <int D>
int LongestSide(const FacetCorners<D>& piece)
{
  int longest = 0;
  for (int i = 1; i < D; ++i)
  {
    if (Length(piece[(i + 1) % D] - piece[i]) > Length(piece[(longest + 1) % D] - piece[longest]))
    {
      longest = i;
    }
  }
  return longest;
}

/**
 * The radius of the smallest ball around a face. No point of the face is farther from the nearest
 * corner.
 */
template <int D>
double BallRadius(const FacetCorners<D>& face)
{
  const int i = LongestSide<D>(face);
  const Point &a = face[i], &b = face[(i + 1) % D], &c = face[(i + 2) % D];
  const double half = Length(b - a) / 2.0;
  const double product = D == 3 ? Dot(a - c, b - c) : 0.0;
  // The circumradius of an acute triangle follows from its longest side and the opposite angle.
  return product <= 0.0 ? half : half * Length(a - c) * Length(b - c) / Length(Cross(a - c, b - c));
}

/** Bounds the distance of a face from M with a limited number of queries. */
template <int D>
class FaceDistance
{
public:
  explicit FaceDistance(const ResolvedInput<D>& mesh)
    : Tree(mesh)
    , Negligible(1e-9 * Diagonal(mesh.Points))
  {
  }

  double OfPoint(const Point& p) const
  {
    return this->Tree.Find(p).Distance;
  }

  struct Bound
  {
    double Upper;
    bool Final; ///< within the tolerance
  };

  /** Refines the bound with at most this many queries for closest facets. */
  Bound Compute(const FacetCorners<D>& face, int queries) const
  {
    std::priority_queue<Piece> pieces;
    double lower = 0.0;
    pieces.push(this->MakePiece(face, lower));
    for (int asked = 1;; asked += 2)
    {
      const Piece top = pieces.top();
      const bool final = top.Upper <= Tolerance * lower || top.Upper <= this->Negligible;
      if (final || asked >= queries)
      {
        return { top.Upper, final };
      }
      pieces.pop();
      const int side = LongestSide<D>(top.Corners), next = (side + 1) % D;
      const Point middle = Between(top.Corners[side], top.Corners[next], 0.5);
      for (const int moved : { side, next })
      {
        FacetCorners<D> half = top.Corners;
        half[moved] = middle;
        pieces.push(this->MakePiece(half, lower));
      }
    }
  }

private:
  struct Piece
  {
    FacetCorners<D> Corners;
    double Upper;

    bool operator<(const Piece& other) const
    {
      return this->Upper < other.Upper;
    }
  };

  Piece MakePiece(const FacetCorners<D>& corners, double& lower) const
  {
    Point center = {};
    for (const Point& corner : corners)
    {
      for (int i = 0; i < 3; ++i)
      {
        center[i] += corner[i] / D;
      }
    }
    const auto closest = this->Tree.Find(center);
    lower = std::max(lower, closest.Distance);
    double upper = 0.0;
    for (const Point& corner : corners)
    {
      upper = std::max(upper, DistanceTo(closest.Facet, corner));
    }
    return { corners, upper };
  }

  const FacetTree<D> Tree;
  const double Negligible; ///< smaller distances are rounding errors of points on M
};

/** What is known of a face's distance. */
struct Candidate
{
  double Upper;
  int Face;
  int Queries; ///< that went into it; -1 if no more can make it better

  bool operator<(const Candidate& other) const
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

  std::priority_queue<Candidate> candidates;
  errors.assign(stream.Order.StepPriority.size(), 0.0);
  std::size_t next = 0;
  for (int step = 0; step < static_cast<int>(errors.size()); ++step)
  {
    if (step % 1024 == 0 && !GoOn(progress, static_cast<double>(step) / errors.size()))
    {
      return false;
    }
    for (; next < faces.size() && faces[next].Birth <= step; ++next)
    {
      candidates.push({ boundBySize(faces[next]), static_cast<int>(next), 0 });
    }
    while (!candidates.empty())
    {
      const Candidate top = candidates.top();
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
