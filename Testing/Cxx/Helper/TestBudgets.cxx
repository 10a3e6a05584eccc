// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Budgets on random meshes and on meshes of known topology, checked against Betti numbers from
 * boundary matrices, which are independent of how carving decides.
 */
#include "Core/Mesh/BettiNumbers.h"
#include "Figures.h"
#include "GluedCount.h"
#include "HelperRun.h"
#include "Homology.h"
#include "RandomModels.h"
#include "RealMeshes.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace carving;

namespace
{

const int NumberOfMeshes = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_BUDGETS", 60);

constexpr homology::BettiNumbers Ball = { 1, 0, 0, 0 };

struct Tetrahedra
{
  Tetrahedralization Mesh;
  Classification Regions;
};

Tetrahedra Tetrahedralize(const TriangleMesh& mesh, Conformity conformity = Conformity::Auto,
  SolidRule rule = SolidRule::NonzeroWinding)
{
  // Without refinement: small enough for Betti numbers at every step.
  const Tetrahedralization result = GetReply(mesh, conformity).Result;
  return { result, Classify(result, rule) };
}

Stream CarveWithin(const Tetrahedra& tetrahedra, CarveOptions options, const BettiNumbers& budget)
{
  options.Budget = budget;
  Stream stream;
  EXPECT_TRUE(Carve(tetrahedra.Mesh, tetrahedra.Regions, options, stream));
  return stream;
}

template <int D>
homology::BettiNumbers BettiNumbersAt(const Decomposition<D>& mesh, const Stream& stream, int step)
{
  return homology::ComputeBettiNumbers(homology::ClosedComplex(mesh, stream, step));
}

/**
 * Expects every step to obey the budget, by an independent count. Returns the last step's numbers.
 */
template <int D>
homology::BettiNumbers ExpectToObey(
  const Decomposition<D>& mesh, const Stream& stream, const BettiNumbers& budget)
{
  homology::BettiNumbers numbers = Ball;
  for (int step = 0; step <= stream.LastStep() && !testing::Test::HasFailure(); ++step)
  {
    numbers = BettiNumbersAt(mesh, stream, step);
    for (std::size_t i = 0; i < budget.size(); ++i)
    {
      EXPECT_TRUE(budget[i] < 0 || numbers[i] <= budget[i])
        << "step " << step << ", number " << i << ": " << numbers[i] << " > " << budget[i];
    }
  }
  return numbers;
}

/**
 * Whether K of a step exceeds the budget, or the tetrahedra glued at faces have too many
 * components.
 */
bool Exceeds(
  const Tetrahedralization& mesh, const Stream& stream, int step, const BettiNumbers& budget)
{
  const homology::BettiNumbers numbers = BettiNumbersAt(mesh, stream, step);
  const std::array<int, 3> most = { std::max(numbers[0], CountGlued(mesh, stream, step)),
    numbers[1], numbers[2] };
  for (std::size_t i = 0; i < budget.size(); ++i)
  {
    if (budget[i] >= 0 && most[i] > budget[i])
    {
      return true;
    }
  }
  return false;
}

/**
 * Expects that no tetrahedron that adjoins the exterior could be carved alone within the budget.
 */
void ExpectNothingMoreToCarve(
  const Tetrahedra& tetrahedra, Stream stream, const BettiNumbers& budget)
{
  const Tetrahedralization& mesh = tetrahedra.Mesh;
  const auto isCarved = [&](int cell) { return cell < 0 || stream.Step[cell] != Stream::Never; };
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    const RegionKind kind = tetrahedra.Regions.Kind(cell);
    bool carvable = !isCarved(cell) && (kind == RegionKind::Outside || kind == RegionKind::Void);
    bool adjoins = false;
    for (int f = 0; f < 4; ++f)
    {
      adjoins = adjoins || (!mesh.Constraints.Has(cell, f) && isCarved(mesh.Neighbors[cell][f]));
    }
    if (!carvable || !adjoins)
    {
      continue;
    }
    stream.Step[cell] = 0;
    EXPECT_TRUE(Exceeds(mesh, stream, stream.LastStep(), budget)) << "cell " << cell;
    stream.Step[cell] = Stream::Never;
  }
}

CarveOptions DrawOptions(std::mt19937_64& random)
{
  CarveOptions options;
  options.Measure = static_cast<PriorityMeasure>(random() % 5);
  options.DepthExponent = static_cast<double>(random() % 2);
  options.BreadthRadius = random() % 3 == 0 ? 0.4 : 0.0;
  options.CarveExposed = random() % 2 == 0;
  return options;
}

/** Each number has no limit one time in four. At least one component. */
BettiNumbers DrawBudget(std::mt19937_64& random)
{
  BettiNumbers budget;
  for (int i = 0; i < 3; ++i)
  {
    const int limit = static_cast<int>(random() % 4);
    budget[i] = random() % 4 == 0 ? -1 : std::max(limit, i == 0 ? 1 : 0);
  }
  return budget;
}

/** A random mesh that is small enough for Betti numbers at every step. */
Tetrahedra DrawTetrahedra(std::mt19937_64& random)
{
  const auto rule = static_cast<SolidRule>(random() % 3);
  if (random() % 2 == 0)
  {
    return Tetrahedralize(models::Soup(2 + static_cast<int>(random() % 10), random),
      random() % 2 == 0 ? Conformity::Enclosing : Conformity::Auto, rule);
  }
  TriangleMesh mesh;
  do
  {
    mesh = models::MakeRandom(random).Mesh;
  } while (mesh.Triangles.size() > 300);
  return Tetrahedralize(mesh, Conformity::Auto, rule);
}

} // namespace

// Components, tunnels and voids stay within random budgets at every step, and at the end no
// tetrahedron that remains could be carved.
TEST(Budgets, AreObeyedOnRandomMeshes)
{
  std::mt19937_64 random(1847);
  for (int i = 0; i < NumberOfMeshes && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("random mesh " + std::to_string(i));
    const Tetrahedra tetrahedra = DrawTetrahedra(random);
    const CarveOptions options = DrawOptions(random);
    const BettiNumbers budget = DrawBudget(random);
    SCOPED_TRACE("budget " + std::to_string(budget[0]) + " " + std::to_string(budget[1]) + " " +
      std::to_string(budget[2]));
    const Stream stream = CarveWithin(tetrahedra, options, budget);
    ExpectToObey(tetrahedra.Mesh, stream, budget);
    for (int step = 0; step <= stream.LastStep(); step += 1 + stream.LastStep() / 10)
    {
      EXPECT_FALSE(Exceeds(tetrahedra.Mesh, stream, step, budget)) << "step " << step;
    }
    if (i % 3 == 0)
    {
      ExpectNothingMoreToCarve(tetrahedra, stream, budget);
    }
  }
}

// A budget that is never exceeded does not change the stream.
TEST(Budgets, ChangeNothingWhereTheyAreNotNeeded)
{
  std::mt19937_64 random(11);
  for (int i = 0; i < 20; ++i)
  {
    const Tetrahedra tetrahedra = DrawTetrahedra(random);
    const CarveOptions options = DrawOptions(random);
    const Stream without = CarveWithin(tetrahedra, options, { -1, -1, -1 });
    const Stream with = CarveWithin(tetrahedra, options, { 100000, 100000, 100000 });
    EXPECT_EQ(with.Step, without.Step);
    EXPECT_EQ(with.Depth, without.Depth);
  }
}

// With one component, no tunnel and no void, the last approximation of any mesh is a ball.
TEST(Budgets, WrapAnythingInABall)
{
  std::mt19937_64 random(22);
  for (int i = 0; i < NumberOfMeshes && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("random mesh " + std::to_string(i));
    const bool soup = i % 2 == 0;
    const Tetrahedra tetrahedra =
      Tetrahedralize(soup ? models::Soup(2 + static_cast<int>(random() % 60), random)
                          : models::MakeRandom(random).Mesh,
        i % 4 == 0 ? Conformity::Enclosing : Conformity::Auto);
    const Stream stream = CarveWithin(tetrahedra, DrawOptions(random), { 1, 0, 0 });
    EXPECT_EQ(BettiNumbersAt(tetrahedra.Mesh, stream, stream.LastStep()), Ball);
    EXPECT_FALSE(Exceeds(tetrahedra.Mesh, stream, stream.LastStep(), { 1, 0, 0 }));
  }
}

// A torus without a budget is a ball with a budget of no tunnels: all of it is carved except a lid.
TEST(Budgets, KeepATorusClosed)
{
  const Tetrahedra torus = Tetrahedralize(models::Torus(1.0, 0.4, 16, 8));
  const Stream open = CarveWithin(torus, {}, { -1, -1, -1 });
  EXPECT_EQ(
    BettiNumbersAt(torus.Mesh, open, open.LastStep()), (homology::BettiNumbers{ 1, 1, 0, 0 }));
  const BettiNumbers budget = { -1, 0, -1 };
  const Stream closed = CarveWithin(torus, {}, budget);
  EXPECT_EQ(ExpectToObey(torus.Mesh, closed, budget), Ball);
  const auto countCarved = [](const Stream& stream)
  {
    return std::count_if(stream.Step.begin(), stream.Step.end(),
      [](int step) { return step != carving::Stream::Never; });
  };
  // A lid over the hole needs only a fan of triangles as thick as a tetrahedron.
  EXPECT_GT(countCarved(closed), countCarved(open) / 2);
  EXPECT_LT(countCarved(closed), countCarved(open));
}

// Two spheres stay connected within a budget of one component, and are separate within one of two.
TEST(Budgets, KeepTwoSpheresTogether)
{
  const Tetrahedra spheres = Tetrahedralize(
    models::Joined(models::Sphere(2), models::Moved(models::Sphere(2), { 3, 0, 0 })));
  for (const int components : { 1, 2 })
  {
    const BettiNumbers budget = { components, -1, -1 };
    EXPECT_EQ(ExpectToObey(spheres.Mesh, CarveWithin(spheres, {}, budget), budget),
      (homology::BettiNumbers{ components, 0, 0, 0 }));
  }
}

// As many of four nested voids are opened as the budget has room for.
TEST(Budgets, LeaveShellsFilled)
{
  TriangleMesh mesh = models::Sphere(1);
  for (const double scale : { 0.8, 0.6, 0.4 })
  {
    mesh = models::Joined(mesh, models::Moved(models::Sphere(1), { 0, 0, 0 }, scale));
  }
  // Nothing is solid, so there are four voids: between the shells and within the innermost one.
  const Tetrahedra shells = Tetrahedralize(mesh, Conformity::Exact, SolidRule::SurfaceOnly);
  for (int voids = 0; voids <= 5; ++voids)
  {
    const BettiNumbers budget = { -1, -1, voids };
    const homology::BettiNumbers last =
      ExpectToObey(shells.Mesh, CarveWithin(shells, {}, budget), budget);
    EXPECT_EQ(last[2], std::min(voids, 4));
  }
}

// As many tunnels of a mesh of genus 12 are opened as the budget has room for.
TEST(Budgets, OpenSomeTunnelsOfManyOnly)
{
  const Tetrahedra scone = Tetrahedralize(models::Scone());
  for (const int tunnels : { 0, 3, 12 })
  {
    const BettiNumbers budget = { 1, tunnels, 0 };
    const Stream stream = CarveWithin(scone, {}, budget);
    const homology::BettiNumbers last = BettiNumbersAt(scone.Mesh, stream, stream.LastStep());
    EXPECT_EQ(last, (homology::BettiNumbers{ 1, tunnels, 0, 0 }));
  }
}

// Budgets hold in the plane, where the holes of a contour are its tunnels and there are no voids.
TEST(Budgets, AreObeyedInThePlane)
{
  std::mt19937_64 random(5);
  for (int i = 0; i < 40 && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("contours " + std::to_string(i));
    Job job;
    job.Kind = JobKind::Triangulate;
    std::uniform_real_distribution<double> unit;
    const int loops = 1 + static_cast<int>(random() % 8);
    for (int loop = 0; loop < loops; ++loop)
    {
      // Polygons around random centers. The last edge may be missing.
      const int corners = 3 + static_cast<int>(random() % 8);
      const int first = static_cast<int>(job.Contours.Points.size());
      const double x = 4.0 * unit(random), y = 4.0 * unit(random), radius = 0.2 + unit(random);
      for (int k = 0; k < corners; ++k)
      {
        const double angle = 6.283185307179586 * k / corners;
        job.Contours.Points.push_back(
          { x + radius * std::cos(angle), y + radius * std::sin(angle), 0.0 });
        if (k + 1 < corners || random() % 3 != 0)
        {
          job.Contours.Edges.push_back({ first + k, first + (k + 1) % corners });
        }
      }
    }
    const Decomposition<2> mesh = GetReply(job).Plane;
    const Classification regions = Classify(mesh, static_cast<SolidRule>(random() % 3));
    CarveOptions options = DrawOptions(random);
    options.Budget = DrawBudget(random);
    Stream stream;
    ASSERT_TRUE(Carve(mesh, regions, options, stream));
    EXPECT_EQ(ExpectToObey(mesh, stream, options.Budget)[2], 0);
    options.Budget = { 1, 0, 0 };
    ASSERT_TRUE(Carve(mesh, regions, options, stream));
    EXPECT_EQ(BettiNumbersAt(mesh, stream, stream.LastStep()), Ball);
  }
}

// The last step of a real mesh of many tunnels obeys any budget.
TEST(Budgets, AreObeyedOnCheese)
{
  const TriangleMesh mesh = ReadRealMesh("cheese.off");
  const Tetrahedra cheese = Tetrahedralize(mesh);
  for (const int tunnels : { 0, 10, GenusOf(mesh) })
  {
    const Stream stream = CarveWithin(cheese, {}, { -1, tunnels, -1 });
    const homology::BettiNumbers last = BettiNumbersAt(cheese.Mesh, stream, stream.LastStep());
    EXPECT_EQ(last, (homology::BettiNumbers{ 1, tunnels, 0, 0 }));
  }
}
