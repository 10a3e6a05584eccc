// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/LoosePieces.h"

#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/DisjointSets.h"

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

namespace carving
{
namespace
{

/** Per vertex: whether it stays in the last approximation. */
template <int D>
std::vector<char> FindLastingVertices(const Decomposition<D>& mesh, const Stream& stream)
{
  std::vector<char> lasts(mesh.Surface.Points.size(), 0);
  const auto mark = [&lasts](const auto& corners)
  {
    for (const int vertex : corners)
    {
      lasts[vertex] = 1;
    }
  };
  std::for_each(mesh.Surface.Facets.begin(), mesh.Surface.Facets.end(), mark);
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    if (stream.Step[cell] == Stream::Never)
    {
      mark(mesh.Cells[cell]);
    }
  }
  return lasts;
}

/** The pieces that a growing set of cells consists of. Those with a vertex that lasts are one. */
template <int D>
class GrowingPieces
{
public:
  explicit GrowingPieces(const std::vector<char>& lasts)
    : Sets(lasts.size() + 1) // the last set is the piece that lasts
    , Lasting(static_cast<int>(lasts.size()))
  {
    for (int vertex = 0; vertex < this->Lasting; ++vertex)
    {
      if (lasts[vertex])
      {
        this->Sets.Unite(vertex, this->Lasting);
      }
    }
  }

  /**
   * Adds a cell. Calls `visit` with each cell of loose pieces that now belong to the lasting one.
   */
  template <class Visitor>
  void Add(int cell, const typename Decomposition<D>::Cell& corners, Visitor&& visit)
  {
    std::vector<int> cells = { cell };
    const bool lasts = std::any_of(corners.begin(), corners.end(),
      [this](int vertex) { return this->Sets.Find(vertex) == this->Sets.Find(this->Lasting); });
    for (const int vertex : corners)
    {
      this->TakeCells(this->Sets.Find(vertex), cells);
      this->Sets.Unite(vertex, lasts ? this->Lasting : corners[0]);
    }
    if (lasts)
    {
      std::for_each(cells.begin(), cells.end(), visit);
    }
    else
    {
      this->CellsOf[this->Sets.Find(corners[0])] = std::move(cells);
    }
  }

private:
  /** Moves the cells of a loose piece to others. */
  void TakeCells(int piece, std::vector<int>& cells)
  {
    const auto found = this->CellsOf.find(piece);
    if (found != this->CellsOf.end())
    {
      std::vector<int>& own = found->second;
      if (own.size() > cells.size())
      {
        own.swap(cells);
      }
      cells.insert(cells.end(), own.begin(), own.end());
      this->CellsOf.erase(found);
    }
  }

  DisjointSets Sets;
  int Lasting;
  std::unordered_map<int, std::vector<int>> CellsOf; ///< per first vertex of a loose piece
};

/** Numbers the steps anew, without those in which no cell is carved. */
void DropEmptySteps(Stream& stream)
{
  std::vector<int> numbers(stream.StepPriority.size(), 0);
  for (const int step : stream.Step)
  {
    if (step != Stream::Never)
    {
      numbers[step] = 1;
    }
  }
  int last = 0;
  for (std::size_t step = 1; step < numbers.size(); ++step)
  {
    if (numbers[step] > 0)
    {
      numbers[step] = ++last;
      stream.StepPriority[last] = stream.StepPriority[step];
    }
  }
  stream.StepPriority.resize(last + 1);
  for (int& step : stream.Step)
  {
    step = step == Stream::Never ? step : numbers[step];
  }
}

} // namespace

template <int D>
void CarveLoosePieces(const Decomposition<D>& mesh, Stream& stream)
{
  const std::vector<char> lasts = FindLastingVertices(mesh, stream);
  if (std::find(lasts.begin(), lasts.end(), 0) == lasts.end())
  {
    return;
  }
  const auto mayBeLoose = [&](std::size_t cell)
  {
    const auto& corners = mesh.Cells[cell];
    return stream.Step[cell] != Stream::Never &&
      std::any_of(corners.begin(), corners.end(), [&](int vertex) { return !lasts[vertex]; });
  };
  Buckets<int> byStep(stream.StepPriority.size(),
    [&](auto&& visit)
    {
      for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
      {
        if (mayBeLoose(cell))
        {
          visit(stream.Step[cell], static_cast<int>(cell));
        }
      }
    });
  bool anyMoved = false;
  GrowingPieces<D> pieces(lasts);
  for (int step = stream.LastStep(); step > 0; --step)
  {
    for (const int cell : byStep[step])
    {
      pieces.Add(cell, mesh.Cells[cell],
        [&](int loose)
        {
          anyMoved = anyMoved || stream.Step[loose] > step;
          stream.Step[loose] = step;
        });
    }
  }
  if (anyMoved)
  {
    DropEmptySteps(stream);
  }
}

template void CarveLoosePieces<2>(const Decomposition<2>&, Stream&);
template void CarveLoosePieces<3>(const Decomposition<3>&, Stream&);

} // namespace carving
