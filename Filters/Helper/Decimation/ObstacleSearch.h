// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Searches for triangles of a mesh, many of which are in one small region.
 */
#ifndef carving_ObstacleSearch_h
#define carving_ObstacleSearch_h

#include "Core/Mesh/FacetTree.h"
#include "Helper/Decimation/FirstContact.h"

#include <algorithm>
#include <vector>

namespace carving::helper
{

/**
 * A search tree with a copy of the triangles of one region. Each attempt to collapse an edge asks
 * for a few triangles a hundred times: for every face around the edge, at every contact. A pass
 * over the copy, in groups, takes a fraction of the time of a way down the tree.
 */
class ObstacleSearch
{
public:
  /** The tree must outlive this object. */
  explicit ObstacleSearch(const FacetTree<3>& tree)
    : Tree(tree)
  {
  }

  const ResolvedMesh& GetMesh() const
  {
    return this->Tree.GetItems().GetMesh();
  }

  /** Prepares for searches within a region. Searches outside may miss triangles. */
  void MoveTo(const Box& region);

  /**
   * Whether `predicate` holds for box and corners of any triangle whose box `meets` accepts.
   * `meets` has to accept every box around a box that it accepts.
   */
  template <class BoxPredicate, class Predicate>
  bool Any(BoxPredicate&& meets, Predicate&& predicate) const
  {
    return this->HasCopies
      ? this->AnyCopy(meets, [&](const Copy& copy) { return predicate(copy.Bounds, copy.Corners); })
      : this->Tree.Any(meets,
          [&](int t)
          {
            const FacetItems<3>& items = this->Tree.GetItems();
            return predicate(items.BoxOf(t), items.CornersOf(t));
          });
  }

  /**
   * Calls `visit` with the index and corners of each triangle that counts and that a moving face
   * may meet. The face may change meanwhile, to the same motion for a shorter time.
   */
  template <class Predicate, class Visitor>
  void ForEachSwept(const SweptFace& face, Predicate&& counts, Visitor&& visit) const
  {
    const auto visitIfMet = [&](int t, const std::array<Point, 3>& corners)
    {
      if (counts(t) && face.MayMeet(corners))
      {
        visit(t, corners);
      }
    };
    if (!this->HasCopies)
    {
      this->Tree.ForEachFromTop(
        face.GetStartNormal(), [&face](const Box& box) { return face.MayMeet(box); },
        [&](int t) { visitIfMet(t, this->Tree.GetItems().CornersOf(t)); });
      return;
    }
    this->AnyCopy([&face](const Box& box) { return face.GetBounds().Overlaps(box); },
      [&](const Copy& copy)
      {
        visitIfMet(copy.Index, copy.Corners);
        return false; // all of them
      });
  }

private:
  struct Copy
  {
    Box Bounds;
    std::array<Point, 3> Corners;
    int Index;
  };

  /** As Any, for copies. */
  template <class BoxPredicate, class Predicate>
  bool AnyCopy(BoxPredicate&& meets, Predicate&& predicate) const
  {
    const auto isMet = [&](const Copy& copy) { return meets(copy.Bounds) && predicate(copy); };
    auto first = this->Copies.begin();
    for (const Box& group : this->Groups)
    {
      const auto last = first + std::min(GroupSize, this->Copies.end() - first);
      if (meets(group) && std::any_of(first, last, isMet))
      {
        return true;
      }
      first = last;
    }
    return false;
  }

  static constexpr std::ptrdiff_t GroupSize = 8;

  const FacetTree<3>& Tree;
  Box Region;
  bool HasCopies = false;   ///< of all triangles in the region; not if there are many
  std::vector<Copy> Copies; ///< neighbors of each other mostly are in one group
  std::vector<Box> Groups;  ///< the boxes around GroupSize copies each
};

} // namespace carving::helper

#endif
