// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Fills a cavity with tetrahedra.
 */
#ifndef carving_Filling_h
#define carving_Filling_h

#include "Helper/Enclosing/Pierce.h"

#include <unordered_map>
#include <vector>

namespace carving::helper
{

/** Larger cavities are not searched: the time of a search grows fast with the vertices. */
constexpr std::size_t MaximumCavityVertices = 48;

/** A part of space that has been emptied, to be filled with tetrahedra between its points. */
struct Cavity
{
  std::vector<Inexact::Point_3> Points;
  /** Per point: whether it is a vertex of the mesh, and some tetrahedron has to have it. */
  std::vector<char> Required;
  /**
   * The faces that border the cavity, and both sides of every face that has to be inside. The
   * tetrahedron that belongs at a face is on the side from which the corners are clockwise.
   */
  std::vector<Triangle> Front;
  /**
   * The point that stands for infinity, beyond a flat part of the hull; -1: none. A tetrahedron
   * there has its other corners among the points that are marked `InPlane`.
   */
  int Infinite = -1;
  /** Two points that have to be corners of one tetrahedron; -1: none. */
  std::array<int, 2> Edge = { -1, -1 };
  std::vector<char> InPlane;

  void AddPoint(const Inexact::Point_3& p, bool isRequired, bool isInPlane)
  {
    this->Points.push_back(p);
    this->Required.push_back(isRequired);
    this->InPlane.push_back(isInPlane);
  }
};

/**
 * Searches by backtracking, in a limited number of steps. The search places a tetrahedron at the
 * face of the front for which there are the fewest candidates.
 *
 * All tetrahedra are oriented positively, and every face that is not on the front belongs to two of
 * them. They therefore cover every point of the cavity exactly once, whatever the search omits to
 * compare.
 */
class Filling
{
public:
  using Tetrahedron = std::array<int, 4>;

  explicit Filling(const Cavity& cavity);

  /**
   * Returns whether the cavity has been filled. A step is a comparison of a triangle or a point
   * with a tetrahedron; the number of steps taken is subtracted from `steps`.
   */
  bool Run(std::ptrdiff_t& steps);

  /** Per face of the front, whether a point and the face make a tetrahedron that is not blocked. */
  std::vector<char> FindVisible(int point);

  /** The tetrahedra, oriented positively. */
  const std::vector<Tetrahedron>& GetCells() const
  {
    return this->Cells;
  }

private:
  struct Face
  {
    Triangle Corners;
    Piercer Shape;
  };
  /** A face of the front that no tetrahedron fills yet. */
  struct OpenFace
  {
    int Index;
    std::vector<int> Apexes; ///< of the candidates, the most promising first
  };
  using Front = std::vector<OpenFace>;

  bool Place(const Front& front, std::ptrdiff_t& steps);
  bool PlaceAt(const Front& front, const OpenFace& face, int apex, std::ptrdiff_t& steps);
  bool PlaceAtEdge(const Front& front, std::ptrdiff_t& steps);
  bool Close(
    const Front& front, const OpenFace& face, int apex, Front& rest, std::vector<int>& made);
  void KeepApart(const std::vector<int>& made, Front& front, std::ptrdiff_t& steps) const;
  void Open(const std::vector<int>& made, Front& front, std::ptrdiff_t& steps);
  void FindApexes(OpenFace& face, const Front& front, std::ptrdiff_t& steps);
  void SortApexes(OpenFace& face) const;
  bool IsCandidate(const Triangle& face, int apex, std::ptrdiff_t& steps);
  bool IsFree(const Tetrahedron& cell, std::ptrdiff_t& steps) const;
  bool IsClear(const Tetrahedron& cell, const Face& face) const;
  bool AllRequiredUsed() const;
  int AddFace(const Triangle& corners);
  Corners4 CornersOf(const Tetrahedron& cell) const;

  const Cavity& Space;
  std::vector<Face> Faces; ///< first those of the given front
  std::vector<Tetrahedron> Cells;
  std::unordered_map<std::uint64_t, bool> Known; ///< by corners: whether a tetrahedron is free
};

} // namespace carving::helper

#endif
