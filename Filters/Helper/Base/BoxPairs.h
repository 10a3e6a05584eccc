// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Boxes that meet.
 */
#ifndef carving_BoxPairs_h
#define carving_BoxPairs_h

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/box_intersection_d.h>

#include <cstddef>
#include <vector>

namespace carving::helper
{

/** The bounding box of an item, for CGAL::box_intersection_d; the index tells boxes apart. */
struct IndexedBox : CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_NONE>
{
  IndexedBox(const CGAL::Bbox_3& bounds, int index)
    : Box_d(bounds)
    , Index(index)
  {
  }
  int id() const
  {
    return this->Index;
  }
  int Index;
};

/**
 * The number of boxes from which on CGAL divides them. On meshes without crossings, the default of
 * 10 takes 1.7 times as long.
 */
constexpr std::ptrdiff_t ScanSize = 1000;

/** Calls `visit` with the indices of any two boxes that meet. */
template <class Visit>
void VisitPairs(std::vector<IndexedBox> boxes, const Visit& visit)
{
  CGAL::box_self_intersection_d(
    boxes.begin(), boxes.end(),
    [&](const IndexedBox& a, const IndexedBox& b) { visit(a.Index, b.Index); }, ScanSize);
}

/** The same for boxes of two kinds, each with indices from 0 on. */
template <class Visit>
void VisitPairs(std::vector<IndexedBox> first, std::vector<IndexedBox> second, const Visit& visit)
{
  // CGAL takes boxes of the same index for the same box, even from different sequences.
  const int offset = static_cast<int>(first.size());
  for (IndexedBox& box : second)
  {
    box.Index += offset;
  }
  CGAL::box_intersection_d(
    first.begin(), first.end(), second.begin(), second.end(),
    [&](const IndexedBox& a, const IndexedBox& b) { visit(a.Index, b.Index - offset); }, ScanSize);
}

} // namespace carving::helper

#endif
