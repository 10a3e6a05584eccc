// SPDX-License-Identifier: BSD-3-Clause
#include "Limb.h"

#include "PointMath.h"
#include "Spindle.h"

#include <algorithm>

namespace models
{
namespace
{

/** The segment of a path at a fraction of the path, and the fraction of that segment. */
std::pair<std::size_t, double> Locate(const Limb& limb, double fraction)
{
  const double place = fraction * static_cast<double>(limb.Path.size() - 1);
  const std::size_t part = std::min(static_cast<std::size_t>(place), limb.Path.size() - 2);
  return { part, place - static_cast<double>(part) };
}

} // namespace

Point Limb::At(double fraction) const
{
  const auto [i, t] = Locate(*this, fraction);
  return this->Path[i] + t * (this->Path[i + 1] - this->Path[i]);
}

Point Limb::DirectionAt(double fraction) const
{
  const std::size_t i = Locate(*this, fraction).first;
  return Normalized(this->Path[i + 1] - this->Path[i]);
}

double Limb::RadiusAt(double fraction) const
{
  const auto [i, t] = Locate(*this, fraction);
  return this->Radii[i] + t * (this->Radii[i + 1] - this->Radii[i]);
}

void Limb::AddTo(carving::TriangleMesh& mesh, int sides) const
{
  // Any direction serves that is never parallel to the path.
  const std::size_t last = this->Path.size() - 1;
  const Point whole = Normalized(this->Path[last] - this->Path[0]);
  const Point reference = std::abs(whole[2]) > 0.9 ? Point{ 1, 0, 0 } : Point{ 0, 0, 1 };
  std::vector<std::vector<Point>> rings;
  for (std::size_t i = 0; i <= last; ++i)
  {
    const Point along =
      Normalized(this->Path[std::min(i + 1, last)] - this->Path[i > 0 ? i - 1 : 0]);
    const Point x = Normalized(carving::Cross(reference, along));
    const Point y = carving::Cross(along, x);
    std::vector<Point>& ring = rings.emplace_back();
    for (int side = 0; side < sides; ++side)
    {
      const double angle = 2 * Pi * side / sides;
      ring.push_back(this->Path[i] + this->Radii[i] * (std::cos(angle) * x + std::sin(angle) * y));
    }
  }
  const Point first = this->Path[0] - 0.5 * this->Radii[0] * this->DirectionAt(0.0);
  AddSpindle(
    mesh, first, rings, this->Path[last] + 0.5 * this->Radii[last] * this->DirectionAt(1.0), true);
}

ClaimedSpace::ClaimedSpace(double cellSize)
  : CellSize(cellSize)
{
}

bool ClaimedSpace::Claim(const Limb& limb)
{
  const std::vector<Ball> cover = Cover(limb);
  if (!std::all_of(cover.begin(), cover.end(), [&](const Ball& b) { return this->IsFree(b); }))
  {
    return false;
  }
  for (const Ball& ball : cover)
  {
    for (const long long cell : this->Cells(ball))
    {
      this->Balls[cell].push_back(ball);
    }
  }
  return true;
}

/** Balls whose distance is at most the radius, larger than the limb, so that they leave no gaps. */
std::vector<ClaimedSpace::Ball> ClaimedSpace::Cover(const Limb& limb)
{
  std::vector<Ball> balls;
  for (std::size_t i = 0; i + 1 < limb.Path.size(); ++i)
  {
    const Point& a = limb.Path[i];
    const Point& b = limb.Path[i + 1];
    const double thinner = std::min(limb.Radii[i], limb.Radii[i + 1]);
    const int steps = static_cast<int>(Distance(a, b) / thinner) + 1;
    for (int step = 0; step <= steps; ++step)
    {
      const double t = static_cast<double>(step) / steps;
      const double radius = limb.Radii[i] + t * (limb.Radii[i + 1] - limb.Radii[i]);
      balls.push_back({ a + t * (b - a), 1.2 * radius });
    }
  }
  return balls;
}

std::vector<long long> ClaimedSpace::Cells(const Ball& ball) const
{
  long long lower[3], upper[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    lower[axis] = std::llround((ball.Center[axis] - ball.Radius) / this->CellSize);
    upper[axis] = std::llround((ball.Center[axis] + ball.Radius) / this->CellSize);
  }
  std::vector<long long> cells;
  for (long long i = lower[0]; i <= upper[0]; ++i)
  {
    for (long long j = lower[1]; j <= upper[1]; ++j)
    {
      for (long long k = lower[2]; k <= upper[2]; ++k)
      {
        cells.push_back((i * 0x10000 + j) * 0x10000 + k);
      }
    }
  }
  return cells;
}

bool ClaimedSpace::IsFree(const Ball& ball) const
{
  for (const long long cell : this->Cells(ball))
  {
    const auto found = this->Balls.find(cell);
    if (found == this->Balls.end())
    {
      continue;
    }
    for (const Ball& other : found->second)
    {
      if (Distance(ball.Center, other.Center) < ball.Radius + other.Radius)
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace models
