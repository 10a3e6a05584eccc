// SPDX-License-Identifier: BSD-3-Clause
#include "Manifold.h"

#include "Ridges.h"

#include <algorithm>
#include <numeric>

namespace carving
{
namespace
{

/** Sets of corners that are one vertex. */
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size)
    : Parent(size)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  /** The smallest member of the set. */
  int Find(int a)
  {
    while (this->Parent[a] != a)
    {
      a = this->Parent[a] = this->Parent[this->Parent[a]];
    }
    return a;
  }

  void Unite(int a, int b)
  {
    const auto [lower, upper] = std::minmax({ this->Find(a), this->Find(b) });
    this->Parent[upper] = lower;
  }

private:
  std::vector<int> Parent;
};

/** Corner (or, of a ridge, opposite corner) k of face i as the number D * i + k. */
template <int D>
class Cutter
{
public:
  Cutter(const StoredStream<D>& stream, const Level<D>& level)
    : Stored(stream)
    , Mesh(stream.Mesh)
    , Shown(level)
    , Partner(D * level.Faces.size(), -1)
  {
    this->FindRidges();
  }

  ManifoldLevel<D> Cut()
  {
    for (const std::vector<int>& group : this->Crowded)
    {
      this->PairCrowded(group);
    }
    // Separating only ever splits fans, so that what is separate stays so.
    for (const std::vector<int>& group : this->Crowded)
    {
      while (this->SeparateCollision(group))
      {
      }
    }
    return this->Number();
  }

private:
  using Ridge = std::array<int, D - 1>;

  Ridge GetRidge(int side) const
  {
    return RidgeOf<D>(this->Shown.Faces[side / D].Corners, side % D);
  }

  const FaceLife<D>& GetFace(int side) const
  {
    return this->Shown.Faces[side / D];
  }

  /** Whether the face passes the ridge in the ascending direction of its corners. */
  bool IsForward(int side) const
  {
    const std::array<int, D>& corners = this->GetFace(side).Corners;
    const int k = side % D;
    if constexpr (D == 3)
    {
      return corners[(k + 1) % 3] < corners[(k + 2) % 3];
    }
    else
    {
      return k == 0; // the ridge is the end of the edge
    }
  }

  void Pair(int a, int b)
  {
    this->Partner[a] = b;
    this->Partner[b] = a;
  }

  /** Groups the sides of all faces by their ridges; joins the two of a regular one. */
  void FindRidges()
  {
    const int numberOfSides = static_cast<int>(this->Partner.size());
    std::vector<int> ends(this->Mesh.Surface.Points.size() + 1, 0);
    std::vector<Ridge> ridges(numberOfSides);
    for (int side = 0; side < numberOfSides; ++side)
    {
      ridges[side] = this->GetRidge(side);
      ++ends[ridges[side][0] + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    const std::vector<int> begins = ends;
    std::vector<int> sides(numberOfSides);
    for (int side = 0; side < numberOfSides; ++side)
    {
      sides[ends[ridges[side][0]]++] = side;
    }
    for (std::size_t vertex = 0; vertex + 1 < begins.size(); ++vertex)
    {
      const auto end = sides.begin() + begins[vertex + 1];
      auto first = sides.begin() + begins[vertex];
      std::sort(first, end,
        [&](int a, int b) { return ridges[a] != ridges[b] ? ridges[a] < ridges[b] : a < b; });
      while (first != end)
      {
        const auto last =
          std::find_if(first, end, [&](int side) { return ridges[side] != ridges[*first]; });
        this->PairGroup({ first, last });
        first = last;
      }
    }
  }

  void PairGroup(const std::vector<int>& group)
  {
    if (group.size() > 2 || (group.size() == 2 && !this->PairIfAlike(group)))
    {
      this->Crowded.push_back(group);
    }
  }

  /** Joins two faces of one kind if they pass their ridge in opposite directions. */
  bool PairIfAlike(const std::vector<int>& sides)
  {
    const int a = sides[0], b = sides[1];
    const bool alike =
      this->GetFace(a).Fold == this->GetFace(b).Fold && this->IsForward(a) != this->IsForward(b);
    if (alike)
    {
      this->Pair(a, b);
    }
    return alike;
  }

  void PairCrowded(const std::vector<int>& group)
  {
    std::vector<int> folds, others;
    for (const int side : group)
    {
      (this->GetFace(side).Fold ? folds : others).push_back(side);
    }
    if (this->Stored.Folds == FoldSides::Both && !folds.empty())
    {
      this->PairAcrossExterior(group);
      return;
    }
    if (others.size() == 2)
    {
      this->PairIfAlike(others);
    }
    else
    {
      this->PairAcrossSolid(others);
    }
    if (folds.size() == 2)
    {
      this->PairIfAlike(folds);
    }
  }

  bool IsExterior(int halfFace) const
  {
    return StepAt(this->Stored, halfFace) <= this->Shown.Step;
  }

  /** The half-face or Solid or Outside on the other side of a half-face. */
  int Across(int halfFace) const
  {
    const int cell = HalfFace<D>::Cell(halfFace);
    const int corner = HalfFace<D>::Corner(halfFace);
    const int neighbor = this->Mesh.Neighbors[cell][corner];
    return neighbor < 0 ? neighbor : AcrossFace(this->Mesh, halfFace);
  }

  int ConstraintOf(int halfFace) const
  {
    return this->Mesh.Constraints[HalfFace<D>::Cell(halfFace)][HalfFace<D>::Corner(halfFace)];
  }

  /** Which corner of the facet the ridge is opposite to. */
  int OppositeCorner(int facet, const Ridge& ridge) const
  {
    const std::array<int, D>& corners = this->Mesh.Surface.Facets[facet];
    int k = 0;
    while (std::find(ridge.begin(), ridge.end(), corners[k]) != ridge.end())
    {
      ++k;
    }
    return k;
  }

  /**
   * The face, given by facet of M (as -1 - facet) or by half-face in the exterior, at which a turn
   * through solid and uncarved cells ends that starts behind the given face.
   */
  int TurnThroughSolid(const FaceLife<D>& face, const Ridge& ridge) const
  {
    int at = face.Behind;
    int facet = face.Constraint;
    for (;;)
    {
      if (at == Solid)
      {
        facet = this->Stored.Turns[facet][this->OppositeCorner(facet, ridge)];
        const auto& [behind, inFront] = this->Stored.Sides[facet];
        at = behind == Solid ? inFront : behind;
        if (at == Outside || this->IsExterior(at))
        {
          return -1 - facet;
        }
        continue;
      }
      const int exit = AcrossCell(this->Mesh, at, ridge);
      facet = this->ConstraintOf(exit);
      at = this->Across(exit);
      if (at != Solid && this->IsExterior(at))
      {
        return facet >= 0 ? -1 - facet : exit;
      }
    }
  }

  void PairAcrossSolid(const std::vector<int>& sides)
  {
    for (const int side : sides)
    {
      if (this->Partner[side] >= 0)
      {
        continue;
      }
      const int end = this->TurnThroughSolid(this->GetFace(side), this->GetRidge(side));
      for (const int other : sides)
      {
        const FaceLife<D>& face = this->GetFace(other);
        if (end < 0 ? face.Constraint == -1 - end : face.Behind == end)
        {
          this->Pair(side, other);
        }
      }
    }
  }

  /** The half-face in the exterior in front of the face at which a turn through it ends. */
  int TurnThroughExterior(const FaceLife<D>& face, const Ridge& ridge) const
  {
    int at = face.InFront;
    while (at != Outside)
    {
      const int exit = AcrossCell(this->Mesh, at, ridge);
      at = this->Across(exit);
      if (this->ConstraintOf(exit) >= 0 || at == Solid || (at >= 0 && !this->IsExterior(at)))
      {
        return exit;
      }
    }
    return Outside;
  }

  void PairAcrossExterior(const std::vector<int>& sides)
  {
    int atOutside = -1; // C0 is a manifold: two turns end there
    for (const int side : sides)
    {
      if (this->Partner[side] >= 0)
      {
        continue;
      }
      const int end = this->TurnThroughExterior(this->GetFace(side), this->GetRidge(side));
      if (end == Outside)
      {
        if (atOutside >= 0)
        {
          this->Pair(atOutside, side);
        }
        atOutside = side;
        continue;
      }
      for (const int other : sides)
      {
        if (this->GetFace(other).InFront == end)
        {
          this->Pair(side, other);
        }
      }
    }
  }

  /** Corner sets by the pairs there are. */
  DisjointSets JoinCorners() const
  {
    DisjointSets sets(this->Partner.size());
    for (int side = 0; side < static_cast<int>(this->Partner.size()); ++side)
    {
      const int partner = this->Partner[side];
      if (partner <= side)
      {
        continue;
      }
      for (const int vertex : this->GetRidge(side))
      {
        sets.Unite(this->CornerAt(side, vertex), this->CornerAt(partner, vertex));
      }
    }
    return sets;
  }

  int CornerAt(int side, int vertex) const
  {
    const std::array<int, D>& corners = this->GetFace(side).Corners;
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
        if (this->Partner[group[i]] != group[j] && this->HaveSameVertices(group[i], group[j]))
        {
          this->Separate(group[i], group[j]);
          return true;
        }
      }
    }
    return false;
  }

  bool HaveSameVertices(int a, int b) const
  {
    const Ridge ridge = this->GetRidge(a);
    return std::all_of(
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
        side = this->Partner[side];
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
    const int partnerOfA = this->Partner[a], partnerOfB = this->Partner[b];
    if (partnerOfA >= 0 && partnerOfB >= 0)
    {
      // One fan passes the ridge twice; crossed over, it becomes two.
      const bool opposite = this->IsForward(a) != this->IsForward(b);
      this->Pair(a, opposite ? b : partnerOfB);
      this->Pair(partnerOfA, opposite ? partnerOfB : b);
      return;
    }
    this->Isolate(partnerOfA < 0 ? a : b);
  }

  /** Cuts a face off on all sides. */
  void Isolate(int side)
  {
    for (int k = 0; k < D; ++k)
    {
      int& partner = this->Partner[side / D * D + k];
      if (partner >= 0)
      {
        this->Partner[partner] = -1;
        partner = -1;
      }
    }
  }

  ManifoldLevel<D> Number() const
  {
    DisjointSets sets = this->JoinCorners();
    const int numberOfCorners = static_cast<int>(this->Partner.size());
    std::vector<int> firsts; // one corner for each vertex
    for (int corner = 0; corner < numberOfCorners; ++corner)
    {
      if (sets.Find(corner) == corner)
      {
        firsts.push_back(corner);
      }
    }
    const auto pointOf = [&](int corner) { return this->GetFace(corner).Corners[corner % D]; };
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

  const StoredStream<D>& Stored;
  const Decomposition<D>& Mesh;
  const Level<D>& Shown;
  /** Per side of a face: the side that it is joined with at their ridge, -1 for a boundary. */
  std::vector<int> Partner;
  /** The sides at each ridge that has more than two. */
  std::vector<std::vector<int>> Crowded;
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
