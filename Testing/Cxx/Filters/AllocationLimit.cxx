// SPDX-License-Identifier: BSD-3-Clause
#include "AllocationLimit.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace
{

std::atomic<std::size_t> LargestAllocation{ SIZE_MAX };

} // namespace

AllocationLimit::AllocationLimit(std::size_t bytes)
{
  LargestAllocation = bytes;
}

AllocationLimit::~AllocationLimit()
{
  LargestAllocation = SIZE_MAX;
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return size <= LargestAllocation ? std::malloc(size > 0 ? size : 1) : nullptr;
}

void* operator new(std::size_t size)
{
  void* memory = operator new(size, std::nothrow);
  return memory ? memory : throw std::bad_alloc();
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
