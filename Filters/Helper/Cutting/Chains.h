// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The edges of M that consist of several edges of the tetrahedralization.
 */
#ifndef carving_Chains_h
#define carving_Chains_h

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace carving::helper
{

/**
 * Each chain is a sequence of vertices from one end of an edge of M to the other. Where an edge of
 * the tetrahedralization is split, or one of its vertices removed, the chains through it follow. A
 * chain exists as long as there are triangles that need it.
 */
class Chains
{
public:
  /** Counts one more triangle that needs the edge ab, or one less. */
  void Need(int a, int b);
  void Release(int a, int b);

  bool Has(int a, int b) const;

  /** Adds a chain for the edge between its first and its last vertex. */
  void Add(const std::vector<int>& vertices);

  /** Appends the vertices between a and b, from a to b, if the edge has a chain. */
  void Append(int a, int b, std::vector<int>& vertices) const;

  /** Whether an edge of the tetrahedralization belongs to a chain. */
  bool IsLink(int a, int b) const;

  /** Records that a vertex has been put on an edge of the tetrahedralization. */
  void Split(int a, int b, int vertex);

  /** Whether every chain through a vertex stays the same but for it when it moves to `target`. */
  bool MayMove(int vertex, int target) const;

  /** Records that a vertex has moved to a neighbor for which MayMove returned true. */
  void Remove(int vertex);

private:
  using Indices = std::unordered_map<std::uint64_t, std::vector<int>>;

  static void Drop(Indices& indices, std::uint64_t key, int chain);

  std::vector<std::vector<int>> All;
  std::unordered_map<std::uint64_t, int> OfEdge; ///< by edge of M
  std::unordered_map<std::uint64_t, int> Needs;  ///< by edge of M
  Indices AtLink;                                ///< by edge of the tetrahedralization
  Indices AtVertex;                              ///< by vertex, but for the ends
};

} // namespace carving::helper

#endif
