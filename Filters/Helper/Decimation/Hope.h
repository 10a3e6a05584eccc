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
 * A bounded surface with more vertices than this factor of its target, none of whose edges
 * collapses well, does not get to the target.
 */
constexpr double MostAboveTarget = 1.1;

/** Tells whether edges that do not collapse well will ever get a surface to its number. */
class Hope
{
public:
  explicit Hope(double target)
    : Target(target)
  {
  }

  /** Takes over that another edge is tried. Returns whether it is worth its time. */
  bool GoesOn(double count)
  {
    constexpr double sample = 500.0;    // attempts
    constexpr double mostPasses = 10.0; // attempts per vertex
    this->First = this->Attempts == 0.0 ? count : this->First;
    ++this->Attempts;
    const double collapsed = std::max(this->First - count, 1.0);
    const double needed = (count - this->Target) / collapsed * this->Attempts;
    return count <= MostAboveTarget * this->Target || this->Attempts < sample ||
      needed <= mostPasses * count;
  }

private:
  double Target;
  double First = 0.0; ///< the count at the first attempt
  double Attempts = 0.0;
};

} // namespace carving::helper

#endif
