// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Log.h"

#include <cstdio>
#include <cstring>
#include <new>

#include <sys/mman.h>

namespace carving::helper
{
namespace
{

constexpr std::size_t Size = 8192;

} // namespace

Messages::Messages()
  : Shared(static_cast<char*>(
      mmap(nullptr, Size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)))
{
  if (this->Shared == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
}

Messages::~Messages()
{
  munmap(this->Shared, Size);
}

void Messages::Add(const std::string& line)
{
  const std::size_t length = std::strlen(this->Shared);
  std::snprintf(this->Shared + length, Size - length, "%s\n", line.c_str());
}

std::string Messages::Get() const
{
  return this->Shared;
}

void Log::Add(const std::string& attempt, const Ending& ending)
{
  this->Attempts.Add(attempt + ending.Mistake);
  if (ending.ByLimit && this->Limits.Get().find(ending.Mistake + "\n") == std::string::npos)
  {
    this->Limits.Add(ending.Mistake);
  }
}

void Log::CopyTo(Reply& reply) const
{
  reply.Attempts = this->Attempts.Get();
  reply.Limits = this->Limits.Get();
}

} // namespace carving::helper
