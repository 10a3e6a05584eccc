// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include "Limb.h"
#include "PointMath.h"
#include "Spindle.h"

#include <random>

namespace models
{
namespace
{

const Point Up = { 0, 0, 1 };

class TreeGrower
{
public:
  TriangleMesh Grow(int leaves)
  {
    const int branches = static_cast<int>(std::ceil(0.42 * std::sqrt(leaves)));
    const int twigs = static_cast<int>(std::ceil(leaves / 30.0 / branches));
    const Limb trunk = GrowLimb({ 0, 0, 0 }, Up, 0.04 * Point{ 1, 0.5, 0 }, 1.0, 0.018, 20);
    this->Space.Claim(trunk);
    trunk.AddTo(this->Mesh, 8);
    for (int i = 0; i < branches; ++i)
    {
      this->GrowBranch(trunk, 0.25 + 0.7 * (i + 0.5) / branches, i * GoldenAngle, twigs);
    }
    // Many leaves find no room at the first attempt.
    int grown = 0;
    for (int attempt = 0; grown < leaves && attempt < 50 * leaves; ++attempt)
    {
      grown += this->GrowLeaf(this->Bearers[attempt % this->Bearers.size()]);
    }
    return this->Mesh;
  }

private:
  /**
   * A uniform random number. Unlike the engine, the standard distributions differ between
   * libraries.
   */
  double Between(double lower, double upper)
  {
    return lower + (upper - lower) * std::ldexp(static_cast<double>(this->Random() >> 11), -53);
  }

  /**
   * A tapering limb. `bend` is the displacement of its end, and decreases quadratically toward its
   * start.
   */
  static Limb GrowLimb(const Point& start, const Point& direction, const Point& bend, double length,
    double radius, int parts)
  {
    Limb limb;
    for (int i = 0; i <= parts; ++i)
    {
      const double t = static_cast<double>(i) / parts;
      limb.Path.push_back(start + length * (t * direction + t * t * bend));
      limb.Radii.push_back(radius * (1.0 - 0.8 * t));
    }
    return limb;
  }

  /** The start of a limb of a given radius beside its bearer. */
  static Point Beside(const Limb& bearer, double fraction, const Point& direction, double radius)
  {
    return bearer.At(fraction) + 1.25 * (bearer.RadiusAt(fraction) + radius) * direction;
  }

  bool Add(const Limb& limb, int sides)
  {
    if (!this->Space.Claim(limb))
    {
      return false;
    }
    limb.AddTo(this->Mesh, sides);
    this->Bearers.push_back(limb);
    return true;
  }

  void GrowBranch(const Limb& trunk, double height, double azimuth, int twigs)
  {
    const double length = 0.03 + 0.4 * std::pow(1.0 - height, 0.7) * this->Between(0.8, 1.2);
    const double radius = 0.002 + 0.012 * length;
    const Point out = { std::cos(azimuth), std::sin(azimuth), 0 };
    const Point direction = Normalized(out + this->Between(0.0, 0.3) * Up);
    const Limb branch = GrowLimb(Beside(trunk, height, out, radius), direction,
      this->Between(0.1, 0.3) * Up, length, radius, 8);
    if (!this->Add(branch, 5))
    {
      return;
    }
    for (int i = 0; i < twigs; ++i)
    {
      this->GrowTwig(branch, length, 0.15 + 0.8 * (i + 0.5) / twigs, i % 2 ? 1.0 : -1.0);
    }
  }

  void GrowTwig(const Limb& branch, double branchLength, double fraction, double turn)
  {
    const double radius = 0.0012;
    const Point along = branch.DirectionAt(fraction);
    const Point side = turn * Normalized(carving::Cross(along, Up));
    const Point away = Normalized(side + this->Between(-0.4, 0.4) * Up);
    const Point direction = Normalized(away + this->Between(0.4, 1.0) * along);
    const double length = branchLength * this->Between(0.2, 0.35) * (1.2 - fraction) + 0.02;
    this->Add(GrowLimb(Beside(branch, fraction, away, radius), direction,
                this->Between(0.0, 0.4) * Up, length, radius, 3),
      3);
  }

  bool GrowLeaf(const Limb& bearer)
  {
    const double fraction = this->Between(0.1, 1.0);
    const double length = this->Between(0.012, 0.02);
    const double halfWidth = 0.15 * length;
    const double angle = this->Between(0.0, 2.0 * Pi);
    const Point along = bearer.DirectionAt(fraction);
    const Point x = Normalized(carving::Cross(along, Up));
    const Point away = std::cos(angle) * x + std::sin(angle) * carving::Cross(x, along);
    const Point direction = Normalized(away + 0.7 * along);
    const Point base = Beside(bearer, fraction, away, halfWidth);
    const Point tip = base + length * direction;
    const Limb room = { { base, tip }, { halfWidth, halfWidth } };
    if (!this->Space.Claim(room))
    {
      return false;
    }
    const Point side = carving::Cross(direction, Normalized(carving::Cross(away, along)));
    const Point across = carving::Cross(side, direction);
    const Point middle = base + this->Between(0.4, 0.6) * (tip - base) + 0.3 * halfWidth * side;
    AddSpindle(this->Mesh, base,
      { { middle - 0.9 * halfWidth * across, middle + 0.9 * halfWidth * across } }, tip, false);
    return true;
  }

  std::mt19937_64 Random;
  ClaimedSpace Space{ 0.01 };
  std::vector<Limb> Bearers; ///< the branches and twigs
  TriangleMesh Mesh;
};

} // namespace

TriangleMesh Tree(int leaves)
{
  return TreeGrower().Grow(leaves);
}

} // namespace models
