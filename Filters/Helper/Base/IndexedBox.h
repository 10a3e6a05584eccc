// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_IndexedBox_h
#define carving_IndexedBox_h

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_d.h>

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

} // namespace carving::helper

#endif
