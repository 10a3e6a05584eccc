// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Protocol/Protocol.h"

#include "Core/Mesh/Validity.h"
#include "Core/Protocol/Archive.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace carving
{
namespace
{

// Change the last character whenever the layout changes: host and helper must be of the same build.
constexpr char JobMagic[8] = { 'C', 'A', 'R', 'V', 'J', 'O', 'B', 'G' };
constexpr char ReplyMagic[8] = { 'C', 'A', 'R', 'V', 'R', 'E', 'P', 'D' };

/** Visits the fields of a job in order. An archive is an ArchiveWriter or an ArchiveReader. */
template <class Archive, class JobType>
void VisitJob(Archive& archive, JobType& job)
{
  archive.Value(job.Kind);
  archive.Value(job.Solid);
  archive.Value(job.DropSolid);
  archive.Value(job.Initial);
  archive.Value(job.Conformity);
  archive.Value(job.Strategy);
  archive.Value(job.EnclosingTolerance);
  archive.Value(job.SnapTolerance);
  archive.Value(job.TimeLimit);
  archive.Value(job.MemoryLimit);
  archive.Value(job.Processes);
  archive.Array(job.Mesh.Points);
  archive.Array(job.Mesh.Triangles);
  archive.Array(job.InitialMesh.Points);
  archive.Array(job.InitialMesh.Triangles);
  archive.Array(job.Contours.Points);
  archive.Array(job.Contours.Edges);
  archive.Array(job.InitialContours.Points);
  archive.Array(job.InitialContours.Edges);
  archive.Array(job.Surface.Points);
  archive.Array(job.Surface.Triangles);
  archive.Array(job.Parts.Points);
  archive.Array(job.Parts.Triangles);
  archive.Value(job.Decimation.Type);
  archive.Array(job.Decimation.Targets);
  archive.Array(job.Decimation.Bounds);
  archive.Value(job.Decimation.GivesUp);
  archive.Value(job.Decimation.Nested);
}

template <class Archive, class Input>
void VisitInput(Archive& archive, Input& input)
{
  archive.Array(input.Points);
  archive.Array(input.PointSources);
  archive.Array(input.Facets);
  archive.Array(input.FacetSources);
  archive.Array(input.SignedMultiplicities);
  archive.Array(input.Multiplicities);
}

template <class Archive, class Mesh>
void VisitDecomposition(Archive& archive, Mesh& mesh)
{
  VisitInput(archive, mesh.Surface);
  archive.Array(mesh.Cells);
  archive.Array(mesh.Neighbors);
  archive.Value(mesh.Constraints.NumberOfCells);
  archive.Array(mesh.Constraints.Blocks);
  archive.Array(mesh.Constraints.OfFaces);
  archive.Array(mesh.Kept);
  VisitInput(archive, mesh.Unresolved);
  archive.Array(mesh.MetShares);
}

template <class Archive, class DecimationType>
void VisitDecimation(Archive& archive, DecimationType& decimation)
{
  archive.Value(decimation.Chain.Vertices);
  archive.Value(decimation.Chain.Triangles);
  archive.Value(decimation.Chain.Collapses);
  archive.Array(decimation.Chain.Faces);
  archive.Array(decimation.Points);
  archive.Array(decimation.PointSources);
  archive.Array(decimation.Surfaces);
}

/** Visits the fields of a reply in order. */
template <class Archive, class ReplyType>
void VisitReply(Archive& archive, ReplyType& reply)
{
  archive.Array(reply.Error);
  VisitDecomposition(archive, reply.Result);
  archive.Array(reply.Regions.RegionOfCell);
  archive.Array(reply.Regions.Regions);
  archive.Array(reply.Regions.SolidRegions);
  VisitDecomposition(archive, reply.Plane);
  VisitDecimation(archive, reply.Decimation);
  archive.Array(reply.Strategy);
  archive.Array(reply.Attempts);
  archive.Array(reply.Limits);
  archive.Value(reply.KeptDistance);
  archive.Value(reply.KeptDistance99);
  archive.Value(reply.KeptDistanceMean);
  archive.Value(reply.MetShare);
  archive.Value(reply.PointsAdded);
  archive.Value(reply.InteriorDropped);
  archive.Value(reply.CracksSealed);
  archive.Value(reply.CracksOpen);
  archive.Value(reply.SolidMatters);
  archive.Value(reply.SnapDistance);
  archive.Value(reply.IntersectingPairs);
  archive.Array(reply.StageSeconds);
}

/** Returns an empty string, or the first mistake in the regions of a mesh without its solid. */
std::string FindMistake(const Classification& regions, const Tetrahedralization& mesh)
{
  if (regions.SolidRegions.empty())
  {
    return regions.RegionOfCell.empty() && regions.Regions.empty() ? "" : "regions are incomplete";
  }
  if (regions.RegionOfCell.size() != mesh.Cells.size() || !mesh.Kept.empty())
  {
    return "regions do not fit the tetrahedra";
  }
  const std::size_t count = regions.Regions.size();
  const bool within =
    IndicesWithin(regions.SolidRegions, -1, count) && IndicesWithin(regions.RegionOfCell, 0, count);
  return within ? "" : "a region index is out of range";
}

/** Returns an empty string, or the first mistake. */
std::string FindMistake(const Decimation& decimation)
{
  const auto fits = [&](const DecimatedSurface& surface)
  { return surface.Collapses >= 0 && surface.Collapses <= decimation.Chain.Collapses; };
  if (decimation.PointSources.size() != decimation.Points.size() ||
    !std::all_of(decimation.Surfaces.begin(), decimation.Surfaces.end(), fits))
  {
    return "a decimated surface has indices out of range";
  }
  if (!AreFinite(decimation.Points))
  {
    return "a decimated surface has a coordinate that is not finite";
  }
  return FindMistake(decimation.Chain, decimation.Points.size());
}

/** Fractions of a stage are integers in text: how a decimal point is read depends on the locale. */
constexpr double ProgressParts = 10000.0;

} // namespace

const char* StageName(Stage stage)
{
  static constexpr const char* names[NumberOfStages] = { "clean", "resolve", "attempts",
    "tetrahedralize", "classify" };
  return names[static_cast<int>(stage)];
}

void Write(std::ostream& out, const Job& job)
{
  ArchiveWriter writer(out, JobMagic);
  VisitJob(writer, job);
}

std::string Read(const char* data, std::size_t size, Job& job)
{
  ArchiveReader reader(data, size);
  if (!reader.Magic(JobMagic))
  {
    return "this is not a job of this version of the program";
  }
  VisitJob(reader, job);
  if (!reader.Complete())
  {
    return "the job is incomplete";
  }
  if (job.Kind != JobKind::Tetrahedralize && job.Kind != JobKind::CountIntersections &&
    job.Kind != JobKind::Triangulate && job.Kind != JobKind::Decimate)
  {
    return "the job is of an unknown kind";
  }
  if (job.Initial != InitialApproximation::ConvexHull &&
    job.Initial != InitialApproximation::BoundingBox && job.Initial != InitialApproximation::Custom)
  {
    return "the job wants an unknown initial approximation";
  }
  if (job.Conformity != Conformity::Exact && job.Conformity != Conformity::Enclosing &&
    job.Conformity != Conformity::Auto)
  {
    return "the job wants an unknown conformity";
  }
  if (job.Strategy != Strategy::TetGen && job.Strategy != Strategy::Recover &&
    job.Strategy != Strategy::Auto)
  {
    return "the job wants an unknown strategy";
  }
  if (job.Solid != SolidRule::NonzeroWinding && job.Solid != SolidRule::EvenOdd &&
    job.Solid != SolidRule::SurfaceOnly)
  {
    return "the job wants an unknown rule of what is solid";
  }
  if (job.Decimation.Type != DecimationTarget::Vertices &&
    job.Decimation.Type != DecimationTarget::Triangles &&
    job.Decimation.Type != DecimationTarget::ErrorBound)
  {
    return "the job wants an unknown kind of target";
  }
  if (!job.Decimation.Bounds.empty() &&
    job.Decimation.Bounds.size() != job.Decimation.Targets.size())
  {
    return "the job has bounds for some of its targets only";
  }
  if (!IndicesWithin(job.Mesh.Triangles, 0, job.Mesh.Points.size()) ||
    !IndicesWithin(job.InitialMesh.Triangles, 0, job.InitialMesh.Points.size()) ||
    !IndicesWithin(job.Surface.Triangles, 0, job.Surface.Points.size()) ||
    !IndicesWithin(job.Parts.Triangles, 0, job.Parts.Points.size()) ||
    !IndicesWithin(job.Contours.Edges, 0, job.Contours.Points.size()) ||
    !IndicesWithin(job.InitialContours.Edges, 0, job.InitialContours.Points.size()))
  {
    return "the job has a triangle or an edge with a vertex index out of range";
  }
  return {};
}

void Write(std::ostream& out, const Reply& reply)
{
  ArchiveWriter writer(out, ReplyMagic);
  VisitReply(writer, reply);
}

std::string Read(const char* data, std::size_t size, Reply& reply, int threads)
{
  ArchiveReader reader(data, size);
  if (!reader.Magic(ReplyMagic))
  {
    return "this is not a reply of this version of the helper program";
  }
  VisitReply(reader, reply);
  if (!reader.Complete() || reply.StageSeconds.size() != NumberOfStages)
  {
    return "the reply is incomplete";
  }
  std::string mistake = FindMistake(reply.Decimation);
  mistake =
    mistake.empty() ? FindMistake(reply.Result, reply.Regions.SolidRegions, threads) : mistake;
  mistake = mistake.empty() ? FindMistake(reply.Regions, reply.Result) : mistake;
  return mistake.empty() ? FindMistake(reply.Plane) : mistake;
}

Sources CountSources(const Job& job)
{
  const bool isOfSurface = job.Kind == JobKind::Decimate && !job.Surface.Triangles.empty();
  const TriangleMesh& mesh = isOfSurface ? job.Surface : job.Mesh;
  return { mesh.Points.size() + job.Contours.Points.size(),
    mesh.Triangles.size() + job.Contours.Edges.size() };
}

std::string FindForeignSource(const Reply& reply, const Sources& sources)
{
  const auto within = [&sources](const auto& input)
  {
    return IndicesWithin(input.PointSources, -1, sources.Points) &&
      IndicesWithin(input.FacetSources, -1, sources.Facets);
  };
  const std::vector<ChainFace>& faces = reply.Decimation.Chain.Faces;
  const bool areWithin = within(reply.Result.Surface) && within(reply.Result.Unresolved) &&
    within(reply.Plane.Surface) &&
    IndicesWithin(reply.Decimation.PointSources, -1, sources.Points) &&
    std::all_of(faces.begin(), faces.end(),
      [&sources](const ChainFace& face)
      { return face.Source >= 0 && static_cast<std::size_t>(face.Source) < sources.Facets; });
  return areWithin ? "" : "it refers to parts of the mesh that do not exist";
}

std::string ProgressLine(const WorkProgress& progress)
{
  return "@progress " + std::to_string(static_cast<int>(progress.Stage)) + ' ' +
    std::to_string(std::lround(ProgressParts * progress.Fraction)) + ' ' + progress.Attempt + '\n';
}

bool ParseProgress(const std::string& line, WorkProgress& progress)
{
  int stage = -1, parts = 0, length = 0;
  if (std::sscanf(line.c_str(), "@progress %d %d%n", &stage, &parts, &length) != 2 || stage < 0 ||
    stage >= NumberOfStages)
  {
    return false;
  }
  const std::size_t attempt = line.find_first_not_of(' ', length);
  progress = { static_cast<Stage>(stage), parts / ProgressParts,
    attempt == std::string::npos ? "" : line.substr(attempt) };
  return true;
}

} // namespace carving
