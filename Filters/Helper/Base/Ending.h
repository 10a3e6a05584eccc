// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Ending_h
#define carving_Ending_h

#include <string>

/** How an attempt has ended. */
struct Ending
{
  std::string Mistake;  ///< empty: well
  bool ByLimit = false; ///< a limit on time, memory or points ended it: with more it might end well
};

#endif
