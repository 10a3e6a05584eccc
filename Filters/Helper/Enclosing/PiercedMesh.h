// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * A Delaunay tetrahedralization, and the parts of M that pierce its tetrahedra or lie on their
 * faces.
 */
#ifndef carving_PiercedMesh_h
#define carving_PiercedMesh_h

#include "Helper/Enclosing/Contacts.h"
#include "Helper/Enclosing/Subdivision.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <functional>
#include <optional>
#include <vector>

namespace carving::helper
{

class StarShape;
class StarSurface;

/** Parts and tetrahedra change together: every tetrahedron knows its contacts at any time. */
class PiercedMesh
{
public:
  struct VertexInfo
  {
    int Index = -1;
    unsigned LastWalk = 0; ///< the last walk that visited the vertex
    /** Of the plane of the last patch that asked. */
    struct
    {
      unsigned OfPatch = 0;
      int Which = 0;
    } Side;
  };
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<VertexInfo, Inexact>;
  using CellBase = CGAL::Triangulation_cell_base_with_info_3<CellContacts, Inexact,
    CGAL::Delaunay_triangulation_cell_base_3<Inexact>>;
  using Delaunay = CGAL::Delaunay_triangulation_3<Inexact,
    CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
  using Cell = Delaunay::Cell_handle;
  using Vertex = Delaunay::Vertex_handle;

  /**
   * From the points of `input`, which may cross itself, and `further` points; not all in one plane.
   * The mesh does not depend on `threads`.
   */
  PiercedMesh(const ResolvedMesh& input, const std::vector<Point>& further, int threads,
    const std::function<bool(double)>& progress);

  /** From the Delaunay tetrahedralization of the same points, which this object takes over. */
  PiercedMesh(Delaunay&& delaunay, const ResolvedMesh& input, const std::vector<Point>& further,
    int threads, const std::function<bool(double)>& progress);

  /** The Delaunay tetrahedralization of points. A vertex has the index of its point. */
  static Delaunay Tetrahedralize(
    const std::vector<Point>& points, const std::vector<Point>& further);

  /** Whether a part is a face. */
  bool IsFace(int part) const;

  /** Whether the part of a contact is a face of the cell, not only a piece of one. */
  bool IsOnWholeFace(const Cell& cell, const PartContact& contact) const;

  /** For each part, the number of tetrahedra that it pierces or of which it overlaps a face. */
  std::vector<int> CountCells() const;

  /** The parts that are no faces. */
  std::vector<int> FindMissing() const;

  /** The tetrahedra that a part pierces, or a face of which it overlaps in an area. */
  std::vector<Cell> FindCells(int part);

  /** The tetrahedra that the segment between two vertices crosses; none if it is an edge. */
  std::vector<Cell> FindCells(int a, int b);

  /** Removes parts, which others may replace. */
  void TakeParts(const std::vector<int>& parts);

  /**
   * Marks the tetrahedra below needles of the hull as pierced by the parts beyond them. Elsewhere,
   * parts that are faces count as piercing nothing. To be called once the mesh no longer changes.
   */
  void PierceBelowNeedles();

  /** Adds a part of a triangle of M. */
  void GivePart(const Triangle& corners, int parent);
  void GiveParts(const std::vector<Subdivision::Part>& parts, int threads,
    const std::function<bool(double)>& progress);

  /** Whether an edge may not vanish. */
  using EdgePredicate = std::function<bool(int, int)>;

  /**
   * Put a vertex at a point that is on an edge or on a face except for rounding. The tetrahedra
   * there are split, and the parts that have the edge or are the face. If rounding turns one of the
   * tetrahedra over, more of them are replaced, but no protected edge vanishes. Return the vertex;
   * -1, and do nothing, if that fails.
   */
  int SplitEdge(int a, int b, const Point& p, const EdgePredicate& isProtected);
  int SplitFace(const Cell& cell, int f, const Point& p, const EdgePredicate& isProtected);

  /**
   * Replace the two tetrahedra at a face by three, or the three around an edge by two, unless the
   * face or the edge belongs to a part or a new tetrahedron would be nearly flat. Return whether
   * they did.
   */
  bool FlipFace(const Cell& cell, int f);
  bool FlipEdge(int a, int b, const std::array<Cell, 3>& cells);

  /** What has become of a tetrahedron without volume. */
  struct Flattened
  {
    bool IsRemoved = false;
    int Crossing = -1; ///< the vertex that was made where both edges cross; -1: none
    std::array<std::array<int, 2>, 2> Edges = {};
  };

  /** Removes a tetrahedron whose corners are in one plane except for rounding. */
  Flattened RemoveFlat(const Cell& cell, const EdgePredicate& isProtected);

  /**
   * Removes a vertex that is not M's own by moving it to a neighbor for which `mayMove` returns
   * true. Triangles of M stay the same but for rounding. Returns the neighbor; -1: there is none.
   */
  int RemoveVertex(int vertex, const std::function<bool(int)>& mayMove);

  /** Replaces a vertex, all cells around it and the parts that have it. */
  void ReplaceStar(int vertex, const std::vector<Cell>& star,
    const std::vector<std::array<Vertex, 4>>& cells, const std::vector<int>& gone,
    const std::vector<Subdivision::Part>& made);

  /** Starts a walk over tetrahedra, in which each is pushed once. */
  void BeginWalk()
  {
    ++this->NumberOfWalks;
  }
  void Push(const Cell& cell, std::vector<Cell>& stack);
  void PushStar(const Vertex& v, std::vector<Cell>& stack);

  /** The vertex of an index; none if it has been removed. */
  Vertex GetVertex(int index) const
  {
    return this->Vertices[index];
  }

  /** The edge from one vertex to another, if there is one. */
  std::optional<Delaunay::Edge> FindEdge(int a, int b) const;

  /**
   * All tetrahedra around an edge, infinite ones, too; none if there is no such edge. `hint` saves
   * the search if it was this edge and still is.
   */
  std::vector<Cell> FindCellsAround(int a, int b, const Delaunay::Edge& hint = {}) const;
  std::vector<Cell> FindCellsAround(const Delaunay::Edge& edge) const;

  /** A new vertex, for Refill. */
  Vertex AddVertex(const Point& p);

  /**
   * Replaces cells by others that fill the same space, given by their corners and oriented
   * positively. Afterwards the mesh is no longer Delaunay.
   */
  void Refill(const std::vector<Cell>& old, const std::vector<std::array<Vertex, 4>>& cells);

  const Delaunay& GetDelaunay() const
  {
    return this->Mesh;
  }
  const Subdivision& GetParts() const
  {
    return this->Parts;
  }
  Corners3 CornersOf(int part) const;

private:
  using FaceKey = std::array<int, 3>; ///< the corners of a face in ascending order
  /** The parts that meet some cells. */
  struct PartsOfCells
  {
    std::vector<std::pair<FaceKey, int>> OnFaces; ///< those that are whole faces
    std::vector<int> Others;
  };

  /** Where a vertex is put. */
  struct Place
  {
    Point At;
    std::vector<Cell> Cells;               ///< that have the point on an edge or a face
    std::vector<Cell> Outside;             ///< infinite ones, if the point is on the hull
    std::vector<std::array<int, 2>> Edges; ///< that are split
    std::vector<int> Parts;                ///< that are split
  };

  bool IsStill(const Delaunay::Edge& edge, int a, int b) const;
  Place PlaceOnEdge(int a, int b, const Point& p) const;
  void AddPartsWithEdge(const Cell& cell, int a, int b, std::vector<int>& parts) const;
  Place PlaceOnFace(const Cell& cell, int f, const Point& p) const;
  int Split(const Place& place, const std::function<Vertex()>& insert);
  bool MayReplace(const StarShape& star, const StarSurface& surface, const Place& place,
    const EdgePredicate& isProtected) const;
  int SplitStar(const Place& place, const EdgePredicate& isProtected);
  Subdivision::Change SplitParts(const Place& place, int vertex);
  Flattened RemoveCrossed(const Cell& cell, const std::array<std::vector<int>, 2>& faces,
    const EdgePredicate& isProtected);
  bool RemoveCovered(const Cell& cell, int f);
  using CellContactList = std::vector<std::pair<Cell, Contact>>; ///< of one part
  class MeshMarks;
  class OwnMarks;

  Contact FindContact(const Piercer& piercer, const Cell& cell) const;
  bool MayPassBeyond(int part, const Cell& cell, int f) const;
  std::vector<int> FindPartsAround(const Cell& cell, int f);
  void Meet(int part, const Piercer& piercer, const Cell& cell);
  void MeetAll(const std::vector<int>& parts, const std::vector<Cell>& cells);
  void Settle(int part);
  bool SettleSimply(int part);
  bool SettleOnFace(int part);
  template <class Marks>
  void FindContacts(int part, Marks& marks, CellContactList& contacts) const;
  void AddContacts(int part, const CellContactList& contacts);
  void SettleAll(std::vector<int> parts, int threads, const std::function<bool(double)>& progress);
  std::optional<Delaunay::Facet> FindFace(int part) const;
  void Forget(int part);
  PartsOfCells Collect(const std::vector<Cell>& cells) const;
  void Renew(const std::vector<Cell>& cells, const PartsOfCells& parts);
  int TakeIndex(const Point& p);
  void SetVertex(int index, const Vertex& v);
  void DeleteVertex(int vertex);
  void Collapse(const std::vector<Cell>& star, const Vertex& from, const Vertex& to);
  template <class Marks>
  void PushBeside(const Cell& outside, Marks& marks) const;
  template <class Marks, class Visit>
  void Walk(int part, const Piercer& piercer, Marks& marks, const Visit& visit) const;

  Subdivision Parts;
  Delaunay Mesh;
  std::vector<Vertex> Vertices;
  std::vector<int> Free; ///< the indices of removed vertices
  unsigned NumberOfWalks = 0;
  mutable Delaunay::Edge LastEdge; ///< found last; often the next one to be looked for
  std::vector<Cell> Star, Stack;   ///< of the last walk, kept to reuse their memory
};

Corners4 CornersOf(const PiercedMesh::Cell& cell);

/** The corners of face f of a cell, counter-clockwise when seen from outside the cell. */
Corners3 FaceOf(const PiercedMesh::Cell& cell, int f);

inline Point ToPoint(const Inexact::Point_3& p)
{
  return { p[0], p[1], p[2] };
}

} // namespace carving::helper

#endif
