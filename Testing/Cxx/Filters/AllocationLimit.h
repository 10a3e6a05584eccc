// SPDX-License-Identifier: BSD-3-Clause
#ifndef AllocationLimit_h
#define AllocationLimit_h

#include <cstddef>

/**
 * During its lifetime, no larger array can be allocated by `new` in this program and its libraries.
 */
class AllocationLimit
{
public:
  explicit AllocationLimit(std::size_t bytes);
  ~AllocationLimit();
  AllocationLimit(const AllocationLimit&) = delete;
  void operator=(const AllocationLimit&) = delete;
};

#endif
