// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/Enclose.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/Effort.h"
#include "Helper/Cutting/Cut.h"
#include "Helper/Cutting/HalveKept.h"
#include "Helper/Enclosing/CellShape.h"
#include "Helper/Enclosing/ExposedFaces.h"
#include "Helper/Enclosing/Refine.h"
#include "Helper/Recovery/Recover.h"
#include "Helper/Recovery/WriteCells.h"
#include "Helper/Resolve/Intersections.h"

#include <algorithm>
#include <cfloat>
#include <memory>
#include <numeric>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;

/** Changes that cutting may try: they take some twelve seconds. */
constexpr std::size_t MaximumCuts = 1200000;

/** Adds the faces on which parts of M lie. */
void WriteFaces(const PiercedMesh& mesh, const ResolvedMesh& input, Tetrahedralization& result)
{
  ResolvedMesh& surface = result.Surface;
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    const int index = cell->info().Index;
    for (int f = 0; f < 4; ++f)
    {
      const int part = cell->info().PartOn(f);
      if (part < 0 || result.Constraints[index][f] >= 0)
      {
        continue;
      }
      const int facet = static_cast<int>(surface.Facets.size());
      const int parent = mesh.GetParts().GetParts()[part].Parent;
      const Triangle outward = result.OutwardFace(index, f);
      AppendFacet<3>(input, parent,
        FaceAlike(mesh.CornersOf(part), FaceOf(cell, f)) ? outward : Flipped<3>(outward), surface);
      result.Constraints[index][f] = facet;
      const Cell other = cell->neighbor(f);
      if (!mesh.GetDelaunay().is_infinite(other))
      {
        result.Constraints[other->info().Index][other->index(cell)] = facet;
      }
    }
  }
}

/** Whether more than one pair of triangles in a hundred triangles crosses. */
bool CrossesItselfOften(const ResolvedMesh& input)
{
  constexpr double often = 0.01; // per triangle
  const std::size_t crossings = FindIntersections(input.Points, input.Facets).size();
  return static_cast<double>(crossings) > often * static_cast<double>(input.Facets.size());
}

/**
 * Whether many of the pierced tetrahedra have no volume but for rounding. They are between points of
 * one plane that are off it by a rounding; no double is inside them, so they can neither be cut nor
 * halved.
 */
bool IsOftenFlat(const PiercedMesh& mesh)
{
  constexpr double often = 0.01;
  constexpr double rounding = 1e-12;
  std::size_t pierced = 0, flat = 0;
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    if (cell->info().IsPierced())
    {
      ++pierced;
      flat += QualityOf(CornersOf(cell)) < rounding;
    }
  }
  return static_cast<double>(flat) > often * static_cast<double>(pierced);
}

/**
 * Measures the share of M's area that pierces no tetrahedron, which is returned, and that of each
 * triangle's area.
 */
double MeasureMetShares(const PiercedMesh& mesh, std::vector<double>& shares)
{
  const auto& parts = mesh.GetParts().GetParts();
  std::vector<char> pierces(parts.size(), 0);
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    for (const PartContact& contact : cell->info().All)
    {
      pierces[contact.Part] |= contact.How.Pierces;
    }
  }
  std::vector<double> met(shares.size(), 0.0), all(shares.size(), 0.0);
  for (int part = 0; part < static_cast<int>(parts.size()); ++part)
  {
    const int parent = parts[part].Parent;
    if (parent >= 0)
    {
      const auto [a, b, c] = mesh.GetParts().GetCorners(part);
      // A part without area after rounding has a share nevertheless.
      const double twiceArea = std::max(Length(Cross(b - a, c - a)), DBL_MIN);
      all[parent] += twiceArea;
      met[parent] += pierces[part] ? 0.0 : twiceArea;
    }
  }
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    shares[i] = met[i] / all[i];
  }
  return std::accumulate(met.begin(), met.end(), 0.0) /
    std::accumulate(all.begin(), all.end(), 0.0);
}

} // namespace

Enclosure Enclose(const ResolvedMesh& input, const std::vector<Point>& further, double tolerance,
  const std::function<bool(double)>& progress, Tetrahedralization& result)
{
  const double length = Diagonal(input.Points);
  const SurfaceDistance distance(input);
  constexpr double negligible = 1e-4;
  constexpr double accuracy = 1.05; // distances are exact to within this factor
  const double bound = tolerance * length / accuracy;
  const auto part = [&](double begin, double end) {
    return [&progress, begin, end](double done) { return progress(begin + (end - begin) * done); };
  };
  const auto steps = [&](std::ptrdiff_t perFacet)
  {
    const auto facets = static_cast<std::ptrdiff_t>(input.Facets.size());
    constexpr std::ptrdiff_t many = 60000000; // they take some seconds
    return 100000 + std::max(100 * facets, std::min(perFacet * facets, many));
  };
  const std::size_t most = MaximumPointsAdded(input.Points.size());
  auto mesh = std::make_unique<PiercedMesh>(input, further, part(0.0, 0.1));
  const bool mayAddPoints = tolerance > 0.0;
  const bool cuts = mayAddPoints && CrossesItselfOften(input);
  const bool refines = cuts && IsOftenFlat(*mesh);
  KeptDistances kept = {};
  if (!refines)
  {
    // Where triangles cross each other, recovery meets few, and cutting follows.
    Recover(*mesh, { steps(cuts ? 100 : 300), mayAddPoints }, part(0.1, 0.2));
    if (cuts)
    {
      constexpr double rounding = 1e-12; // of the length: some thousand times that of a coordinate
      Cut(*mesh, rounding * length, { MaximumCuts, most }, part(0.2, 0.7));
      HalveKept(*mesh, distance, bound, most, part(0.7, 0.8));
      // A few more points take most of the surface much closer.
      constexpr double closer = 0.1;
      HalveKept(*mesh, distance, closer * bound, input.Points.size() / 10 + 10000, part(0.8, 0.9));
    }
    kept = MeasureKept(*mesh, distance, negligible * length, length);
  }
  if (refines || (mayAddPoints && kept.Maximum > tolerance * length))
  {
    if (!refines)
    {
      // Points can be put anywhere only as long as the mesh is Delaunay.
      mesh = std::make_unique<PiercedMesh>(input, further, part(0.9, 0.91));
    }
    Refine(*mesh, distance, bound, most, part(0.91, 0.95));
    RecoveryLimits limits = { steps(1000), true };
    limits.MayExist = [&](const Cell& cell)
    { return IsExposedWithin(cell, *mesh, distance, bound); };
    Recover(*mesh, limits, part(0.95, 1.0));
    kept = MeasureKept(*mesh, distance, negligible * length, length);
  }
  result = {};
  result.Surface.PointSources = input.PointSources;
  WriteCells(*mesh, result);
  result.Kept.resize(result.Cells.size());
  for (const Cell cell : mesh->GetDelaunay().finite_cell_handles())
  {
    result.Kept[cell->info().Index] = cell->info().IsPierced();
  }
  WriteFaces(*mesh, input, result);
  result.Unresolved = input;
  result.MetShares.resize(input.Facets.size());
  return { kept, MeasureMetShares(*mesh, result.MetShares) };
}

} // namespace carving::helper
