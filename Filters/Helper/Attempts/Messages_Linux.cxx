// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Messages.h"

#include <cstdio>
#include <cstring>
#include <new>

#include <sys/mman.h>

namespace carving::helper
{

/** In memory that forks share. */
struct Messages::Text
{
  static constexpr std::size_t Size = 8192;

  Text()
    : Begin(static_cast<char*>(
        mmap(nullptr, Size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)))
  {
    if (this->Begin == MAP_FAILED)
    {
      throw std::bad_alloc();
    }
  }
  ~Text()
  {
    munmap(this->Begin, Size);
  }

  char* Begin;
};

Messages::Messages(const std::string&)
  : Shared(std::make_unique<Text>())
{
}

Messages::~Messages() = default;

void Messages::Add(const std::string& line)
{
  char* text = this->Shared->Begin;
  const std::size_t length = std::strlen(text);
  std::snprintf(text + length, Text::Size - length, "%s\n", line.c_str());
}

void Messages::Clear()
{
  this->Shared->Begin[0] = '\0';
}

std::string Messages::Get() const
{
  return this->Shared->Begin;
}

} // namespace carving::helper
