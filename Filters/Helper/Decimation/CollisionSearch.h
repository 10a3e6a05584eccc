// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Collisions of a surface with itself while it changes.
 */
#ifndef carving_CollisionSearch_h
#define carving_CollisionSearch_h

#include "Core/Mesh/BoxTree.h"
#include "Helper/Decimation/SurfaceMesh.h"

namespace carving::helper
{

class CollisionSearch
{
public:
  /** `surface` must outlive this object. */
  explicit CollisionSearch(const SurfaceMesh& surface);

  /**
   * Whether the surface may become one whose faces in a star are those around w: it does not cross
   * itself, and does not sweep over a part of itself, which would then be on the wrong side without
   * crossing anything: a component or void, or a part that is joined in a copy of a point. A
   * connected surface without copies has no such part. Exact.
   */
  bool IsFree(const Star& star, const Point& w) const;

  /** Whether a face of a star may be a side of a sheet, whose other side is below the face. */
  bool MayCoverSheet(const Star& star) const;

  /** Updates the search after faces of a star have changed or been removed. */
  void Update(const Star& star);

private:
  template <class BoxPredicate, class Predicate>
  bool AnyOutside(const Star& star, BoxPredicate&& meets, Predicate&& predicate) const;
  bool Crosses(const Star& star, const Point& w) const;
  bool SweepsOver(const Star& star, const Point& w) const;

  const SurfaceMesh& Surface;
  BoxTree<FaceItems> Tree;
  SurfaceMesh::size_type FacesAtBuild;
  bool CanSweepOver;         ///< over a part of itself, without crossing it
  std::vector<char> IsSheet; ///< per face: whether it has been a side of a sheet as given
};

} // namespace carving::helper

#endif
