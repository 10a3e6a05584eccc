// SPDX-License-Identifier: BSD-3-Clause
#ifndef carving_SortUnique_h
#define carving_SortUnique_h

#include <algorithm>
#include <functional>
#include <vector>

namespace carving
{

/** Sorts values, and removes all but the first of those that are equal. */
template <class T, class Less = std::less<>>
void SortUnique(std::vector<T>& values, const Less& less = {})
{
  std::sort(values.begin(), values.end(), less);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace carving

#endif
