// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/LargePages.h"

#include <cstdint>

#include <sys/mman.h>
#include <unistd.h>

namespace carving
{
namespace
{

/** Gives advice about whole pages. Those at the ends may hold other data, too, to no harm. */
void Advise(void* begin, std::size_t bytes, int advice)
{
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = address / page * page;
  const std::uintptr_t last = (address + bytes + page - 1) / page * page;
  madvise(reinterpret_cast<void*>(first), last - first, advice);
}

} // namespace

void UseLargePages(void* begin, std::size_t bytes)
{
  constexpr std::size_t large = std::size_t(2) << 20; // the size on most processors
  if (bytes >= large)
  {
    Advise(begin, bytes, MADV_HUGEPAGE);
  }
}

void ProvidePages(void* begin, std::size_t bytes)
{
  constexpr std::size_t least = std::size_t(64) << 10; // less takes about as long page by page
  UseLargePages(begin, bytes);
  if (bytes >= least)
  {
    Advise(begin, bytes, MADV_POPULATE_WRITE);
  }
}

} // namespace carving
