// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The chain of approximations as local updates (section 3.3, equation (1)).
 */
#ifndef carving_Chain_h
#define carving_Chain_h

#include "Core/Stream/Faces.h"
#include "Core/Stream/StoredStream.h"

#include <vector>

namespace carving
{

/** What one step changes on the approximation. */
template <int D>
struct ChainUpdate
{
  std::vector<FaceLife<D>> Removed;
  std::vector<FaceLife<D>> Added;
  /** Points that are on the approximation after the update and were not before, or the other way. */
  std::vector<int> AddedVertices;
  std::vector<int> RemovedVertices;
};

/**
 * Moves along the chain C_0, C_1, ..., C_n, from one approximation to the next or the last, each time
 * in time proportional to the change. Setting up is linear in the size of the stream.
 */
template <int D>
class Chain
{
public:
  /** Starts at C_0. `stream` must outlive the chain. */
  explicit Chain(const StoredStream<D>& stream);

  int GetStep() const
  {
    return this->Step;
  }
  bool HasNext() const
  {
    return this->Step < this->LastStep;
  }
  bool HasPrevious() const
  {
    return this->Step > 0;
  }

  /** Refinement: carves on to the next approximation, which there must be. */
  ChainUpdate<D> Next();

  /** Decimation: puts back what the last step carved; undoes Next. */
  ChainUpdate<D> Previous();

private:
  /** Indices by step: those of step i are Items[Ends[i - 1]] to Items[Ends[i]]. */
  struct ByStep
  {
    std::vector<int> Ends;
    std::vector<int> Items;
    void Fill(const std::vector<int>& stepOfItem, int lastStep);
    std::vector<int> Get(int step) const;
  };

  std::vector<FaceLife<D>> Select(const std::vector<int>& indices) const;

  std::vector<FaceLife<D>> Faces;
  ByStep FaceBirths, FaceDeaths, VertexBirths, VertexDeaths;
  int Step = 0;
  int LastStep;
};

} // namespace carving

#endif
