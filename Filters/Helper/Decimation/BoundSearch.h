// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The least error bound within which edges collapse to a number of vertices or triangles.
 */
#ifndef carving_BoundSearch_h
#define carving_BoundSearch_h

#include <algorithm>
#include <cmath>
#include <optional>

namespace carving::helper
{

/**
 * Approaches the bound from below, in few steps: after each of them, all edges are tried again.
 * What a lower bound has left serves the next one, so that nothing is lost by starting low.
 */
class BoundSearch
{
public:
  /** `own` is the error of the surface as given, which collapses hardly make less. */
  BoundSearch(double greatest, double own)
    : Greatest(greatest)
    , Own(own)
  {
  }

  /**
   * The bound to begin with: surfaces within a bound are up to 60 % closer than one without. A
   * bound below the surface's own error would keep the edges where the surface is far. None if that
   * error exceeds the greatest bound.
   */
  std::optional<double> First() const
  {
    constexpr double share = 0.4;
    constexpr double accuracy = 1.01; // of errors
    constexpr double beyond = 1.02;
    if (this->Own > accuracy * this->Greatest)
    {
      return std::nullopt;
    }
    return std::min(std::max(share * this->Greatest, beyond * this->Own), this->Greatest);
  }

  /**
   * The bound after one that has left `excess` times the number, which is greater than 1. None if
   * the greatest bound has been reached or leaves no hope.
   */
  std::optional<double> Next(double bound, double excess)
  {
    constexpr double leastStep = 1.04, mostStep = 1.6;
    // The number falls with a power of the bound: mostly 1, and more where parts vanish.
    constexpr double usual = 1.0, most = 2.5;
    const bool isFirst = this->LastBound == 0.0;
    const double power = isFirst
      ? usual
      : std::max(usual, std::log(this->LastExcess / excess) / std::log(bound / this->LastBound));
    this->LastBound = bound;
    this->LastExcess = excess;
    constexpr double slack = 1.35;
    const double within = std::pow(slack * this->Greatest / bound, isFirst ? most : power);
    if (bound >= this->Greatest || excess > within)
    {
      return std::nullopt;
    }
    // Close to the number, a bound that is a little too great takes less time than one more step.
    constexpr double close = 1.2, shortOf = 0.8, beyond = 1.15;
    const double step = std::pow(excess, (excess > close ? shortOf : beyond) / power);
    return std::min(bound * std::clamp(step, leastStep, mostStep), this->Greatest);
  }

private:
  double Greatest;
  double Own;
  double LastBound = 0.0;
  double LastExcess = 0.0;
};

} // namespace carving::helper

#endif
