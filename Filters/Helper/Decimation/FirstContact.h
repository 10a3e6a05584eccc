// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The first contact of a moving fan of triangles with parts of a mesh.
 */
#ifndef carving_FirstContact_h
#define carving_FirstContact_h

#include "Helper/Base/Slab.h"
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

/** The space that a face of a fan passes through during a motion of w, slightly enlarged. */
class SweptFace
{
public:
  SweptFace(const Point& a, const Point& b, const Point& from, const Point& to, double margin);

  const Box& GetBounds() const
  {
    return this->Bounds;
  }

  bool MayMeet(const Box& box) const;
  bool MayMeet(const std::array<Point, 3>& triangle) const;

  /** Of the face at the start of the motion; not normalized. */
  const Point& GetStartNormal() const
  {
    return this->Slabs[0].Normal;
  }

private:
  Box Bounds;
  std::array<Slab, 2> Slabs; ///< parallel to the face at the start and at the end
};

/**
 * Searches for the first contact while w moves on a straight line, in floating point. The mesh lies
 * behind the fan at first. Only w moves, so that each kind of contact (w and a triangle, a face of
 * the fan and a vertex, an edge of the fan and an edge) happens at the root of a linear function of
 * time.
 */
class ContactSearch
{
public:
  /** Contacts leave a distance of `margin` between the parts. */
  ContactSearch(const Fan& fan, const Point& from, const Point& to, double margin);

  std::size_t GetNumberOfFaces() const
  {
    return this->Faces.size();
  }

  /** Of the first contact so far; above 1 if there is none. */
  double GetTime() const
  {
    return this->Time;
  }

  /** The box of the way of w. */
  Box GetPath() const
  {
    return BoxAround({ this->From, this->From + this->Along });
  }

  /** The motion of a face of the fan until the first contact so far. */
  SweptFace Sweep(std::size_t face) const;

  void AddTriangle(const Point& p, const Point& q, const Point& r);
  void AddVertex(std::size_t face, const Point& m);
  void AddEdge(std::size_t face, const Point& p, const Point& q);

  std::optional<FirstContact> Get() const;

private:
  double FindTime(const Point& normal, const Point& p) const;
  void Set(double time, const Point& normal, const Point& p);
  Point PositionAt(double time) const;

  struct FanFace
  {
    Point A, B;
    Point Outward; ///< at the edge from A to w, at the start of the motion
  };

  std::vector<FanFace> Faces;
  Point From, Along;
  double Margin;
  double Time;
  HalfSpace Allowed = {};
};

} // namespace carving::helper

#endif
