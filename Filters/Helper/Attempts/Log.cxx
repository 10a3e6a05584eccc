// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Log.h"

namespace carving::helper
{

void Log::Add(const std::string& attempt, const Ending& ending, const std::string& subject)
{
  this->Attempts.Add(attempt + subject + ending.Mistake);
  if (ending.ByLimit && this->Limits.Get().find(ending.Mistake + "\n") == std::string::npos)
  {
    this->Limits.Add(subject + ending.Mistake);
  }
}

void Log::Clear()
{
  this->Attempts.Clear();
  this->Limits.Clear();
}

void Log::CopyTo(Reply& reply) const
{
  reply.Attempts = this->Attempts.Get();
  reply.Limits = this->Limits.Get();
}

} // namespace carving::helper
