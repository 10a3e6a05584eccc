// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The facets of M on which the faces of cells lie.
 */
#ifndef carving_FaceConstraints_h
#define carving_FaceConstraints_h

#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

namespace carving
{

/**
 * For each face of each cell: the facet of M on which the face lies, if any. Most faces lie on
 * none. A bit per face and a list of facets take a fifth of a table's memory, and the bits of all
 * cells stay in the processor's cache.
 */
template <int D>
struct FaceConstraints
{
  /** Per face of a cell: the facet, or -1. */
  using Facets = std::array<int, D + 1>;

  /** Eight successive cells. */
  struct Block
  {
    std::uint32_t Faces; ///< bit 4 * (cell % 8) + f: whether face f lies on a facet
    int Before;          ///< the number of such faces in blocks before this one

    bool operator==(const Block& other) const
    {
      return this->Faces == other.Faces && this->Before == other.Before;
    }
  };

  int NumberOfCells = 0;
  std::vector<Block> Blocks;
  /** For each face that lies on a facet, in the order of cells: the facet. */
  std::vector<int> OfFaces;

  FaceConstraints() = default;

  /** From the facets of all cells. */
  explicit FaceConstraints(const std::vector<Facets>& ofCells)
  {
    this->Blocks.reserve(ofCells.size() / 8 + 1);
    for (const Facets& facets : ofCells)
    {
      this->Append(facets);
    }
  }

  /** Adds a cell after the last one. */
  void Append(const Facets& facets)
  {
    const int first = 4 * (this->NumberOfCells % 8);
    if (first == 0)
    {
      this->Blocks.push_back({ 0, static_cast<int>(this->OfFaces.size()) });
    }
    for (int f = 0; f <= D; ++f)
    {
      if (facets[f] >= 0)
      {
        this->Blocks.back().Faces |= std::uint32_t{ 1 } << (first + f);
        this->OfFaces.push_back(facets[f]);
      }
    }
    ++this->NumberOfCells;
  }

  /** Whether a face lies on a facet. */
  bool Has(int cell, int f) const
  {
    return this->Blocks[cell / 8].Faces >> (4 * (cell % 8) + f) & 1;
  }

  /** The facet on which a face lies, or -1. */
  int Get(int cell, int f) const
  {
    const auto [faces, before] = this->Blocks[cell / 8];
    const int bit = 4 * (cell % 8) + f;
    const std::uint32_t below = faces & ((std::uint32_t{ 1 } << bit) - 1);
    return faces >> bit & 1
      ? this->OfFaces[before + static_cast<int>(std::bitset<32>(below).count())]
      : -1;
  }

  Facets Get(int cell) const
  {
    Facets facets;
    for (int f = 0; f <= D; ++f)
    {
      facets[f] = this->Get(cell, f);
    }
    return facets;
  }

  bool operator==(const FaceConstraints& other) const
  {
    return this->NumberOfCells == other.NumberOfCells && this->Blocks == other.Blocks &&
      this->OfFaces == other.OfFaces;
  }
};

} // namespace carving

#endif
