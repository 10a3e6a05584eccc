// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Large pages of memory for large arrays.
 *
 * Carving visits cells in an order that has nothing to do with their places in memory. With pages of
 * 4 KiB, the processor then spends much of its time on finding pages, and the system much on
 * providing them. Linux has larger pages for memory that a program asks for by name.
 */
#ifndef carving_LargePages_h
#define carving_LargePages_h

#include <cstddef>
#include <vector>

namespace carving
{

/**
 * Asks the system for large pages behind memory that has been allocated, but not been written to.
 * Has no effect on small arrays, and where the system has no such pages.
 */
void UseLargePages(void* begin, std::size_t bytes);

/** Reserves memory for an empty array, in large pages. */
template <class Container>
void ReserveLarge(Container& values, std::size_t count)
{
  values.reserve(count);
  UseLargePages(values.data(), count * sizeof(typename Container::value_type));
}

/** An array of equal values, in large pages. */
template <class T>
std::vector<T> MakeLarge(std::size_t count, const T& value = T())
{
  std::vector<T> values;
  ReserveLarge(values, count);
  values.resize(count, value);
  return values;
}

} // namespace carving

#endif
