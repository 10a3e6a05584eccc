// SPDX-License-Identifier: BSD-3-Clause
#include "Manifold.h"

#include "DisjointSets.h"
#include "FacePairs.h"

#include <algorithm>
#include <utility>

namespace carving
{
namespace
{

/** Corner k of face i as the number D * i + k, like the side opposite to it. */
template <int D>
class Cutter
{
public:
  Cutter(const StoredStream<D>& stream, const Level<D>& level)
    : Shown(level)
    , Pairs(PairFaces(stream, level))
    , Fans(this->JoinCorners())
  {
  }

  ManifoldLevel<D> Cut()
  {
    // Separating only ever splits fans, so that what is separate stays so.
    for (const std::vector<int>& group : this->Pairs.Crowded)
    {
      while (this->SeparateCollision(group))
      {
        this->FansAreWhole = false;
      }
    }
    return this->Number();
  }

private:
  /** Corner sets by the pairs there are. */
  DisjointSets JoinCorners() const
  {
    DisjointSets sets(this->Pairs.Partner.size());
    for (int side = 0; side < static_cast<int>(this->Pairs.Partner.size()); ++side)
    {
      const int partner = this->Pairs.Partner[side];
      if (partner <= side)
      {
        continue;
      }
      for (int k = 1; k < D; ++k)
      {
        const int corner = side / D * D + (side % D + k) % D;
        const int vertex = FaceAt<D>(this->Shown, corner).Corners[corner % D];
        sets.Unite(corner, this->CornerAt(partner, vertex));
      }
    }
    return sets;
  }

  int CornerAt(int side, int vertex) const
  {
    const std::array<int, D>& corners = FaceAt<D>(this->Shown, side).Corners;
    const auto found = std::find(corners.begin(), corners.end(), vertex);
    return side / D * D + static_cast<int>(found - corners.begin());
  }

  /** Changes pairs if two pairs, or loose faces, of a ridge have the same vertices. */
  bool SeparateCollision(const std::vector<int>& group)
  {
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if (this->Pairs.Partner[group[i]] != group[j] && this->HaveSameVertices(group[i], group[j]))
        {
          this->Separate(group[i], group[j]);
          return true;
        }
      }
    }
    return false;
  }

  bool HaveSameVertices(int a, int b)
  {
    const std::array<int, D - 1> ridge = RidgeAt<D>(this->Shown, a);
    // A fan can be long: it is walked only where there is one that may still be whole.
    return std::all_of(ridge.begin(), ridge.end(),
             [&](int vertex)
             {
               return this->Fans.Find(this->CornerAt(a, vertex)) ==
                 this->Fans.Find(this->CornerAt(b, vertex));
             }) &&
      std::all_of(
        ridge.begin(), ridge.end(), [&](int vertex) { return this->AreInOneFan(a, b, vertex); });
  }

  /** Walks around the vertex, over joined sides, from the face of one side toward that of another. */
  bool AreInOneFan(int a, int b, int vertex) const
  {
    const int start = this->CornerAt(a, vertex);
    const int target = this->CornerAt(b, vertex);
    for (int k = 1; k < D; ++k)
    {
      int corner = start;
      int side = start / D * D + (start % D + k) % D;
      for (;;)
      {
        side = this->Pairs.Partner[side];
        if (side < 0)
        {
          break; // a boundary: try the other way round
        }
        corner = this->CornerAt(side, vertex);
        if (corner == target || corner == start)
        {
          return corner == target;
        }
        if (D == 2)
        {
          break;
        }
        side = corner / D * D + (D - corner % D - side % D); // the third of 0, 1, 2
      }
    }
    return false;
  }

  void Separate(int a, int b)
  {
    const int partnerOfA = this->Pairs.Partner[a], partnerOfB = this->Pairs.Partner[b];
    if (partnerOfA >= 0 && partnerOfB >= 0)
    {
      // One fan passes the ridge twice; crossed over, it becomes two.
      const bool opposite = IsForward<D>(this->Shown, a) != IsForward<D>(this->Shown, b);
      this->Pairs.Join(a, opposite ? b : partnerOfB);
      this->Pairs.Join(partnerOfA, opposite ? partnerOfB : b);
      return;
    }
    this->Isolate(partnerOfA < 0 ? a : b);
  }

  /** Cuts a face off on all sides. */
  void Isolate(int side)
  {
    for (int k = 0; k < D; ++k)
    {
      int& partner = this->Pairs.Partner[side / D * D + k];
      if (partner >= 0)
      {
        this->Pairs.Partner[partner] = -1;
        partner = -1;
      }
    }
  }

  ManifoldLevel<D> Number()
  {
    DisjointSets sets = this->FansAreWhole ? std::move(this->Fans) : this->JoinCorners();
    const int numberOfCorners = static_cast<int>(this->Pairs.Partner.size());
    std::vector<int> firsts; // one corner for each vertex
    for (int corner = 0; corner < numberOfCorners; ++corner)
    {
      if (sets.Find(corner) == corner)
      {
        firsts.push_back(corner);
      }
    }
    const auto pointOf = [&](int corner)
    { return FaceAt<D>(this->Shown, corner).Corners[corner % D]; };
    std::stable_sort(
      firsts.begin(), firsts.end(), [&](int a, int b) { return pointOf(a) < pointOf(b); });
    ManifoldLevel<D> result;
    std::vector<int> vertexOfFirst(numberOfCorners, -1);
    for (const int first : firsts)
    {
      vertexOfFirst[first] = static_cast<int>(result.Points.size());
      result.Points.push_back(pointOf(first));
    }
    result.Faces.resize(this->Shown.Faces.size());
    for (int corner = 0; corner < numberOfCorners; ++corner)
    {
      result.Faces[corner / D][corner % D] = vertexOfFirst[sets.Find(corner)];
    }
    return result;
  }

  const Level<D>& Shown;
  FacePairs Pairs;
  DisjointSets Fans; ///< corners that had the same vertex before anything was separated
  bool FansAreWhole = true;
};

} // namespace

template <int D>
ManifoldLevel<D> CutIntoManifold(const StoredStream<D>& stream, const Level<D>& level)
{
  return Cutter<D>(stream, level).Cut();
}

template <int D>
ManifoldLevel<D> KeepUncut(const Level<D>& level)
{
  ManifoldLevel<D> result;
  for (const FaceLife<D>& face : level.Faces)
  {
    result.Points.insert(result.Points.end(), face.Corners.begin(), face.Corners.end());
    result.Faces.push_back(face.Corners);
  }
  std::sort(result.Points.begin(), result.Points.end());
  result.Points.erase(std::unique(result.Points.begin(), result.Points.end()), result.Points.end());
  for (std::array<int, D>& face : result.Faces)
  {
    for (int& corner : face)
    {
      corner =
        static_cast<int>(std::lower_bound(result.Points.begin(), result.Points.end(), corner) -
          result.Points.begin());
    }
  }
  return result;
}

template ManifoldLevel<2> CutIntoManifold<2>(const StoredStream<2>&, const Level<2>&);
template ManifoldLevel<3> CutIntoManifold<3>(const StoredStream<3>&, const Level<3>&);
template ManifoldLevel<2> KeepUncut<2>(const Level<2>&);
template ManifoldLevel<3> KeepUncut<3>(const Level<3>&);

} // namespace carving
