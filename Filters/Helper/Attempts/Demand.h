// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Tells a child process that its result is wanted.
 */
#ifndef carving_Demand_h
#define carving_Demand_h

#include "Helper/Attempts/Messages.h"

namespace carving::helper
{

/** Shared by a process and a child process that may begin before its result is wanted. */
class Demand
{
public:
  /** Says that the result is wanted. */
  void Raise();

  bool IsRaised() const;

  /** Waits until the result is wanted, or for so many seconds by the clock. */
  void Await(double seconds) const;

private:
  Messages Text{ "demand" };
};

} // namespace carving::helper

#endif
