// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs decimations and judges their results in exact arithmetic.
 */
#ifndef DecimationChecks_h
#define DecimationChecks_h

#include "Core/Mesh/Mesh.h"
#include "Core/Protocol/Protocol.h"

#include <random>
#include <vector>

/** A decimated surface on its own. */
struct DecimationResult
{
  carving::TriangleMesh Mesh;
  std::vector<int> PointSources;
  double Error;
  int Reached;
};

std::vector<DecimationResult> GetResults(const carving::Decimation& decimation);

carving::DecimationOptions OptionsFor(std::vector<double> targets, bool nested = false,
  carving::DecimationTarget type = carving::DecimationTarget::Vertices);

/** Decimates a surface that encloses itself alone. */
std::vector<DecimationResult> Decimate(
  const carving::TriangleMesh& mesh, const carving::DecimationOptions& options);
std::vector<DecimationResult> Decimate(const carving::TriangleMesh& mesh,
  std::vector<double> targets, bool nested = false,
  carving::DecimationTarget type = carving::DecimationTarget::Vertices);

carving::Point RandomPointOn(
  const carving::TriangleMesh& mesh, const carving::Triangle& t, std::mt19937_64& random);

/**
 * Expects that no point of a mesh is outside: all vertices, exactly, and points on all triangles.
 */
void ExpectToEnclose(
  const carving::TriangleMesh& outer, const carving::TriangleMesh& inner, std::mt19937_64& random);

/**
 * Expects a closed surface around a mesh with the Euler characteristic of the given surface. Of the
 * given surface, only the two sides of folds may lie on each other.
 */
void ExpectEnclosingSurface(const carving::TriangleMesh& given, const carving::TriangleMesh& mesh,
  const DecimationResult& result, std::mt19937_64& random);

/** The same for a surface that does not touch itself and is the mesh. */
void ExpectEnclosingSurface(
  const carving::TriangleMesh& given, const DecimationResult& result, std::mt19937_64& random);

#endif
