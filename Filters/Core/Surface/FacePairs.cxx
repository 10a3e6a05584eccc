// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/FacePairs.h"

#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/LargePages.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carving
{
namespace
{

template <int D>
class Pairer
{
public:
  Pairer(const StoredStream<D>& stream, const Level<D>& level)
    : Stored(stream)
    , Mesh(stream.Mesh)
    , Shown(level)
  {
    this->Pairs.Partner = MakeLarge<int>(D * level.Faces.size(), -1);
  }

  FacePairs Run()
  {
    this->FindRidges();
    for (const std::vector<int>& group : this->Pairs.Crowded)
    {
      this->PairCrowded(group);
    }
    return std::move(this->Pairs);
  }

private:
  using Ridge = std::array<int, D - 1>;
  using SideAt = std::pair<int, int>; ///< a key, the side

  /** Groups the sides of all faces by ridge. Joins the two sides of a regular ridge. */
  void FindRidges()
  {
    const int numberOfSides = static_cast<int>(this->Pairs.Partner.size());
    Buckets<SideAt> sides(this->Mesh.Surface.Points.size(),
      [&](auto&& visit)
      {
        for (int side = 0; side < numberOfSides; ++side)
        {
          const Ridge ridge = RidgeAt<D>(this->Shown, side);
          visit(ridge[0], SideAt(ridge.back(), side));
        }
      });
    for (int vertex = 0; vertex < sides.GetNumberOfBuckets(); ++vertex)
    {
      const auto bucket = sides[vertex];
      std::sort(bucket.begin(), bucket.end());
      for (auto first = bucket.begin(); first != bucket.end();)
      {
        const auto last = std::find_if(first, bucket.end(),
          [last = first->first](const SideAt& side) { return side.first != last; });
        this->PairGroup(first, last);
        first = last;
      }
    }
  }

  template <class Iterator>
  void PairGroup(Iterator first, Iterator last)
  {
    const auto count = last - first;
    if (count > 2 || (count == 2 && !this->PairIfAlike(first[0].second, first[1].second)))
    {
      std::vector<int>& group = this->Pairs.Crowded.emplace_back();
      std::transform(
        first, last, std::back_inserter(group), [](const SideAt& side) { return side.second; });
    }
  }

  /** Joins two sides if both are free and traverse their ridge in opposite directions. */
  bool JoinIfOpposite(int a, int b)
  {
    const bool fit = this->Pairs.Partner[a] < 0 && this->Pairs.Partner[b] < 0 &&
      IsForward<D>(this->Shown, a) != IsForward<D>(this->Shown, b);
    if (fit)
    {
      this->Pairs.Join(a, b);
    }
    return fit;
  }

  /** Joins two such sides if both faces are folds, or neither is. */
  bool PairIfAlike(int a, int b)
  {
    return FaceAt<D>(this->Shown, a).Fold == FaceAt<D>(this->Shown, b).Fold &&
      this->JoinIfOpposite(a, b);
  }

  void PairCrowded(const std::vector<int>& group)
  {
    std::vector<int> folds, others;
    for (const int side : group)
    {
      (FaceAt<D>(this->Shown, side).Fold ? folds : others).push_back(side);
    }
    if (this->Stored.Folds == FoldSides::Both && !folds.empty())
    {
      this->PairAcross(group, true);
      return;
    }
    if (others.size() == 2)
    {
      this->PairIfAlike(others[0], others[1]);
    }
    else
    {
      this->PairAcross(others, D == 3);
    }
    if (folds.size() == 2)
    {
      this->PairIfAlike(folds[0], folds[1]);
    }
  }

  bool IsExterior(int halfFace) const
  {
    return StepAt(this->Stored, halfFace) <= this->Shown.Step;
  }

  int ConstraintOf(int halfFace) const
  {
    return this->Mesh.Constraints.Get(HalfFace<D>::Cell(halfFace), HalfFace<D>::Corner(halfFace));
  }

  /** The half-face in the exterior next to a face, or else the one behind the face; or Outside. */
  int Beside(const FaceLife<D>& face, bool exterior) const
  {
    return exterior ? InFront(this->Stored, face) : face.Behind;
  }

  /**
   * Rotates around a ridge through exterior cells, or else through the others, and returns the last
   * half-face.
   */
  int Turn(int start, const Ridge& ridge, bool exterior) const
  {
    for (int at = start; at >= 0;)
    {
      const int exit = AcrossCell(this->Mesh, at, ridge);
      const bool isFold =
        exterior && this->ConstraintOf(exit) >= 0 && this->Stored.Folds == FoldSides::Both;
      at = Across(this->Mesh, exit);
      // In a damaged stream the rotation may return to its start.
      if (isFold || at == start || this->IsExterior(at) != exterior)
      {
        return exit;
      }
    }
    return Outside;
  }

  void PairAcross(const std::vector<int>& sides, bool exterior)
  {
    std::vector<SideAt> besides; // the half-face next to a face, a side of the face
    for (const int side : sides)
    {
      besides.emplace_back(this->Beside(FaceAt<D>(this->Shown, side), exterior), side);
    }
    std::vector<SideAt> sorted = besides;
    std::sort(sorted.begin(), sorted.end());
    std::vector<int> atOutside;
    for (const auto& [beside, side] : besides)
    {
      const int end = this->Turn(beside, RidgeAt<D>(this->Shown, side), exterior);
      if (end == Outside)
      {
        atOutside.push_back(side);
        continue;
      }
      for (auto other = std::lower_bound(sorted.begin(), sorted.end(), SideAt(end, 0));
           other != sorted.end() && other->first == end; ++other)
      {
        this->JoinIfOpposite(side, other->second);
      }
    }
    if (atOutside.size() == 2) // C0 is a manifold: two rotations end there
    {
      this->JoinIfOpposite(atOutside[0], atOutside[1]);
    }
  }

  const StoredStream<D>& Stored;
  const Decomposition<D>& Mesh;
  const Level<D>& Shown;
  FacePairs Pairs;
};

} // namespace

template <int D>
FacePairs PairFaces(const StoredStream<D>& stream, const Level<D>& level)
{
  return Pairer<D>(stream, level).Run();
}

template FacePairs PairFaces<2>(const StoredStream<2>&, const Level<2>&);
template FacePairs PairFaces<3>(const StoredStream<3>&, const Level<3>&);

} // namespace carving
