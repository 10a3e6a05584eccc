// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Ending_h
#define carving_Ending_h

#include <string>

namespace carving::helper
{

/** How an attempt ended. */
struct Ending
{
  std::string Mistake;  ///< why the attempt failed; empty if it succeeded
  bool ByLimit = false; ///< a limit on time, memory or points ended it; a higher one might help
};

} // namespace carving::helper

#endif
