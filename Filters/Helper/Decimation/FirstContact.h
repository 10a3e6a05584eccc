// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The first contact of a moving fan of triangles with parts of a mesh.
 */
#ifndef carving_FirstContact_h
#define carving_FirstContact_h

#include "Helper/Decimation/BoxTree.h"
#include "Helper/Decimation/HalfSpaces.h"

#include <optional>
#include <vector>

namespace carving::helper
{

/** The faces (a, b, w) around a vertex w: the edges (a, b) opposite to w, which form a cycle. */
using Fan = std::vector<std::array<Point, 2>>;

struct FirstContact
{
  double Time;       ///< of the motion, from 0 to 1
  HalfSpace Allowed; ///< the positions of w that keep the touching parts apart
};

/**
 * Searches for the first contact while w moves on a straight line, in floating point. The mesh lies behind the
 * fan at first. Only w moves, so that each kind of contact (w and a triangle, a face of the fan and a vertex, an edge
 * of the fan and an edge) happens at the root of a linear function of time.
 */
class ContactSearch
{
public:
  /** Contacts leave a distance of `margin` between the parts. */
  ContactSearch(const Fan& fan, const Point& from, const Point& to, double margin);

  /** Whether a face of the fan may meet something in the box before the first contact so far. */
  bool MayMeet(const Box& box) const;

  void AddTriangle(const Point& p, const Point& q, const Point& r);
  void AddVertex(const Point& m);
  void AddEdge(const Point& p, const Point& q);

  std::optional<FirstContact> Get() const;

private:
  double FindTime(const Point& normal, const Point& p) const;
  void Set(double time, const Point& normal, const Point& p);
  Point PositionAt(double time) const;

  /** The space between two parallel planes. */
  struct Slab
  {
    Point Normal;
    double Lower, Upper;
  };

  struct FanFace
  {
    Point A, B;
    Box Bounds;                ///< during the motion
    std::array<Slab, 2> Slabs; ///< around the motion, along its first and its last plane
    Point Outward;             ///< at the edge from A to w, at the start of the motion
  };

  static bool MayMeet(const FanFace& face, const Box& box);
  static bool Overlaps(const Slab& slab, const Box& box);
  Slab MakeSlab(const Point& a, const Point& b, const Point& w, const Point& other) const;
  void SetEnd(const Point& to);

  std::vector<FanFace> Faces;
  Point From, Along;
  double Margin;
  Box Bounds; ///< of all faces
  double Time;
  HalfSpace Allowed = {};
};

} // namespace carving::helper

#endif
