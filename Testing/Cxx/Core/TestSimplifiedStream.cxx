// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The selection of simplified levels of a stream.
 */
#include "Core/Measure/SimplifiedStream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace carving;

namespace
{

DecimatedStep MakeStep(int step, int vertices, int collapses)
{
  DecimatedStep result;
  result.Step = step;
  result.Chain.Vertices = vertices;
  result.Chain.Triangles = 2 * vertices - 4; // a sphere
  result.Chain.Collapses = collapses;
  return result;
}

/** Two steps: step 10 with 1,000 to 100 vertices, and the hull with 50 to 4. */
SimplifiedStream MakeStream()
{
  SimplifiedStream stream;
  stream.Steps = { MakeStep(10, 1000, 900), MakeStep(0, 50, 46) };
  stream.Levels = { { 1, 20, 4.0, 10, 30.0 }, { 0, 800, 2.0, 10, 200.0 },
    { 0, 500, 1.0, 10, 500.0 } };
  return stream;
}

SelectedLevel Select(const SimplifiedStream& stream, double target,
  LevelTarget type = LevelTarget::Vertices, int lastStep = 10)
{
  return SelectSimplifiedLevel(stream, { type, lastStep, target, {} });
}

int CountVertices(const SimplifiedStream& stream, const SimplifiedLevel& level)
{
  return stream.Steps[level.Chain].Chain.Vertices - level.Collapses;
}

} // namespace

// A target that a level was made for gives that level, with its error.
TEST(SimplifiedStream, GivesWhatWasMade)
{
  const SimplifiedStream stream = MakeStream();
  for (const SimplifiedLevel& made : stream.Levels)
  {
    const auto [level, problem] = Select(stream, made.Target);
    EXPECT_EQ(problem, "");
    EXPECT_EQ(level.Chain, made.Chain);
    EXPECT_EQ(level.Collapses, made.Collapses);
    EXPECT_EQ(level.Error, made.Error);
  }
}

// A number between two targets is given by the step of the larger one, and by that of the smaller
// one if that is out of reach.
TEST(SimplifiedStream, GivesNumbersBetweenTargets)
{
  const SimplifiedStream stream = MakeStream();
  const std::pair<int, int> numbersAndSteps[] = { { 700, 0 }, { 300, 0 }, { 150, 0 }, { 99, 1 },
    { 40, 1 }, { 7, 1 } };
  for (const auto& [number, step] : numbersAndSteps)
  {
    const auto [level, problem] = Select(stream, number);
    EXPECT_EQ(problem, "");
    EXPECT_EQ(level.Chain, step) << number;
    EXPECT_EQ(CountVertices(stream, level), std::min(number, step == 0 ? 1000 : 50));
    EXPECT_TRUE(std::isnan(level.Error));
  }
}

// A number above those of the step that was best is given by a later step.
TEST(SimplifiedStream, GivesNumbersAboveTheBestStep)
{
  SimplifiedStream stream = MakeStream();
  stream.Levels.resize(1); // of the hull alone
  EXPECT_EQ(Select(stream, 45.0).Level.Chain, 1);
  EXPECT_EQ(Select(stream, 60.0).Level.Chain, 1); // below what step 10 can be brought to
  const SimplifiedLevel level = Select(stream, 400.0).Level;
  EXPECT_EQ(level.Chain, 0);
  EXPECT_EQ(CountVertices(stream, level), 400);
}

// Triangles can be asked for where vertices were, and an odd number is rounded down.
TEST(SimplifiedStream, CountsTrianglesToo)
{
  const SimplifiedStream stream = MakeStream();
  EXPECT_EQ(CountVertices(stream, Select(stream, 601, LevelTarget::Triangles).Level), 302);
  EXPECT_EQ(Select(stream, 396, LevelTarget::Triangles).Level.Error, 2.0); // 200 vertices
}

// An error bound is given by the coarsest level within it; a smaller bound than all gives the
// closest level and a sentence.
TEST(SimplifiedStream, GivesErrorBounds)
{
  const SimplifiedStream stream = MakeStream();
  EXPECT_EQ(Select(stream, 3.0, LevelTarget::ErrorBound).Level.Error, 2.0);
  const auto [closest, problem] = Select(stream, 0.5, LevelTarget::ErrorBound);
  EXPECT_EQ(closest.Error, 1.0);
  EXPECT_NE(problem.find("within 1."), std::string::npos);
}

// The level closest to the mesh may be a coarse one. An unknown error is no reason to take a level.
TEST(SimplifiedStream, GivesTheClosestOfThoseOutOfBound)
{
  SimplifiedStream stream = MakeStream();
  stream.Levels[1].Error = 0.8;
  stream.Levels[2].Error = 1.0;
  EXPECT_EQ(Select(stream, 0.5, LevelTarget::ErrorBound).Level.Error, 0.8);
  stream.Levels[0].Error = std::nan("");
  EXPECT_EQ(Select(stream, 0.5, LevelTarget::ErrorBound).Level.Error, 0.8);
}

// A stream without simplified levels gives no step for an error bound: a warning follows instead.
TEST(SimplifiedStream, GivesNoCarvedStepWithoutLevels)
{
  Profile profile;
  profile.Error = { 1.0, 0.5, 0.0 };
  EXPECT_EQ(
    FindCarvedStepWithin(SimplifiedStream(), profile, { LevelTarget::ErrorBound, 2, 0.6, {} }), -1);
}

// A bound that no simplified level meets gets a step as carved, no earlier than those of simplified
// levels, so that pieces never merge from one bound to a smaller one.
TEST(SimplifiedStream, GivesCarvedStepsWithinABound)
{
  const SimplifiedStream stream = MakeStream(); // levels of steps 0 and 10, within 1 at best
  Profile profile;
  profile.Error = { 9.0, 8.0, 0.3, 7.0, 6.0, 5.0, 5.0, 5.0, 5.0, 5.0, 5.0, 0.7, 0.2, 0.4, 0.0 };
  const auto find = [&](double bound) {
    return FindCarvedStepWithin(stream, profile, { LevelTarget::ErrorBound, 14, bound, {} });
  };
  EXPECT_EQ(find(0.8), 11);
  EXPECT_EQ(find(0.5), 12);
  EXPECT_EQ(find(0.3), 12);
  EXPECT_EQ(find(0.0), 14);
  EXPECT_EQ(find(-1.0), -1);
  EXPECT_EQ(FindCarvedStepWithin(stream, profile, { LevelTarget::Vertices, 14, 0.5, {} }), -1);
  profile.Error.clear();
  EXPECT_EQ(find(0.5), -1);
}

// A number below all gives the level that comes closest, and a sentence.
TEST(SimplifiedStream, SaysWhatIsOutOfReach)
{
  const auto [level, problem] = Select(MakeStream(), 3.0);
  EXPECT_EQ(level.Chain, 1);
  EXPECT_NE(problem.find("out of reach"), std::string::npos);
}

// Where no step gets down to a number, the level with the fewest vertices is given, whatever it was
// made for.
TEST(SimplifiedStream, GivesTheCoarsestOfThoseOutOfReach)
{
  SimplifiedStream stream;
  stream.Steps = { MakeStep(5, 1000, 765), MakeStep(10, 2000, 1500) }; // to 235, and to 500
  stream.Levels = { { 0, 765, 4.0, 10, 50.0 }, { 1, 1500, 2.0, 10, 500.0 } };
  for (const double number : { 20.0, 50.0, 100.0, 234.0 })
  {
    const auto [level, problem] = Select(stream, number);
    EXPECT_EQ(CountVertices(stream, level), 235) << number;
    EXPECT_EQ(level.Error, 4.0);
    EXPECT_NE(problem, "");
  }
  EXPECT_EQ(Select(stream, 235.0).Problem, "");
}

// Up to an early step, only levels of steps up to that one count; without any, there is none.
TEST(SimplifiedStream, ObeysTheLastStep)
{
  const SimplifiedStream stream = MakeStream();
  EXPECT_EQ(Select(stream, 500.0, LevelTarget::Vertices, 5).Level.Chain, 1);
  const auto [level, problem] = Select({}, 500.0);
  EXPECT_EQ(level.Chain, -1);
  EXPECT_NE(problem, "");
}

// Of two numbers, the lower one never gets a level of a later step, whatever levels were made.
TEST(SimplifiedStream, KeepsStepsInOrder)
{
  std::mt19937 random(11);
  for (int run = 0; run < 300; ++run)
  {
    SimplifiedStream stream;
    const int count = 1 + random() % 5;
    for (int i = 0; i < count; ++i)
    {
      const int vertices = 100 + random() % 1000;
      stream.Steps.push_back(MakeStep(5 * i, vertices, random() % vertices));
    }
    std::vector<int> chains(1 + random() % 6);
    std::generate(chains.begin(), chains.end(), [&] { return random() % count; });
    std::sort(chains.begin(), chains.end());
    double target = 0.0;
    for (const int chain : chains) // from coarse to fine
    {
      target += 10 + random() % 300;
      const CollapseChain& from = stream.Steps[chain].Chain;
      const int collapses = std::clamp(from.Vertices - static_cast<int>(target), 0, from.Collapses);
      stream.Levels.push_back({ chain, collapses, 1.0, 100, target });
    }
    int lastStep = 100;
    for (double number = 1500.0; number > 0.0; number -= 7.0)
    {
      const SelectedLevel selected = Select(stream, number, LevelTarget::Vertices, 100);
      EXPECT_TRUE(CountVertices(stream, selected.Level) <= number || !selected.Problem.empty());
      EXPECT_LE(stream.Steps[selected.Level.Chain].Step, lastStep);
      lastStep = stream.Steps[selected.Level.Chain].Step;
    }
  }
}
