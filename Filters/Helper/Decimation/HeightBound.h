// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_HeightBound_h
#define carving_HeightBound_h

#include "Core/Mesh/FacetTree.h"

#include <array>
#include <vector>

namespace carving::helper
{

/**
 * Shows that faces are close to a mesh, mostly in a tenth of the time that FaceDistance takes. The
 * height of a face above the facets below it, along its normal, is at least the distance. That
 * bounds the whole face if these facets are a sheet without folds, holes and further branches.
 */
class HeightBound
{
public:
  /** The mesh must outlive this object. */
  explicit HeightBound(const ResolvedMesh& mesh);

  /**
   * Whether the facets around the facet `start` show that every point of a face is within `bound`
   * of the mesh. If not, the face may still be.
   */
  bool IsWithin(const FacetCorners<3>& face, double bound, int start);

private:
  const ResolvedMesh& Mesh;
  std::vector<std::array<int, 3>> Neighbors; ///< -1 where the sheet ends, branches or turns over
  std::vector<char> IsFound;
  std::vector<int> Found; ///< the facets of the sheet
};

} // namespace carving::helper

#endif
