// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/RecoverAll.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Progress.h"
#include "Helper/Cutting/Cut.h"
#include "Helper/Recovery/Detach.h"
#include "Helper/Recovery/Recover.h"
#include "Helper/Recovery/WriteCells.h"

#include <algorithm>
#include <set>
#include <string>

namespace carving::helper
{
namespace
{

/** The number of triangles of M that have one of the parts. */
std::size_t CountTriangles(const PiercedMesh& mesh, const std::vector<int>& parts)
{
  std::set<int> triangles;
  for (const int part : parts)
  {
    triangles.insert(mesh.GetParts().GetParts()[part].Parent);
  }
  return triangles.size();
}

/** The number of triangles of M that are not single faces. */
std::size_t CountDivided(const PiercedMesh& mesh, const std::vector<Triangle>& facets)
{
  std::size_t whole = 0;
  const auto& parts = mesh.GetParts().GetParts();
  for (int part = 0; part < static_cast<int>(parts.size()); ++part)
  {
    const auto& [corners, parent] = parts[part];
    whole += parent >= 0 &&
      std::is_permutation(corners.begin(), corners.end(), facets[parent].begin()) &&
      mesh.IsFace(part);
  }
  return facets.size() - whole;
}

} // namespace

Ending RecoverAll(const std::vector<Point>& further, RecoveryEffort effort, int threads,
  const std::function<bool(double)>& progress, Tetrahedralization& result)
{
  const ResolvedMesh& surface = result.Surface;
  const std::size_t facets = surface.Facets.size();
  PiercedMesh mesh(surface, further, threads, PartOf(progress, 0.0, 0.4));
  std::size_t missing = mesh.FindMissing().size();
  constexpr double fewMissing = 0.15; // per triangle: with more, TetGen takes less time
  const bool givesUp = effort == RecoveryEffort::Little &&
    static_cast<double>(missing) > fewMissing * static_cast<double>(facets);
  if (missing > 0 && !givesUp)
  {
    constexpr std::ptrdiff_t stepsPerFacet = 30; // cutting takes less time than more steps
    Recover(mesh, stepsPerFacet * static_cast<std::ptrdiff_t>(facets), PartOf(progress, 0.4, 0.6));
    const std::size_t most = 100000 + 10 * facets;
    const std::vector<Subdivision::Part> needles = Cut(mesh,
      CutTolerance * Diagonal(surface.Points), { most, most }, threads, PartOf(progress, 0.6, 0.9));
    missing = CountTriangles(mesh, mesh.FindMissing()) + needles.size();
    if (missing == 0)
    {
      constexpr int searches = 500;
      RemoveFolds(mesh);
      DetachAll(mesh, static_cast<int>(surface.Points.size() + further.size()), searches);
      missing = CountDivided(mesh, surface.Facets);
    }
  }
  if (missing > 0)
  {
    return { "recovery lacks " + std::to_string(missing) + " of " + std::to_string(facets) +
      " triangles of the mesh" };
  }
  WriteCells(mesh, result);
  std::vector<std::array<int, 4>> constraints(result.Cells.size());
  for (const PiercedMesh::Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    for (int f = 0; f < 4; ++f)
    {
      const int part = cell->info().PartOn(f);
      constraints[cell->info().Index][f] =
        part < 0 ? part : mesh.GetParts().GetParts()[part].Parent;
    }
  }
  result.Constraints = FaceConstraints<3>(constraints);
  return {};
}

} // namespace carving::helper
