// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * What attempts that fail leave behind, from whichever process.
 */
#ifndef carving_Log_h
#define carving_Log_h

#include "Core/Protocol/Protocol.h"
#include "Helper/Base/Ending.h"

#include <string>

/** Text that processes that are run apart, and theirs in turn, leave for this one; at most 8 KiB. */
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

/** How attempts have ended, for the reply. */
class Log
{
public:
  void Add(const std::string& attempt, const Ending& ending);
  void CopyTo(carving::Reply& reply) const;

private:
  Messages Attempts; ///< a line each
  Messages Limits;   ///< those of the endings that were by a limit, each once
};

#endif
