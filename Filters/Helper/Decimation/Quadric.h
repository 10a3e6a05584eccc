// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Sums of squared distances from planes.
 */
#ifndef carving_Quadric_h
#define carving_Quadric_h

#include "Core/Mesh/Vector.h"

namespace carving::helper
{

/** x . A x + 2 b . x + c. */
struct Quadric
{
  double Xx = 0.0, Xy = 0.0, Xz = 0.0, Yy = 0.0, Yz = 0.0, Zz = 0.0; ///< A
  Point B = {};
  double C = 0.0;

  /** Adds `weight` times the squared distance from the plane through p with unit normal n. */
  void AddPlane(const Point& n, const Point& p, double weight)
  {
    const double d = -Dot(n, p);
    this->Xx += weight * n[0] * n[0];
    this->Xy += weight * n[0] * n[1];
    this->Xz += weight * n[0] * n[2];
    this->Yy += weight * n[1] * n[1];
    this->Yz += weight * n[1] * n[2];
    this->Zz += weight * n[2] * n[2];
    for (int i = 0; i < 3; ++i)
    {
      this->B[i] += weight * d * n[i];
    }
    this->C += weight * d * d;
  }

  /** Adds `weight` times the squared distance from p. */
  void AddPoint(const Point& p, double weight)
  {
    this->Xx += weight;
    this->Yy += weight;
    this->Zz += weight;
    for (int i = 0; i < 3; ++i)
    {
      this->B[i] -= weight * p[i];
    }
    this->C += weight * Dot(p, p);
  }

  void Add(const Quadric& other)
  {
    this->Xx += other.Xx;
    this->Xy += other.Xy;
    this->Xz += other.Xz;
    this->Yy += other.Yy;
    this->Yz += other.Yz;
    this->Zz += other.Zz;
    for (int i = 0; i < 3; ++i)
    {
      this->B[i] += other.B[i];
    }
    this->C += other.C;
  }

  Point TimesA(const Point& x) const
  {
    return { this->Xx * x[0] + this->Xy * x[1] + this->Xz * x[2],
      this->Xy * x[0] + this->Yy * x[1] + this->Yz * x[2],
      this->Xz * x[0] + this->Yz * x[1] + this->Zz * x[2] };
  }

  double At(const Point& x) const
  {
    return Dot(x, this->TimesA(x)) + 2.0 * Dot(this->B, x) + this->C;
  }

  double Trace() const
  {
    return this->Xx + this->Yy + this->Zz;
  }

  /** The same function of x - origin. */
  Quadric MovedTo(const Point& origin) const
  {
    Quadric moved = *this;
    const Point a = this->TimesA(origin);
    for (int i = 0; i < 3; ++i)
    {
      moved.B[i] += a[i];
    }
    moved.C = this->At(origin);
    return moved;
  }
};

} // namespace carving::helper

#endif
