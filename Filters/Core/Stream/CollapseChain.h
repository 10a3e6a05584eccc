// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A surface with the edge collapses that decimate it, one after the other. Not in the paper.
 */
#ifndef carving_CollapseChain_h
#define carving_CollapseChain_h

#include "Core/Mesh/Mesh.h"

#include <string>
#include <vector>

namespace carving
{

/** A triangle of a chain, unchanged after j collapses for Birth <= j < Death. */
struct ChainFace
{
  Triangle Corners; ///< points of the chain, oriented outward
  int Source;       ///< the triangle of the given surface that it has been
  int Birth;
  int Death;
};

/**
 * The collapses that decimate a closed surface. The chain's points are the vertices of the surface,
 * followed by the points that collapses make. Every collapse removes a vertex and two triangles.
 */
struct CollapseChain
{
  int Vertices = 0;  ///< of the surface without a collapse
  int Triangles = 0; ///< likewise
  int Collapses = 0;
  std::vector<ChainFace> Faces;
};

/** The surface after a number of collapses. */
struct CollapsedSurface
{
  std::vector<Triangle> Triangles; ///< corners are indices into `Points`
  std::vector<int> Points;         ///< per vertex: the point of the chain; ascending
  std::vector<int> Sources;        ///< per triangle: ChainFace::Source
};

/** Linear in the number of the chain's faces, where 0 <= collapses <= chain.Collapses. */
CollapsedSurface ExtractSurface(const CollapseChain& chain, int collapses);

/**
 * Returns an empty string if every number of collapses gives the right number of triangles, with
 * corners among `points` points; otherwise the first mistake.
 */
std::string FindMistake(const CollapseChain& chain, std::size_t points);

} // namespace carving

#endif
