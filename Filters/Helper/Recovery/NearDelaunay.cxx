// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/NearDelaunay.h"

#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace carving::helper
{
namespace
{

/**
 * The greatest share of edges that are not Delaunay. Of measured meshes with less, all were
 * recovered as a whole, in a third to four fifths of TetGen's time. Of those with 0.13 to 0.24,
 * five of seven lacked some triangles or took longer.
 */
constexpr double MaximumShare = 0.12;

double CotangentAt(const ResolvedMesh& mesh, int corner)
{
  const Triangle& t = mesh.Facets[corner / 3];
  return Cotangent(
    mesh.Points[t[corner % 3]], mesh.Points[t[(corner + 1) % 3]], mesh.Points[t[(corner + 2) % 3]]);
}

} // namespace

bool IsNearDelaunay(const ResolvedMesh& mesh)
{
  using Side = std::array<int, 2>; // of an edge: the greater end; the opposite corner
  Buckets<Side> sides(mesh.Points.size(),
    [&](auto&& visit)
    {
      for (int corner = 0; corner < static_cast<int>(3 * mesh.Facets.size()); ++corner)
      {
        const Triangle& t = mesh.Facets[corner / 3];
        const auto [lower, upper] = std::minmax({ t[(corner + 1) % 3], t[(corner + 2) % 3] });
        visit(lower, Side{ upper, corner });
      }
    });
  // At exactly 180 degrees, as in flat grids, either diagonal may be in the tetrahedralization.
  constexpr double tie = 1e-9;
  std::size_t all = 0, inner = 0, bad = 0;
  for (int lower = 0; lower < sides.GetNumberOfBuckets(); ++lower)
  {
    const auto bucket = sides[lower];
    std::sort(bucket.begin(), bucket.end());
    for (auto first = bucket.begin(); first != bucket.end();)
    {
      const auto last = std::find_if(
        first, bucket.end(), [upper = (*first)[0]](const Side& side) { return side[0] != upper; });
      ++all;
      if (last - first == 2)
      {
        ++inner;
        // The angles add up to less than 180 degrees where their cotangents have a positive sum.
        bad += CotangentAt(mesh, first[0][1]) + CotangentAt(mesh, first[1][1]) < tie;
      }
      first = last;
    }
  }
  return 2 * inner >= all && static_cast<double>(bad) <= MaximumShare * static_cast<double>(inner);
}

} // namespace carving::helper
