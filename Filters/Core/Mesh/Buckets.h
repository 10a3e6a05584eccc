// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Items sorted by bucket.
 */
#ifndef carving_Buckets_h
#define carving_Buckets_h

#include "Core/Mesh/LargePages.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace carving
{

/**
 * Items grouped by small numbers (counting sort into compressed sparse rows), in linear time. Each
 * bucket keeps its items in the order in which they were visited.
 */
template <class Item>
class Buckets
{
public:
  using Iterator = typename std::vector<Item>::iterator;

  struct Range
  {
    Iterator First, Last;

    Iterator begin() const
    {
      return this->First;
    }
    Iterator end() const
    {
      return this->Last;
    }
  };

  /**
   * `forEach` calls its argument with the bucket and the item of every item. It runs twice and has
   * to visit the same items in the same order.
   */
  template <class ForEach>
  Buckets(std::size_t numberOfBuckets, ForEach&& forEach)
    : Begins(MakeLarge<int>(numberOfBuckets + 2))
  {
    // Counts are two entries ahead, so that their sums, the begins, are one entry ahead. Placing
    // the items of a bucket moves its begin to its end, which is the begin of the next bucket.
    forEach([this](int bucket, const Item&) { ++this->Begins[bucket + 2]; });
    std::partial_sum(this->Begins.begin(), this->Begins.end(), this->Begins.begin());
    this->Items = MakeLarge<Item>(this->Begins.back());
    forEach(
      [this](int bucket, const Item& item) { this->Items[this->Begins[bucket + 1]++] = item; });
    this->Begins.pop_back();
  }

  int GetNumberOfBuckets() const
  {
    return static_cast<int>(this->Begins.size()) - 1;
  }

  Range operator[](int bucket)
  {
    return { this->Items.begin() + this->Begins[bucket],
      this->Items.begin() + this->Begins[bucket + 1] };
  }

  bool operator==(const Buckets& other) const
  {
    return this->Begins == other.Begins && this->Items == other.Items;
  }

  /** All items, bucket after bucket. */
  const std::vector<Item>& GetItems() const
  {
    return this->Items;
  }

private:
  std::vector<int> Begins; ///< per bucket, and the end of the last one
  std::vector<Item> Items;
};

} // namespace carving

#endif
