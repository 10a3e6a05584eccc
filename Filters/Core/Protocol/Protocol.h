// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The messages between a host and the helper program.
 *
 * The host writes a Job and reads a Reply, both binary. On Linux, these are the helper's standard
 * input and output; elsewhere, they are files. On standard error, the helper writes a line per
 * progress report (ProgressLine). Any other line there is a diagnostic for the user.
 */
#ifndef carving_Protocol_h
#define carving_Protocol_h

#include "Core/Mesh/Mesh.h"
#include "Core/Solid/Classification.h"
#include "Core/Stream/CollapseChain.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace carving
{

enum class JobKind : int
{
  /** Clean, resolve and tetrahedralize the mesh. Sets all of the reply except `Plane`. */
  Tetrahedralize = 1,
  /** Clean the mesh and count its intersecting pairs. Sets `IntersectingPairs` only. */
  CountIntersections = 2,
  /** Resolve and triangulate the contours. Sets `Plane` of the reply instead of `Result`. */
  Triangulate = 3,
  /**
   * Decimate `Surface`, or the mesh itself, into surfaces that enclose the mesh. Sets `Decimation`
   * only.
   */
  Decimate = 4
};

/** The quantity that a target of a decimation limits. */
enum class DecimationTarget : int
{
  Vertices = 0,
  Triangles = 1,
  ErrorBound = 2 ///< the distance from the mesh, a length
};

/** The error if no triangle has an area. */
constexpr const char* NothingToCarve =
  "No triangle of the mesh has an area: there is nothing to carve.";

/** The options of JobKind::Decimate. */
struct DecimationOptions
{
  /** Decimating a surface of so few vertices takes about a second, so that more steps are tried. */
  static constexpr int FewVertices = 5000;
  /**
   * A surface of more vertices is close to the mesh. Measuring distances and moving vertices after
   * the collapses are not worth the time.
   */
  static constexpr int ManyVertices = 30000;

  DecimationTarget Type = DecimationTarget::Vertices;
  /** From the finest to the coarsest: numbers that fall, or error bounds that rise. */
  std::vector<double> Targets;
  /**
   * Per number, the largest distance from the mesh that a new face may have, but no less than for
   * the numbers before, since all surfaces are one series of collapses. Empty: no bounds. A search
   * from below finds the least bound that leads to the number. A number is given up where there is
   * no hope for it.
   */
  std::vector<double> Bounds;
  /**
   * Gives up a number that is far from reach: no edge collapses well, and so few collapse otherwise
   * that the rest of the way would take more than ten attempts per vertex.
   */
  int GivesUp = 0;
  /** Each result lies inside all coarser ones. Otherwise results are tighter. */
  int Nested = 0;
};

/** A result of JobKind::Decimate, which belongs to a target. */
struct DecimatedSurface
{
  int Collapses = 0;
  /** 0 if the target is missed: no further edge could collapse, or the given surface is too far. */
  int Reached = 1;
  /** The largest distance from the enclosed mesh; at most 1 % too large, or more above slivers. */
  double Error = 0.0;
};

/** The results of JobKind::Decimate. */
struct Decimation
{
  CollapseChain Chain; ///< the source of a face: the triangle of the given surface
  std::vector<Point> Points;
  std::vector<int> PointSources; ///< per point: that of the given surface at this position, or -1
  std::vector<DecimatedSurface> Surfaces; ///< per target
};

/** The initial approximation C0 (section 3.1). */
enum class InitialApproximation : int
{
  ConvexHull = 0,
  /** The bounding box, grown by a hundredth of its diagonal on every side. */
  BoundingBox = 1,
  /**
   * A closed mesh of genus zero (in the plane, a simple polygon) that encloses M, given with the
   * job.
   */
  Custom = 2
};

/** Whether M has to be a union of faces of tetrahedra. Enclosing is not in the paper. */
enum class Conformity : int
{
  Exact = 0,     ///< yes; otherwise the job fails
  Enclosing = 1, ///< no: tetrahedra that M pierces are kept
  Auto = 2       ///< yes if possible, else Enclosing
};

/** How the triangles of M become faces of tetrahedra, where they are to. */
enum class Strategy : int
{
  TetGen = 0,  ///< by TetGen
  Recover = 1, ///< by recovery in a Delaunay tetrahedralization. Not in the paper.
  Auto = 2     ///< by the one that takes less time, and then by the other
};

/** The user's options of the helper's work. */
struct HelperOptions
{
  InitialApproximation Initial = InitialApproximation::ConvexHull;
  carving::Conformity Conformity = carving::Conformity::Exact;
  carving::Strategy Strategy = carving::Strategy::Auto;
  /**
   * The largest distance of kept tetrahedra from M, as a fraction of the diagonal of M's bounds; 0:
   * unlimited.
   */
  double EnclosingTolerance = 0.02;
  /**
   * The largest displacement of points if no other exact strategy works, as the same fraction; 0:
   * none.
   */
  double SnapTolerance = 0.0;
  double TimeLimit = 0.0;   ///< seconds of one attempt; 0: a limit of processor time
  double MemoryLimit = 0.0; ///< MiB of one attempt; 0: none

  bool operator==(const HelperOptions& other) const
  {
    return this->Initial == other.Initial && this->Conformity == other.Conformity &&
      this->Strategy == other.Strategy && this->EnclosingTolerance == other.EnclosingTolerance &&
      this->SnapTolerance == other.SnapTolerance && this->TimeLimit == other.TimeLimit &&
      this->MemoryLimit == other.MemoryLimit;
  }
};

struct Job : HelperOptions
{
  JobKind Kind = JobKind::Tetrahedralize;
  int Processes = 1; ///< or threads that may work at a time; only seconds depend on it
  /** If TetGen fails with M, a strategy omits triangles with solid on both sides by this rule. */
  SolidRule Solid = SolidRule::SurfaceOnly;
  /** Nonzero: an exact result is classified by this rule, and has no tetrahedra of the solid. */
  int DropSolid = 0;
  TriangleMesh Mesh;
  TriangleMesh InitialMesh;     ///< for InitialApproximation::Custom
  ContourSet Contours;          ///< for JobKind::Triangulate
  ContourSet InitialContours;   ///< for JobKind::Triangulate and InitialApproximation::Custom
  TriangleMesh Surface;         ///< for JobKind::Decimate, around the mesh; empty: the mesh itself
  TriangleMesh Parts;           ///< for JobKind::Decimate: parts of the mesh, up to roundings
  DecimationOptions Decimation; ///< for JobKind::Decimate
};

/** A stage of the helper's work, in the order of execution. */
enum class Stage : int
{
  Clean,
  Resolve,
  Attempts, ///< those that failed, whatever they did
  Tetrahedralize,
  Classify
};
constexpr int NumberOfStages = 5;
const char* StageName(Stage stage);

/** How far the helper's work is. */
struct WorkProgress
{
  carving::Stage Stage = carving::Stage::Clean;
  double Fraction = 0.0; ///< of the stage
  std::string Attempt;   ///< the strategy that is being tried, if any
};

struct Reply
{
  /** Empty on success; otherwise a message for the user, and the rest is unspecified. */
  std::string Error;
  Tetrahedralization Result;
  Classification Regions; ///< of `Result`, if the solid has been dropped from it; else empty
  Decomposition<2> Plane;
  carving::Decimation Decimation;
  std::string Strategy;      ///< the strategy that succeeded
  std::string Attempts;      ///< a line per failed attempt, with the reason
  std::string Limits;        ///< a line per limit that ended an attempt
  double KeptDistance = 0.0; ///< in enclosing mode: the distance of kept tetrahedra from M, to 5 %
  double KeptDistance99 = 0.0;   ///< the distance of all but a hundredth of their surface
  double KeptDistanceMean = 0.0; ///< over their surface
  double MetShare = 1.0;         ///< in enclosing mode: the share of M's area that is faces
  int PointsAdded = 0;           ///< in enclosing mode: by refinement and recovery
  int InteriorDropped = 0;       ///< triangles with solid on both sides that were omitted
  int CracksSealed = 0;          ///< faces added to M to close its solid
  int CracksOpen = 0;            ///< nonzero if edges pass through cracks that nothing closes
  int SolidMatters = 0;          ///< nonzero if the result may depend on the solid rule
  double SnapDistance = 0.0;     ///< the largest displacement of a point of M by snapping
  /**
   * Pairs of triangles that intersected outside of shared vertices and edges after cleaning. In the
   * plane, points in the interior of edges at which other edges met them.
   */
  int IntersectingPairs = 0;
  /** Wall-clock seconds, one entry per stage. */
  std::vector<double> StageSeconds;
};

/** Writes to a binary stream, whose state tells whether that succeeded. */
void Write(std::ostream& out, const Job& job);
void Write(std::ostream& out, const Reply& reply);

/**
 * Reads the output of Write. Returns an empty string, or the mistake in the data: a foreign format,
 * another version, an early end, or an impossible number (an index out of range, say). Accepted
 * data satisfy all contracts that the other parts of the core rely on. The number of threads does
 * not change the result.
 */
std::string Read(const char* data, std::size_t size, Job& job);
std::string Read(const char* data, std::size_t size, Reply& reply, int threads = 1);

/** The numbers of points and facets to which the sources in a reply refer. */
struct Sources
{
  std::size_t Points = 0;
  std::size_t Facets = 0;
};

/** Of the mesh or the contours of a job: one of both is empty. */
Sources CountSources(const Job& job);

/** Returns an empty string, or that an accepted reply refers to what its job does not have. */
std::string FindForeignSource(const Reply& reply, const Sources& sources);

/** The line that reports progress, with its end, and the inverse, of a line without its end. */
std::string ProgressLine(const WorkProgress& progress);
bool ParseProgress(const std::string& line, WorkProgress& progress);

} // namespace carving

#endif
