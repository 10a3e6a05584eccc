// SPDX-License-Identifier: BSD-3-Clause
#include "Homology.h"

#include <algorithm>
#include <iterator>

namespace homology
{
namespace
{

/** All simplices of a complex, by dimension. */
struct Complex
{
  /** By dimension: corners ascending, padded with -1; sorted, each once. */
  std::array<std::vector<std::array<int, 4>>, 4> Simplices;
  /** Of each simplex the indices of its faces in the dimension below, ascending. */
  std::array<std::vector<std::vector<int>>, 4> Boundaries;
  /** Of each simplex the indices of those in the dimension above that it is a face of. */
  std::array<std::vector<std::vector<int>>, 4> Cofaces;
  std::array<std::vector<char>, 4> Removed;
};

/** All faces of the given simplices, themselves included. */
Complex Close(const std::vector<Simplex>& given)
{
  Complex complex;
  for (Simplex simplex : given)
  {
    std::sort(simplex.begin(), simplex.end());
    for (unsigned int subset = 1; subset < 1u << simplex.size(); ++subset)
    {
      std::array<int, 4> face = { -1, -1, -1, -1 };
      int corners = 0;
      for (std::size_t i = 0; i < simplex.size(); ++i)
      {
        if (subset >> i & 1)
        {
          face[corners++] = simplex[i];
        }
      }
      complex.Simplices[corners - 1].push_back(face);
    }
  }
  for (int d = 0; d < 4; ++d)
  {
    auto& simplices = complex.Simplices[d];
    std::sort(simplices.begin(), simplices.end());
    simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
    complex.Boundaries[d].resize(simplices.size());
    complex.Cofaces[d].resize(simplices.size());
    complex.Removed[d].assign(simplices.size(), 0);
    for (std::size_t i = 0; d > 0 && i < simplices.size(); ++i)
    {
      for (int left = 0; left <= d; ++left)
      {
        std::array<int, 4> face = { -1, -1, -1, -1 };
        std::copy_n(simplices[i].begin(), left, face.begin());
        std::copy(
          simplices[i].begin() + left + 1, simplices[i].begin() + d + 1, face.begin() + left);
        const auto& below = complex.Simplices[d - 1];
        const auto found = std::lower_bound(below.begin(), below.end(), face);
        const int index = static_cast<int>(found - below.begin());
        complex.Boundaries[d][i].push_back(index);
        complex.Cofaces[d - 1][index].push_back(static_cast<int>(i));
      }
      std::sort(complex.Boundaries[d][i].begin(), complex.Boundaries[d][i].end());
    }
  }
  return complex;
}

/** The only simplex that the face is a face of; -1 where it has none or several. */
int OnlyCoface(const Complex& complex, int d, int face)
{
  int only = -1;
  for (const int coface : complex.Cofaces[d][face])
  {
    if (!complex.Removed[d + 1][coface])
    {
      if (only >= 0)
      {
        return -1;
      }
      only = coface;
    }
  }
  return only;
}

/**
 * Removes a simplex together with a face that is a face of no other one, again and again: what is
 * left is a deformation retract. Such a simplex is a face of none itself, for of that the face
 * would be in two.
 */
void Collapse(Complex& complex)
{
  for (int d = 2; d >= 0; --d)
  {
    std::vector<int> candidates;
    for (int face = 0; face < static_cast<int>(complex.Simplices[d].size()); ++face)
    {
      candidates.push_back(face);
    }
    while (!candidates.empty())
    {
      const int face = candidates.back();
      candidates.pop_back();
      const int coface = complex.Removed[d][face] ? -1 : OnlyCoface(complex, d, face);
      if (coface < 0)
      {
        continue;
      }
      complex.Removed[d][face] = complex.Removed[d + 1][coface] = 1;
      for (const int other : complex.Boundaries[d + 1][coface])
      {
        candidates.push_back(other);
      }
    }
  }
}

/**
 * The rank of the matrix whose columns are the boundaries of what is left in dimension d: columns
 * with the same lowest entry are added until there are none.
 */
int Rank(const Complex& complex, int d)
{
  const std::size_t rows = complex.Simplices[d - 1].size();
  std::vector<std::vector<int>> columnOfLowest(rows);
  int rank = 0;
  std::vector<int> sum;
  for (std::size_t i = 0; i < complex.Boundaries[d].size(); ++i)
  {
    std::vector<int> column;
    if (!complex.Removed[d][i])
    {
      column = complex.Boundaries[d][i];
    }
    while (!column.empty() && !columnOfLowest[column.back()].empty())
    {
      const std::vector<int>& other = columnOfLowest[column.back()];
      sum.clear();
      std::set_symmetric_difference(
        column.begin(), column.end(), other.begin(), other.end(), std::back_inserter(sum));
      column.swap(sum);
    }
    if (!column.empty())
    {
      ++rank;
      const int lowest = column.back();
      columnOfLowest[lowest] = std::move(column);
    }
  }
  return rank;
}

} // namespace

BettiNumbers ComputeBettiNumbers(const std::vector<Simplex>& simplices, bool collapse)
{
  Complex complex = Close(simplices);
  if (collapse)
  {
    Collapse(complex);
  }
  std::array<int, 5> ranks = {}; // of the boundary of dimension 0, and of that above 3, it is 0
  for (int d = 1; d < 4; ++d)
  {
    ranks[d] = Rank(complex, d);
  }
  BettiNumbers result;
  for (int d = 0; d < 4; ++d)
  {
    const auto& removed = complex.Removed[d];
    const int left = static_cast<int>(std::count(removed.begin(), removed.end(), 0));
    result[d] = left - ranks[d] - ranks[d + 1];
  }
  return result;
}

} // namespace homology
