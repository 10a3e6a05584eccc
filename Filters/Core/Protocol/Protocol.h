// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a host and the helper program say to each other.
 *
 * The host writes a Job to the helper's standard input and reads a Reply from its standard output,
 * both binary. On standard error the helper writes one line per report of progress (see
 * ProgressLine); every other line there is a diagnostic for the user's eyes.
 */
#ifndef carving_Protocol_h
#define carving_Protocol_h

#include "Core/Mesh/Mesh.h"
#include "Core/Solid/Classification.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace carving
{

enum class JobKind : int
{
  /** Clean, resolve and tetrahedralize the mesh: everything in the reply is filled. */
  Tetrahedralize = 1,
  /** Clean the mesh and count its intersecting pairs: only these are filled. */
  CountIntersections = 2,
  /** Resolve and triangulate the contours: `Plane` of the reply is filled instead of `Result`. */
  Triangulate = 3
};

/** What bounds the tetrahedra (section 3.1). */
enum class InitialApproximation : int
{
  ConvexHull = 0,
  /** The bounding box, grown by BoxMargin of its diagonal on every side. */
  BoundingBox = 1,
  /** A closed mesh of genus zero (a simple polygon) that encloses M, given with the job. */
  Custom = 2
};
constexpr double BoxMargin = 0.01;

/** Whether M has to be a union of faces of tetrahedra. */
enum class Conformity : int
{
  Exact = 0,     ///< yes, or it is an error
  Enclosing = 1, ///< no: tetrahedra that M pierces are kept
  Auto = 2       ///< where it can be done
};

/** What the user can set of the helper's work. */
struct HelperOptions
{
  InitialApproximation Initial = InitialApproximation::ConvexHull;
  carving::Conformity Conformity = carving::Conformity::Exact;
  /** How far what is kept may reach from M, a share of the diagonal of M's bounds; 0: any distance. */
  double EnclosingTolerance = 0.02;
  /** How far points may be moved where nothing else is exact, a share of the same; 0: not at all. */
  double SnapTolerance = 0.0;
  double TimeLimit = 0.0;   ///< seconds of one attempt; 0: none
  double MemoryLimit = 0.0; ///< MiB of one attempt; 0: none

  bool operator==(const HelperOptions& other) const
  {
    return this->Initial == other.Initial && this->Conformity == other.Conformity &&
      this->EnclosingTolerance == other.EnclosingTolerance &&
      this->SnapTolerance == other.SnapTolerance && this->TimeLimit == other.TimeLimit &&
      this->MemoryLimit == other.MemoryLimit;
  }
};

struct Job : HelperOptions
{
  JobKind Kind = JobKind::Tetrahedralize;
  /** Where TetGen does not cope with M, what has solid on both sides may be left out. */
  SolidRule Solid = SolidRule::SurfaceOnly;
  TriangleMesh Mesh;
  TriangleMesh InitialMesh;   ///< for InitialApproximation::Custom
  ContourSet Contours;        ///< for JobKind::Triangulate
  ContourSet InitialContours; ///< for JobKind::Triangulate and InitialApproximation::Custom
};

/** A stage of the helper's work, in the order of execution. */
enum class Stage : int
{
  Clean,
  Resolve,
  Tetrahedralize
};
constexpr int NumberOfStages = 3;
const char* StageName(Stage stage);

struct Reply
{
  /** Empty if the job succeeded; else what went wrong, for the user, and the rest is unspecified. */
  std::string Error;
  Tetrahedralization Result;
  Decomposition<2> Plane;
  std::string Strategy;      ///< how it was tetrahedralized
  std::string Attempts;      ///< what was tried before, and why it failed, a line each
  std::string Limits;        ///< limits that ended one of these, a line each
  double KeptDistance = 0.0; ///< in enclosing mode: how far what is kept reaches from M, to 5 %
  int PointsAdded = 0;       ///< for that
  int InteriorDropped = 0;   ///< triangles with solid on both sides that were left out
  int SolidMatters = 0; ///< not 0: by another rule of what is solid it may come out differently
  double SnapDistance = 0.0; ///< how far a point of M has been moved at most, by snapping
  /** Pairs of triangles that met other than in a shared vertex or edge after cleaning. */
  int IntersectingPairs = 0;
  /** Wall-clock seconds, one entry per stage. */
  std::vector<double> StageSeconds;
};

/** Write to a binary stream; the stream's state tells whether all went well. */
void Write(std::ostream& out, const Job& job);
void Write(std::ostream& out, const Reply& reply);

/**
 * Read what Write wrote. Return an empty string, or what is wrong with the data: a foreign format,
 * another version, an early end, or numbers that cannot be (an index out of range, say). All that
 * the other parts of the core rely on holds for what has been read.
 */
std::string Read(const char* data, std::size_t size, Job& job);
std::string Read(const char* data, std::size_t size, Reply& reply);

/** The line that reports that a fraction of a stage is done; ParseProgress is its inverse. */
std::string ProgressLine(Stage stage, double fraction);
bool ParseProgress(const std::string& line, Stage& stage, double& fraction);

} // namespace carving

#endif
