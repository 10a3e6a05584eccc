// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The position of the vertex that an edge collapses into.
 */
#ifndef carving_Placement_h
#define carving_Placement_h

#include "Helper/Decimation/HalfSpaces.h"
#include "Helper/Decimation/Obstacle.h"
#include "Helper/Decimation/SurfaceMesh.h"

#include <optional>
#include <vector>

namespace carving::helper
{

/** The error of a position x: a quadric of x - Origin. */
struct LocalError
{
  Quadric Error;
  Point Origin;

  double At(const Point& x) const
  {
    return this->Error.At(x - this->Origin);
  }
};

/** The way of a vertex inward from an outward position, as far as it has been followed. */
struct Slide
{
  explicit Slide(const Point& start)
    : Start(start)
    , Position(start)
  {
  }

  Point Start;
  Point Position;
  std::vector<HalfSpace> Limits; ///< of the rest of the way, relative to the origin of the error
  int Contacts = 0;              ///< with M, up to the position
  bool IsAtEnd = false;
};

/** Whether w is on the outer side of all faces of a star, exactly. */
bool IsOutside(const Star& star, const Point& w);

class Placement
{
public:
  /** Positions stay near the convex hull of the points. The obstacle must outlive this object. */
  Placement(const std::vector<Point>& points, Obstacle& obstacle);

  /**
   * Lets positions be farther from the obstacle. Returns false if they may be as far as is
   * sensible for a number of vertices, or farther than an error bound.
   */
  bool Widen(std::size_t vertices, double errorBound);

  /** The least error of any position. */
  static double FindLeastError(const LocalError& error);

  /**
   * The position of least error on the outer side of all faces of a star, exactly. There, the
   * surface after the collapse encloses the surface before. Nothing if there is no such position.
   */
  std::optional<Point> FindOutward(const Star& star, const LocalError& error) const;

  /**
   * The position of least error that a vertex reaches from an outward position while its faces
   * slide along M. Decided in floating point: the caller has to check the result. Stops early if
   * the error will exceed `limit`, at a position of less error than that at the end, but more than
   * `limit`. The slide goes on from there in a later call for the same star, error and bounds.
   */
  Point SlideInward(const Star& star, const LocalError& error, Slide& slide, double limit);

  /** Slides all the way. */
  Point SlideInward(const Star& star, const LocalError& error, const Point& start);

private:
  std::optional<Point> Minimize(const LocalError& error, std::vector<HalfSpace>& limits) const;

  Obstacle& M;
  double Diagonal;
  double Slack;                  ///< between M and the bounds
  std::vector<HalfSpace> Bounds; ///< a polytope around M
};

} // namespace carving::helper

#endif
