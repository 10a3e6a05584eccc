// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/Manifold.h"

#include "Core/Mesh/DisjointSets.h"
#include "Core/Surface/FacePairs.h"

#include <algorithm>
#include <map>
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
  {
  }

  ManifoldLevel<D> Cut()
  {
    this->FindFans();
    // Separating only ever splits fans, so that what is separate stays so.
    for (const std::vector<int>& group : this->Pairs.Crowded)
    {
      while (this->SeparateCollisions(group))
      {
      }
    }
    return this->Number();
  }

private:
  /** The fans that the pairs make of corners. */
  void FindFans()
  {
    const int numberOfCorners = static_cast<int>(this->Pairs.Partner.size());
    DisjointSets sets(numberOfCorners);
    for (int side = 0; side < numberOfCorners; ++side)
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
    this->FanOfCorner.resize(numberOfCorners);
    for (int corner = 0; corner < numberOfCorners; ++corner)
    {
      this->FanOfCorner[corner] = sets.Find(corner);
    }
    this->NumberOfFans = numberOfCorners;
  }

  int CornerAt(int side, int vertex) const
  {
    const std::array<int, D>& corners = FaceAt<D>(this->Shown, side).Corners;
    const auto found = std::find(corners.begin(), corners.end(), vertex);
    return side / D * D + static_cast<int>(found - corners.begin());
  }

  /** The fans that have the ends of a side's ridge. */
  std::array<int, D - 1> FansAt(int side) const
  {
    const std::array<int, D - 1> ridge = RidgeAt<D>(this->Shown, side);
    std::array<int, D - 1> fans;
    std::transform(ridge.begin(), ridge.end(), fans.begin(),
      [&](int vertex) { return this->FanOfCorner[this->CornerAt(side, vertex)]; });
    return fans;
  }

  /**
   * Changes pairs where two pairs, or loose faces, of a ridge have the same vertices. Returns whether there
   * have been any: those that come after a changed pair may still have.
   */
  bool SeparateCollisions(const std::vector<int>& group)
  {
    bool any = false;
    std::map<std::array<int, D - 1>, int> sideAt;
    for (const int side : group)
    {
      const std::array<int, D - 1> fans = this->FansAt(side);
      int& other = sideAt.emplace(fans, side).first->second;
      if (this->FansAt(other) != fans) // it has been separated from yet another since
      {
        other = side;
      }
      if (other != side && this->Pairs.Partner[side] != other)
      {
        this->Separate(side, other);
        any = true;
      }
    }
    return any;
  }

  /** Makes the corners that joined sides lead to, around the vertex of one, a fan of their own. */
  void RenewFan(int start)
  {
    const int vertex = FaceAt<D>(this->Shown, start).Corners[start % D];
    const int fan = this->NumberOfFans++;
    this->FanOfCorner[start] = fan;
    for (int k = 1; k < D; ++k)
    {
      int side = start / D * D + (start % D + k) % D;
      for (;;)
      {
        side = this->Pairs.Partner[side];
        if (side < 0)
        {
          break; // a boundary: try the other way round
        }
        const int corner = this->CornerAt(side, vertex);
        if (this->FanOfCorner[corner] == fan)
        {
          return;
        }
        this->FanOfCorner[corner] = fan;
        if (D == 2)
        {
          break;
        }
        side = corner / D * D + (D - corner % D - side % D); // the third of 0, 1, 2
      }
    }
  }

  /** Renews the fans that have the ends of a side's ridge. */
  void RenewFansAt(int side)
  {
    for (const int vertex : RidgeAt<D>(this->Shown, side))
    {
      this->RenewFan(this->CornerAt(side, vertex));
    }
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
      this->RenewFansAt(a);
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
        const int other = std::exchange(partner, -1);
        this->Pairs.Partner[other] = -1;
        this->RenewFansAt(other);
      }
    }
    for (int k = 0; k < D; ++k)
    {
      this->RenewFan(side / D * D + k);
    }
  }

  ManifoldLevel<D> Number()
  {
    const int numberOfCorners = static_cast<int>(this->Pairs.Partner.size());
    std::vector<int> firsts; // one corner for each vertex
    std::vector<char> isNumbered(this->NumberOfFans, 0);
    for (int corner = 0; corner < numberOfCorners; ++corner)
    {
      char& known = isNumbered[this->FanOfCorner[corner]];
      if (!known)
      {
        firsts.push_back(corner);
        known = 1;
      }
    }
    const auto pointOf = [&](int corner)
    { return FaceAt<D>(this->Shown, corner).Corners[corner % D]; };
    std::stable_sort(
      firsts.begin(), firsts.end(), [&](int a, int b) { return pointOf(a) < pointOf(b); });
    ManifoldLevel<D> result;
    std::vector<int> vertexOfFan(this->NumberOfFans, -1);
    for (const int first : firsts)
    {
      vertexOfFan[this->FanOfCorner[first]] = static_cast<int>(result.Points.size());
      result.Points.push_back(pointOf(first));
    }
    result.Faces.resize(this->Shown.Faces.size());
    for (int corner = 0; corner < numberOfCorners; ++corner)
    {
      result.Faces[corner / D][corner % D] = vertexOfFan[this->FanOfCorner[corner]];
    }
    return result;
  }

  const Level<D>& Shown;
  FacePairs Pairs;
  std::vector<int> FanOfCorner; ///< corners of one fan have the same vertex
  int NumberOfFans = 0;         ///< that have been counted, some of which may be no more
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
