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
 * over the copy takes a fraction of the time of a way down the tree.
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
   * Whether `predicate` holds for box and corners of any triangle whose box `meets` accepts. It has
   * to accept all boxes around an accepted one.
   */
  template <class BoxPredicate, class Predicate>
  bool Any(BoxPredicate&& meets, Predicate&& predicate) const
  {
    return this->HasCopies
      ? std::any_of(this->Copies.begin(), this->Copies.end(),
          [&](const Copy& copy)
          { return meets(copy.Bounds) && predicate(copy.Bounds, copy.Corners); })
      : this->Tree.Any(meets,
          [&](int t)
          {
            const FacetItems<3>& items = this->Tree.GetItems();
            return predicate(items.BoxOf(t), items.CornersOf(t));
          });
  }

  /**
   * Calls `visit` with the index and corners of each triangle that counts and that a moving face may
   * meet. The face may change meanwhile, to the same motion for a shorter time.
   */
  template <class Predicate, class Visitor>
  void ForEachSwept(const SweptFace& face, Predicate&& counts, Visitor&& visit) const
  {
    if (!this->HasCopies)
    {
      this->Tree.ForEachFromTop(
        face.GetStartNormal(), [&face](const Box& box) { return face.MayMeet(box); },
        [&](int t)
        {
          const auto corners = this->Tree.GetItems().CornersOf(t);
          if (counts(t) && face.MayMeet(corners))
          {
            visit(t, corners);
          }
        });
      return;
    }
    for (const Copy& copy : this->Copies)
    {
      if (counts(copy.Index) && face.GetBounds().Overlaps(copy.Bounds) &&
        face.MayMeet(copy.Corners))
      {
        visit(copy.Index, copy.Corners);
      }
    }
  }

private:
  struct Copy
  {
    Box Bounds;
    std::array<Point, 3> Corners;
    int Index;
  };

  const FacetTree<3>& Tree;
  Box Region;
  bool HasCopies = false; ///< of all triangles in the region; not if there are many
  std::vector<Copy> Copies;
};

} // namespace carving::helper

#endif
