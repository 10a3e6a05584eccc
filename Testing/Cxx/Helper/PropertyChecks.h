// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The properties that must hold for every stream.
 */
#ifndef PropertyChecks_h
#define PropertyChecks_h

#include "Core/Carving/Carver.h"
#include "Core/Measure/Profile.h"
#include "Core/Solid/Classification.h"
#include "Core/Stream/Level.h"
#include "Core/Stream/StoredStream.h"

#include <random>

struct Carved
{
  carving::Tetrahedralization Mesh;
  carving::Classification Regions;
  carving::Stream Stream;
  carving::StoredStream<3> Stored;
  carving::Profile Profile;
};

Carved CarveResult(const carving::Tetrahedralization& mesh,
  const carving::CarveOptions& options = {},
  carving::SolidRule rule = carving::SolidRule::NonzeroWinding);

/** The part of a level that bounds a volume: all faces except the folds. */
std::vector<carving::Triangle> Shell(const carving::Level<3>& level);
std::vector<carving::Triangle> AllTriangles(const carving::Level<3>& level);

/**
 * Expects that the profile has the Betti numbers that the ranks of boundary matrices give (property
 * 6).
 */
void ExpectTopology(const Carved& carved, int step);

/**
 * Expects, at some steps of the stream:
 * 1. Every level contains M. The volume and the silhouettes never grow.
 * 2. The number of input vertices, the components and the voids never decrease. The first level is
 *    C0, and the last is M.
 * 3. Level vertices are input vertices, bit for bit.
 * 4. Levels cut into manifolds are oriented manifolds, closed wherever they bound a solid.
 * 5. No level intersects itself.
 * 6. The profile has the Betti numbers of the closed complex: at one step, drawn at random.
 */
void ExpectProperties(
  const carving::TriangleMesh& given, const Carved& carved, int numberOfLevels, int samples);

/**
 * Expects that the last level of closed solids encloses the points that are solid by the rule,
 * among random points around and inside the given mesh.
 */
void ExpectSolid(const carving::TriangleMesh& given, const Carved& carved, carving::SolidRule rule,
  std::mt19937_64& random);

#endif
