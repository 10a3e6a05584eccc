// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/RecoverAll.h"

#include "Helper/Recovery/Recover.h"
#include "Helper/Recovery/WriteCells.h"

#include <string>

namespace carving::helper
{
namespace
{

RecoveryLimits MakeLimits(RecoveryEffort effort, std::size_t numberOfFacets)
{
  const auto facets = static_cast<std::ptrdiff_t>(numberOfFacets);
  return effort == RecoveryEffort::Little
    ? RecoveryLimits{ 1000000 + 100 * facets, true, 0.1 }
    : RecoveryLimits{ 5000000 + 1000 * facets, true }; // they take seconds
}

} // namespace

Ending RecoverAll(const std::vector<Point>& further, RecoveryEffort effort,
  const std::function<bool(double)>& progress, Tetrahedralization& result)
{
  const std::size_t facets = result.Surface.Facets.size();
  PiercedMesh mesh(result.Surface, further, [&](double done) { return progress(done / 2.0); });
  const std::size_t missing = Recover(
    mesh, MakeLimits(effort, facets), [&](double done) { return progress((1.0 + done) / 2.0); });
  if (missing > 0)
  {
    return { "recovery lacks " + std::to_string(missing) + " of " + std::to_string(facets) +
      " triangles of the mesh" };
  }
  WriteCells(mesh, result);
  for (const PiercedMesh::Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    for (int f = 0; f < 4; ++f)
    {
      result.Constraints[cell->info().Index][f] = cell->info().PartOn(f);
    }
  }
  return {};
}

} // namespace carving::helper
