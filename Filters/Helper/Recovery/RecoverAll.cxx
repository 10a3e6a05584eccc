// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/RecoverAll.h"

#include "Helper/Recovery/Recover.h"
#include "Helper/Recovery/WriteCells.h"

#include <string>

namespace carving::helper
{

Ending RecoverAll(const std::vector<Point>& further, const std::function<bool(double)>& progress,
  Tetrahedralization& result)
{
  const std::size_t facets = result.Surface.Facets.size();
  PiercedMesh mesh(result.Surface, further, [&](double done) { return progress(done / 2.0); });
  const auto steps = 5000000 + 1000 * static_cast<std::ptrdiff_t>(facets); // they take seconds
  const std::size_t missing =
    Recover(mesh, { steps, true }, [&](double done) { return progress((1.0 + done) / 2.0); });
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
