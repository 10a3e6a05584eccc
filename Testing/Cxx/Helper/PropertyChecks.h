// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What must hold for every stream.
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

/** The profile has the Betti numbers that the ranks of boundary matrices give (property 6). */
void ExpectTopology(const Carved& carved, int step);

/** Properties 1 to 5, on some steps of the stream, and property 6 on one of all, drawn at random. */
void ExpectProperties(
  const carving::TriangleMesh& given, const Carved& carved, int numberOfLevels, int samples);

/**
 * What the last level of closed solids bounds is what the rule says to be solid of the given mesh, at
 * random points around and within it.
 */
void ExpectSolid(const carving::TriangleMesh& given, const Carved& carved, carving::SolidRule rule,
  std::mt19937_64& random);

#endif
