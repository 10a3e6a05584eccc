// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Whether a decimation is likely to get to its target.
 */
#ifndef carving_Hope_h
#define carving_Hope_h

#include <algorithm>

namespace carving::helper
{

/**
 * With more vertices than this multiple of its target, a surface whose edges no longer collapse
 * well seldom reaches the target, and never within a bound.
 */
constexpr double MostAboveTarget = 1.1;

/** Predicts whether a surface will reach its number once no edge collapses well. */
class Hope
{
public:
  explicit Hope(double target)
    : Target(target)
  {
  }

  /** Counts an attempt to collapse an edge. Returns whether the attempt is worth its time. */
  bool GoesOn(double count)
  {
    constexpr double few = 100.0;          // vertices, at which all attempts take hardly any time
    constexpr double sample = 500.0;       // attempts
    constexpr double mostPerVertex = 10.0; // attempts
    this->First = this->Attempts == 0.0 ? count : this->First;
    ++this->Attempts;
    const double collapsed = std::max(this->First - count, 1.0);
    const double needed = (count - this->Target) / collapsed * this->Attempts;
    return count <= std::max(few, MostAboveTarget * this->Target) || this->Attempts < sample ||
      needed <= mostPerVertex * count;
  }

private:
  double Target;
  double First = 0.0; ///< the count at the first attempt
  double Attempts = 0.0;
};

} // namespace carving::helper

#endif
