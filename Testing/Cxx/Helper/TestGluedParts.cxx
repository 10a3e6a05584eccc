// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Components of the remaining tetrahedra, glued at faces only, while they are carved one by one.
 */
#include "Core/Budget/GluedParts.h"
#include "GluedCount.h"
#include "HelperRun.h"
#include "RandomModels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace carving;

namespace
{

Tetrahedralization DrawTetrahedra(std::mt19937_64& random)
{
  const TriangleMesh mesh = random() % 2 == 0
    ? models::Soup(2 + static_cast<int>(random() % 8), random)
    : models::MakeRandom(random).Mesh;
  return GetReply(mesh, Conformity::Auto).Result;
}

/** Carves one tetrahedron a step, in a random order. Each adjoins the exterior. */
Stream DrawOrder(const Tetrahedralization& mesh, std::mt19937_64& random)
{
  Stream stream;
  stream.Step.assign(mesh.Cells.size(), Stream::Never);
  stream.StepPriority.assign(1, 0.0);
  std::vector<int> candidates;
  const auto expose = [&](int cell)
  {
    if (cell >= 0 && stream.Step[cell] == Stream::Never && random() % 8 != 0)
    {
      candidates.push_back(cell);
    }
  };
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    const auto& neighbors = mesh.Neighbors[cell];
    expose(*std::min_element(neighbors.begin(), neighbors.end()) < 0 ? cell : -1);
  }
  while (!candidates.empty())
  {
    std::swap(candidates[random() % candidates.size()], candidates.back());
    const int cell = candidates.back();
    candidates.pop_back();
    if (stream.Step[cell] == Stream::Never)
    {
      stream.Step[cell] = static_cast<int>(stream.StepPriority.size());
      stream.StepPriority.push_back(0.0);
      std::for_each(mesh.Neighbors[cell].begin(), mesh.Neighbors[cell].end(), expose);
    }
  }
  return stream;
}

} // namespace

// While tetrahedra are carved in any order, also across M, the number of components is that of a
// count from scratch; before it is exact, it is at least that.
TEST(GluedParts, AreCountedAsFromScratch)
{
  std::mt19937_64 random(64);
  int most = 0;
  for (int i = 0; i < 40 && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("random mesh " + std::to_string(i));
    const Tetrahedralization mesh = DrawTetrahedra(random);
    const Stream stream = DrawOrder(mesh, random);
    std::vector<int> order(stream.LastStep() + 1);
    for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
    {
      if (stream.Step[cell] != Stream::Never)
      {
        order[stream.Step[cell]] = cell;
      }
    }
    std::vector<CellState> states(mesh.Cells.size(), CellState::Carvable);
    for (std::size_t cell = 0; cell < states.size(); ++cell)
    {
      if (stream.Step[cell] == Stream::Never && random() % 2 == 0)
      {
        states[cell] = CellState::Permanent;
      }
    }
    RemainingCells<3> cells(mesh, states);
    GluedParts parts(mesh, cells);
    const int exactFrom = std::max(1, static_cast<int>(random() % (stream.LastStep() + 1)));
    for (int step = 1; step <= stream.LastStep(); ++step)
    {
      if (step == exactFrom)
      {
        parts.MakeExact();
      }
      parts.Carve(order[step], parts.Examine(order[step]));
      cells.States[order[step]] = CellState::Carved;
      if (step % (1 + stream.LastStep() / 20) == 0)
      {
        const int components = CountGlued(mesh, stream, step);
        EXPECT_GE(parts.GetComponents(), components) << "step " << step;
        EXPECT_TRUE(step < exactFrom || parts.GetComponents() == components) << "step " << step;
        most = std::max(most, components);
      }
    }
  }
  EXPECT_GT(most, 1);
}
