// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The record of failed attempts, written by the child processes that made them.
 */
#ifndef carving_Log_h
#define carving_Log_h

#include "Core/Protocol/Protocol.h"
#include "Helper/Base/Ending.h"

#include <string>

namespace carving::helper
{

/** Text that this process shares with its child processes, and they with theirs; at most 8 KiB. */
class Messages
{
public:
  Messages();
  ~Messages();
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  void Add(const std::string& line);
  std::string Get() const;

private:
  char* Shared;
};

/** How attempts ended, for the reply. */
class Log
{
public:
  /** `attempt` is the beginning of the line that the mistake ends. */
  void Add(const std::string& attempt, const Ending& ending);
  void CopyTo(Reply& reply) const;

private:
  Messages Attempts; ///< one line per attempt
  Messages Limits;   ///< one line per limit that ended any attempt
};

} // namespace carving::helper

#endif
