// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/EnclosingDecimation.h"

#include "Core/Mesh/FaceDistance.h"
#include "Helper/Base/Kernels.h"
#include "Helper/Decimation/ClosedSurface.h"
#include "Helper/Decimation/Decimator.h"
#include "Helper/Decimation/TargetSeries.h"
#include "Helper/Resolve/Clean.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace carving::helper
{
namespace
{

bool HasFlatTriangle(const ResolvedMesh& mesh)
{
  return std::any_of(mesh.Facets.begin(), mesh.Facets.end(),
    [&](const Triangle& t)
    {
      return CGAL::collinear(
        ToInexact(mesh.Points[t[0]]), ToInexact(mesh.Points[t[1]]), ToInexact(mesh.Points[t[2]]));
    });
}

/** Takes the surface as given if it is closed, and else with equal points merged. */
std::string Prepare(const TriangleMesh& given, ResolvedMesh& surface)
{
  surface = AsResolved(given);
  if (!HasFlatTriangle(surface) && MakeClosedSurface(surface).empty())
  {
    return {};
  }
  surface = Clean(AsResolved(given));
  return MakeClosedSurface(surface);
}

/** A mesh together with the parts of its triangles, cleaned. */
ResolvedMesh JoinMeshes(const TriangleMesh& mesh, const TriangleMesh& parts)
{
  TriangleMesh all = mesh;
  const auto own = static_cast<int>(mesh.Points.size());
  all.Points.insert(all.Points.end(), parts.Points.begin(), parts.Points.end());
  for (const auto& [a, b, c] : parts.Triangles)
  {
    all.Triangles.push_back({ own + a, own + b, own + c });
  }
  return Clean(AsResolved(all));
}

/**
 * Lowers the measured errors of a surface that was M at first to known ones: without a collapse,
 * the surface is M itself, and no collapse exceeds its error bound. Measured distances below a
 * millionth of the diagonal are too large.
 */
void LowerErrors(const DecimationOptions& options, std::vector<DecimatedSurface>& results)
{
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    DecimatedSurface& result = results[i];
    const bool isBound = options.Type == DecimationTarget::ErrorBound;
    const double most = result.Collapses == 0 ? 0.0 : isBound ? options.Targets[i] : result.Error;
    result.Error = std::min(result.Error, most);
    result.Reached = result.Reached || isBound;
  }
}

/** Hands on the history in terms of the given surface. */
void HandOn(ChainRecorder history, const ResolvedMesh& original, Decimation& result)
{
  std::move(history).Take(result.Chain, result.Points);
  for (ChainFace& face : result.Chain.Faces)
  {
    face.Source = original.FacetSources[face.Source];
  }
  result.PointSources = original.PointSources;
  result.PointSources.resize(result.Points.size(), -1);
}

} // namespace

std::string DecimateEnclosing(const TriangleMesh& given, const TriangleMesh& mesh,
  const TriangleMesh& parts, const DecimationOptions& options, Decimation& result,
  const Progress& progress, int threads)
{
  ResolvedMesh original;
  std::string mistake = Prepare(given, original);
  if (!mistake.empty())
  {
    return mistake;
  }
  const bool isOfUser = &given == &mesh; // and no level of a stream
  if (isOfUser)
  {
    TurnPartsOutward(original);
  }
  std::optional<ChainRecorder> history; // the chain is made when all else has been released
  {
    const ResolvedMesh cleaned = Clean(AsResolved(mesh));
    if (cleaned.Facets.empty())
    {
      return "The surface has no triangle with an area.";
    }
    const FaceDistance<3> fromM(cleaned);
    const ResolvedMesh divided = parts.Triangles.empty() ? ResolvedMesh() : JoinMeshes(mesh, parts);
    std::optional<FacetTree<3>> divisions;
    if (!divided.Facets.empty())
    {
      divisions.emplace(divided);
    }
    std::optional<FaceDistance<3>> fromGiven;
    if (!isOfUser)
    {
      fromGiven.emplace(original);
    }
    Decimator decimator(AsSurfaceMesh(original), divisions ? *divisions : fromM.GetTree(), fromM,
      fromGiven ? *fromGiven : fromM, options.Nested);
    mistake = DecimateToTargets(decimator, fromM, options, progress, threads, result.Surfaces);
    if (!mistake.empty())
    {
      return mistake;
    }
    if (isOfUser)
    {
      LowerErrors(options, result.Surfaces);
    }
    history = std::move(decimator).TakeHistory();
  }
  HandOn(*std::move(history), original, result);
  GoOn(progress, 1.0);
  return {};
}

} // namespace carving::helper
