// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/LoosePieces.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace carving;

namespace
{

/** A row of nine cells, cell i with the vertices i to i + 3, of which the last one stays. */
Tetrahedralization RowWithKeptEnd()
{
  Tetrahedralization mesh = small::Row(9);
  mesh.Kept.assign(9, 0);
  mesh.Kept[8] = 1;
  return mesh;
}

Stream WithSteps(const std::vector<int>& steps, int last)
{
  Stream stream;
  stream.Step = steps;
  stream.StepPriority.push_back(std::nan(""));
  for (int step = 1; step <= last; ++step)
  {
    stream.StepPriority.push_back(100.0 - step);
  }
  return stream;
}

} // namespace

// Two cells that split off with nothing of M go with the step that splits them off; the steps that
// would have carved them are dropped.
TEST(LoosePieces, GoWhenTheySplitOff)
{
  Stream stream = WithSteps({ 8, 4, 1, 2, 3, 5, 6, 7, Stream::Never }, 8);
  CarveLoosePieces(RowWithKeptEnd(), stream);
  // The cells 2 to 4 connect the first two to the others, in step 3 for the last time.
  EXPECT_EQ(stream.Step, (std::vector<int>{ 3, 3, 1, 2, 3, 4, 5, 6, Stream::Never }));
  ASSERT_EQ(stream.LastStep(), 6);
  const double expected[] = { 99, 98, 97, 95, 94, 93 };
  for (int step = 1; step <= 6; ++step)
  {
    EXPECT_EQ(stream.StepPriority[step], expected[step - 1]) << step;
  }
}

// A piece that stays connected, or splits off with a vertex of M, keeps its steps.
TEST(LoosePieces, AreNoneWithAVertexOfM)
{
  const std::vector<int> fromTheEnd = { 1, 2, 3, 4, 5, 6, 7, 8, Stream::Never },
                         split = { 8, 4, 1, 2, 3, 5, 6, 7, Stream::Never };
  Stream stream = WithSteps(fromTheEnd, 8);
  CarveLoosePieces(RowWithKeptEnd(), stream);
  EXPECT_EQ(stream.Step, fromTheEnd);
  Tetrahedralization mesh = RowWithKeptEnd();
  mesh.Surface.Facets = { { 0, 1, 2 } };
  stream = WithSteps(split, 8);
  CarveLoosePieces(mesh, stream);
  EXPECT_EQ(stream.Step, split);
}
