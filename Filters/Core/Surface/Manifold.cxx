// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/Manifold.h"

#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/LargePages.h"
#include "Core/Mesh/SortUnique.h"
#include "Core/Surface/FacePairs.h"

#include <algorithm>
#include <map>
#include <utility>

namespace carving
{
namespace
{

/** Corner k of face i has the number D * i + k, which is also that of the opposite side. */
template <int D>
class Cutter
{
public:
  Cutter(const StoredStream<D>& stream, const Level<D>& level)
    : Shown(level)
    , NumberOfPoints(stream.Mesh.Surface.Points.size())
    , Pairs(PairFaces(stream, level))
  {
  }

  ManifoldLevel<D> Cut()
  {
    this->FindFans();
    // The loops end: Separate only ever splits fans.
    for (const std::vector<int>& group : this->Pairs.Crowded)
    {
      while (this->SeparateCollisions(group))
      {
      }
    }
    return this->Number();
  }

private:
  /** Unites corners at the same vertex of joined faces into fans. */
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
    this->FanOfCorner = MakeLarge<int>(numberOfCorners);
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

  /** The fans at the corners of a side's ridge. */
  std::array<int, D - 1> FansAt(int side) const
  {
    const std::array<int, D - 1> ridge = RidgeAt<D>(this->Shown, side);
    std::array<int, D - 1> fans;
    std::transform(ridge.begin(), ridge.end(), fans.begin(),
      [&](int vertex) { return this->FanOfCorner[this->CornerAt(side, vertex)]; });
    return fans;
  }

  /**
   * Changes the pairing where two pairs or unpaired faces at a ridge would share all vertices.
   * Returns whether there were any; the caller repeats, since a change can leave collisions among
   * pairs already compared.
   */
  bool SeparateCollisions(const std::vector<int>& group)
  {
    bool any = false;
    std::map<std::array<int, D - 1>, int> sideAt;
    for (const int side : group)
    {
      const std::array<int, D - 1> fans = this->FansAt(side);
      int& other = sideAt.emplace(fans, side).first->second;
      if (this->FansAt(other) != fans) // changed since by another separation
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

  /**
   * Makes a new fan of a corner and of all corners at its vertex that joined sides connect to it.
   */
  void RenewFan(int start)
  {
    const int vertex = FaceAt<D>(this->Shown, start).Corners[start % D];
    const int fan = this->NumberOfFans++;
    this->FanOfCorner[start] = fan;
    for (int k = 1; k < D; ++k) // both ways around the vertex
    {
      int side = this->Pairs.Partner[start / D * D + (start % D + k) % D];
      while (side >= 0)
      {
        const int corner = this->CornerAt(side, vertex);
        if (this->FanOfCorner[corner] == fan)
        {
          return; // all the way around
        }
        this->FanOfCorner[corner] = fan;
        const int exit = corner / D * D + (D - corner % D - side % D); // the third of 0, 1, 2
        side = D == 2 ? -1 : this->Pairs.Partner[exit];
      }
    }
  }

  /** Renews the fans at the corners of a side's ridge. */
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
      // One fan contains the ridge twice. Exchanging the partners splits it in two.
      const bool opposite = IsForward<D>(this->Shown, a) != IsForward<D>(this->Shown, b);
      this->Pairs.Join(a, opposite ? b : partnerOfB);
      this->Pairs.Join(partnerOfA, opposite ? partnerOfB : b);
      this->RenewFansAt(a);
      return;
    }
    this->Isolate(partnerOfA < 0 ? a : b);
  }

  /** Cuts a face off at all of its sides. */
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
    std::vector<int> firsts; // one corner per vertex
    std::vector<char> isNumbered = MakeLarge<char>(this->NumberOfFans);
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
    const Buckets<int> sorted(this->NumberOfPoints,
      [&](auto&& visit)
      {
        for (const int first : firsts)
        {
          visit(pointOf(first), first);
        }
      });
    ManifoldLevel<D> result;
    std::vector<int> vertexOfFan = MakeLarge<int>(this->NumberOfFans, -1);
    ReserveLarge(result.Points, firsts.size());
    for (const int first : sorted.GetItems())
    {
      vertexOfFan[this->FanOfCorner[first]] = static_cast<int>(result.Points.size());
      result.Points.push_back(pointOf(first));
    }
    result.Faces = MakeLarge<std::array<int, D>>(this->Shown.Faces.size());
    for (int corner = 0; corner < numberOfCorners; ++corner)
    {
      result.Faces[corner / D][corner % D] = vertexOfFan[this->FanOfCorner[corner]];
    }
    return result;
  }

  const Level<D>& Shown;
  std::size_t NumberOfPoints; ///< of the stream
  FacePairs Pairs;
  std::vector<int> FanOfCorner; ///< corners of one fan become one vertex
  int NumberOfFans = 0;         ///< numbers in use, some of which no longer occur
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
  SortUnique(result.Points);
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
