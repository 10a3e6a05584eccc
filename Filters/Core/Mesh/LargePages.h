// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Pages of memory for large arrays, all at once.
 *
 * Carving visits cells in an order that has nothing to do with their places in memory. With pages
 * of 4 KiB, the processor then spends much of its time on finding pages, and the system much on
 * providing them one by one. Linux has larger pages for memory that a program asks for by name, and
 * provides all pages of an array in a single call.
 */
#ifndef carving_LargePages_h
#define carving_LargePages_h

#include <cstddef>
#include <vector>

namespace carving
{

/**
 * Asks the system for large pages behind memory that has been allocated, but not been written to.
 * Has no effect on small arrays, and on systems other than Linux.
 */
void UseLargePages(void* begin, std::size_t bytes);

/**
 * Has the system provide the pages behind memory that has been allocated, but not been written to:
 * large ones if the memory is large. All of the memory should be needed. Has no effect on small
 * arrays, and on systems other than Linux.
 */
void ProvidePages(void* begin, std::size_t bytes);

/** Reserves memory for an empty array, with its pages. */
template <class Container>
void ReserveLarge(Container& values, std::size_t count)
{
  values.reserve(count);
  ProvidePages(values.data(), count * sizeof(typename Container::value_type));
}

/** Reserves memory for an empty array of an unknown size, which is at most `count` as a rule. */
template <class Container>
void ReserveAtMost(Container& values, std::size_t count)
{
  values.reserve(count);
  UseLargePages(values.data(), count * sizeof(typename Container::value_type));
}

/** An array of equal values, in pages provided at once. */
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
