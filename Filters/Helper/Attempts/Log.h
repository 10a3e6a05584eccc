// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The record of failed attempts, written by the child processes that made them.
 */
#ifndef carving_Log_h
#define carving_Log_h

#include "Core/Protocol/Protocol.h"
#include "Helper/Attempts/Messages.h"
#include "Helper/Base/Ending.h"

#include <string>

namespace carving::helper
{

/** How attempts ended, for the reply. */
class Log
{
public:
  /**
   * `attempt` is the beginning of the line that the mistake ends, and `subject` that of the
   * mistake. A limit that ends several attempts is listed once, with the first subject.
   */
  void Add(const std::string& attempt, const Ending& ending, const std::string& subject = {});
  void Clear();
  void CopyTo(Reply& reply) const;

private:
  Messages Attempts{ "attempts" }; ///< one line per attempt
  Messages Limits{ "limits" };     ///< one line per limit that ended any attempt
};

} // namespace carving::helper

#endif
