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
  double ProcessorSeconds = 0.0; ///< that the attempt took, if it was made in a child process
};

} // namespace carving::helper

#endif
