// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Labels of the pieces around a cell, and the sides of a cell that joins pieces.
 */
#ifndef carving_Labels_h
#define carving_Labels_h

#include <algorithm>
#include <array>
#include <cstddef>

namespace carving
{

/**
 * One label per corner, or one per face, of a cell. They tell apart the pieces of K, or of N,
 * around the cell: equal labels mean that the corners (or faces) are joined without the cell. A
 * label is the index of one of the corners (or faces) that have it. -1 means that nothing remains
 * at the corner (or face) without the cell.
 */
template <std::size_t N>
using Labels = std::array<int, N>;

/** The number of different labels, not counting -1. */
template <std::size_t N>
int CountLabels(Labels<N> labels)
{
  std::sort(labels.begin(), labels.end());
  const auto first = std::upper_bound(labels.begin(), labels.end(), -1);
  return static_cast<int>(std::unique(first, labels.end()) - first);
}

/** Replaces label a by label b. */
template <std::size_t N>
void MergeLabels(Labels<N>& labels, int a, int b)
{
  std::replace(labels.begin(), labels.end(), a, b);
}

/**
 * A side per corner, or per face, of a cell. A bridge is a cell that is kept because its removal
 * would split a component: while it is kept, nothing else joins corners (or faces) on different
 * sides. All sides of any other cell are 0.
 */
template <std::size_t N>
struct Sides
{
  std::array<unsigned char, N> Of = {};

  Sides() = default;
  /** Nothing will ever remain where there is no label, so that any side will do there. */
  explicit Sides(const Labels<N>& labels)
  {
    for (std::size_t i = 0; i < N; ++i)
    {
      this->Of[i] = static_cast<unsigned char>(std::max(0, labels[i]));
    }
  }

  bool IsBridge() const
  {
    return this->Of != std::array<unsigned char, N>{};
  }
};

} // namespace carving

#endif
