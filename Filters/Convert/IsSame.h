// SPDX-License-Identifier: BSD-3-Clause
#ifndef IsSame_h
#define IsSame_h

/**
 * Whether an enumerator of a filter has the same value as that of the core. Values are passed on by
 * casts.
 */
template <class Enumerator>
constexpr bool IsSame(int filters, Enumerator cores)
{
  return filters == static_cast<int>(cores);
}

#endif
