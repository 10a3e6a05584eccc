// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The chain of approximations as local updates (section 3.3, equation (1)), to compare with
 * extracted levels.
 */
#ifndef Chain_h
#define Chain_h

#include "Core/Mesh/Buckets.h"
#include "Core/Stream/Faces.h"
#include "Core/Stream/StoredStream.h"

#include <algorithm>
#include <vector>

/** The changes of one step to the approximation. */
template <int D>
struct ChainUpdate
{
  std::vector<carving::FaceLife<D>> Removed;
  std::vector<carving::FaceLife<D>> Added;
  std::vector<int> AddedVertices;   ///< on the approximation after the update, but not before
  std::vector<int> RemovedVertices; ///< on the approximation before the update, but not after
};

/**
 * Moves along the chain C_0, C_1, ..., C_n. Each move takes time proportional to the change;
 * setting up is linear in the size of the stream.
 */
template <int D>
class Chain
{
public:
  /** Starts at C_0. */
  explicit Chain(const carving::StoredStream<D>& stream)
    : LastStep(stream.Order.LastStep())
    , Faces(CollectFaces(stream))
    , Vertices(FindVertexLives(this->Faces, stream.Mesh.Surface.Points.size()))
    , FaceBirths(SortBy(this->Faces, &carving::FaceLife<D>::Birth))
    , FaceDeaths(SortBy(this->Faces, &carving::FaceLife<D>::Death))
    , VertexBirths(SortBy(this->Vertices, &Life::Birth))
    , VertexDeaths(SortBy(this->Vertices, &Life::Death))
  {
  }

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

  /** Refinement: carves on to the next approximation, which must exist. */
  ChainUpdate<D> Next()
  {
    ++this->Step;
    return { this->Select(this->FaceDeaths), this->Select(this->FaceBirths),
      this->Get(this->VertexBirths), this->Get(this->VertexDeaths) };
  }

  /** Decimation: puts back the cells that the last step carved; undoes Next. */
  ChainUpdate<D> Previous()
  {
    const ChainUpdate<D> update = { this->Select(this->FaceBirths), this->Select(this->FaceDeaths),
      this->Get(this->VertexDeaths), this->Get(this->VertexBirths) };
    --this->Step;
    return update;
  }

private:
  /** The steps from which on a vertex shows, and no longer shows. */
  struct Life
  {
    int Birth = carving::Stream::Never;
    int Death = 0;
  };

  static std::vector<carving::FaceLife<D>> CollectFaces(const carving::StoredStream<D>& stream)
  {
    std::vector<carving::FaceLife<D>> faces;
    ForEachFace(stream, [&](const carving::FaceLife<D>& face) { faces.push_back(face); });
    return faces;
  }

  static std::vector<Life> FindVertexLives(
    const std::vector<carving::FaceLife<D>>& faces, std::size_t numberOfPoints)
  {
    std::vector<Life> lives(numberOfPoints);
    for (const carving::FaceLife<D>& face : faces)
    {
      for (const int vertex : face.Corners)
      {
        lives[vertex].Birth = std::min(lives[vertex].Birth, face.Birth);
        lives[vertex].Death = std::max(lives[vertex].Death, face.Death);
      }
    }
    return lives;
  }

  /**
   * Indices by the step at which the entry is born or dies; those without such a step are left out.
   */
  template <class Entry>
  carving::Buckets<int> SortBy(const std::vector<Entry>& entries, int Entry::*time) const
  {
    return { static_cast<std::size_t>(this->LastStep) + 1,
      [&](auto&& visit)
      {
        for (int i = 0; i < static_cast<int>(entries.size()); ++i)
        {
          if (entries[i].Birth != carving::Stream::Never && entries[i].*time <= this->LastStep)
          {
            visit(entries[i].*time, i);
          }
        }
      } };
  }

  std::vector<int> Get(carving::Buckets<int>& byStep) const
  {
    const auto bucket = byStep[this->Step];
    return { bucket.begin(), bucket.end() };
  }

  std::vector<carving::FaceLife<D>> Select(carving::Buckets<int>& byStep) const
  {
    std::vector<carving::FaceLife<D>> selected;
    for (const int index : byStep[this->Step])
    {
      selected.push_back(this->Faces[index]);
    }
    return selected;
  }

  int LastStep;
  std::vector<carving::FaceLife<D>> Faces;
  std::vector<Life> Vertices;
  carving::Buckets<int> FaceBirths, FaceDeaths, VertexBirths, VertexDeaths;
  int Step = 0;
};

#endif
