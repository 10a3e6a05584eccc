// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Budgets on tetrahedralizations for which the cells to be deferred, and how long, are known.
 */
#include "Core/Carving/Carver.h"
#include "Homology.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace carving;

namespace
{

/** Carves one cell a step, in the order of the indices as far as possible. */
CarveOptions InOrder(const Tetrahedralization& mesh, const BettiNumbers& budget)
{
  CarveOptions options = small::OneByOne();
  options.DepthExponent = 1.0;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    options.Depths.push_back(std::pow(100.0, cell));
  }
  options.Budget = budget;
  return options;
}

Stream CarveWith(const Tetrahedralization& mesh, const CarveOptions& options)
{
  return small::Carved(mesh, options, SolidRule::SurfaceOnly);
}

/**
 * An octahedron in four cells around its axis from point 0 to 1. M is the two outer faces of cell
 * 2. Once cells 0 and 1, which lie between the others, have been carved, removing cell 2 leaves a
 * ring of its outer faces and the axis, as long as cell 3 remains at the axis.
 */
Tetrahedralization Octahedron()
{
  return small::Assemble(
    { { 0, 0, 1 }, { 0, 0, -1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } },
    { { 0, 1, 3, 4 }, { 0, 1, 5, 2 }, { 0, 1, 2, 3 }, { 0, 1, 4, 5 } },
    { { 0, 2, 3 }, { 1, 3, 2 } });
}

/** Cells in a row. M is the first and the last face. */
Tetrahedralization RowBetweenFaces(int n)
{
  const Tetrahedralization row = small::Row(n);
  return small::Assemble(row.Surface.Points, row.Cells, { { 0, 1, 2 }, { n, n + 1, n + 2 } });
}

homology::BettiNumbers LastBettiNumbers(const Tetrahedralization& mesh, const Stream& stream)
{
  return homology::ComputeBettiNumbers(homology::ClosedComplex(mesh, stream, stream.LastStep()));
}

} // namespace

// Without a budget the cells are carved in order, and a tunnel opens with the third.
TEST(Budget, IsNotNeededForTheOrder)
{
  const Tetrahedralization mesh = Octahedron();
  const Stream stream = CarveWith(mesh, InOrder(mesh, { -1, -1, -1 }));
  EXPECT_EQ(stream.Step, (std::vector<int>{ 1, 2, 3, 4 }));
  EXPECT_EQ(homology::ComputeBettiNumbers(homology::ClosedComplex(mesh, stream, 3)),
    (homology::BettiNumbers{ 1, 1, 0, 0 }));
}

// A tetrahedron that would open a tunnel is deferred, and carved once a neighbor at an edge has
// been.
TEST(Budget, LooksAgainWhenTheNeighborhoodChanges)
{
  const Tetrahedralization mesh = Octahedron();
  const Stream stream = CarveWith(mesh, InOrder(mesh, { -1, 0, -1 }));
  EXPECT_EQ(stream.Step, (std::vector<int>{ 1, 2, 4, 3 }));
}

// A tetrahedron is not deferred if the budget has room for the tunnel.
TEST(Budget, LeavesTheOrderAloneWhileThereIsRoom)
{
  const Tetrahedralization mesh = Octahedron();
  for (const BettiNumbers& budget : { BettiNumbers{ 2, 1, 0 }, BettiNumbers{ 5, 5, 5 } })
  {
    EXPECT_EQ(CarveWith(mesh, InOrder(mesh, budget)).Step, (std::vector<int>{ 1, 2, 3, 4 }));
  }
}

// Some exposed tetrahedra of a step are deferred, and still carved in the same step once they can
// be.
TEST(Budget, TakesExposedTetrahedraInPart)
{
  const Tetrahedralization mesh = Octahedron();
  CarveOptions options = InOrder(mesh, { -1, 0, -1 });
  options.CarveExposed = true;
  EXPECT_EQ(CarveWith(mesh, options).Step, (std::vector<int>{ 1, 1, 1, 1 }));
}

// A row between two triangles stays connected, and has no cells to spare: without the first or the
// last of the remaining cells there are two components.
TEST(Budget, KeepsOneComponent)
{
  const Tetrahedralization mesh = RowBetweenFaces(8);
  EXPECT_EQ(
    LastBettiNumbers(mesh, CarveWith(mesh, InOrder(mesh, { -1, -1, -1 })))[0], 2); // the triangles
  for (const bool exposed : { false, true })
  {
    CarveOptions options = InOrder(mesh, { 1, -1, -1 });
    options.CarveExposed = exposed;
    Stream stream = CarveWith(mesh, options);
    EXPECT_GT(stream.LastStep(), 0);
    EXPECT_EQ(LastBettiNumbers(mesh, stream), (homology::BettiNumbers{ 1, 0, 0, 0 }));
    const auto begin = stream.Step.begin(), end = stream.Step.end();
    const auto first = std::find(begin, end, Stream::Never);
    const auto last = std::find(stream.Step.rbegin(), stream.Step.rend(), Stream::Never);
    ASSERT_NE(first, end);
    EXPECT_EQ(std::count(begin, end, Stream::Never), last.base() - first); // no gap
    for (int* const step : { &*first, &*last })
    {
      *step = 0;
      EXPECT_EQ(LastBettiNumbers(mesh, stream)[0], 2);
      *step = Stream::Never;
    }
  }
}

// A limit of 0 components means 1, since the initial approximation has one.
TEST(Budget, TakesNoComponentForOne)
{
  const Tetrahedralization mesh = RowBetweenFaces(8);
  EXPECT_EQ(CarveWith(mesh, InOrder(mesh, { 0, -1, -1 })).Step,
    CarveWith(mesh, InOrder(mesh, { 1, -1, -1 })).Step);
}

// A void is opened only if the budget has room for it.
TEST(Budget, OpensNoVoidBeyondIt)
{
  const Tetrahedralization mesh = small::HollowTetrahedron();
  CarveOptions options;
  options.Budget = { -1, -1, 0 };
  const Stream stream = small::Carved(mesh, options);
  EXPECT_EQ(stream.Step[12], Stream::Never);
  EXPECT_EQ(stream.LastStep(), 0);
  options.Budget = { -1, -1, 1 };
  EXPECT_EQ(small::Carved(mesh, options).Step[12], 1);
}

// Cells that are deferred to the end have neither a step nor a priority nor a depth, like all cells
// that stay.
TEST(Budget, LeavesNothingOfWhatStays)
{
  const Tetrahedralization mesh = RowBetweenFaces(8);
  const Stream stream = CarveWith(mesh, InOrder(mesh, { 1, -1, -1 }));
  int left = 0;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    if (stream.Step[cell] == Stream::Never)
    {
      ++left;
      EXPECT_TRUE(std::isnan(stream.Priority[cell]));
      EXPECT_EQ(stream.Depth[cell], 0.0);
    }
  }
  EXPECT_GT(left, 0);
}
