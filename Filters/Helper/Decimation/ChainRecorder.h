// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Keeps the history of a surface of which edges collapse.
 */
#ifndef carving_ChainRecorder_h
#define carving_ChainRecorder_h

#include "Core/Stream/CollapseChain.h"
#include "Helper/Decimation/SurfaceMesh.h"

#include <deque>
#include <vector>

namespace carving::helper
{

/**
 * Records the collapses of a surface's edges as a chain. Moves of vertices count with the last
 * collapse.
 */
class ChainRecorder
{
public:
  explicit ChainRecorder(const SurfaceMesh& surface);

  /**
   * Adds a collapse that has just taken place. `kept` is the vertex that remains, `removed` the
   * other end of the edge, and `faces` are all faces around both ends.
   */
  void AddCollapse(
    const SurfaceMesh& surface, Vertex kept, Vertex removed, const std::vector<Face>& faces);

  /** Adds that a vertex has just moved. `faces` are all faces around this vertex. */
  void AddMove(const SurfaceMesh& surface, Vertex vertex, const std::vector<Face>& faces);

  /**
   * Adds that a vertex has just moved back to a point of the chain. This counts with the next
   * collapse, which has to follow.
   */
  void AddMoveBack(
    const SurfaceMesh& surface, Vertex vertex, int point, const std::vector<Face>& faces);

  /** The point of the chain at which a vertex is now. */
  int GetPoint(Vertex vertex) const
  {
    return this->PointOfVertex[vertex];
  }

  int GetNumberOfCollapses() const
  {
    return this->Chain.Collapses;
  }

  /** Hands over the history. The source of a face is its index in the surface. */
  void Take(CollapseChain& chain, std::vector<Point>& points) &&;

private:
  void ReplaceAll(const SurfaceMesh& surface, const std::vector<Face>& faces, int collapses);
  void Replace(ChainFace& face, const Triangle& corners, int collapses);
  Triangle CornersNow(const SurfaceMesh& surface, Face face) const;

  CollapseChain Chain;            ///< without faces
  std::deque<ChainFace> Past;     ///< the faces that no longer exist; most of the memory
  std::vector<Point> Points;      ///< of the chain
  std::vector<int> PointOfVertex; ///< per vertex of the surface: its point of the chain
  std::vector<ChainFace> Now;     ///< per face of the surface: as it is now, or without corners
};

} // namespace carving::helper

#endif
