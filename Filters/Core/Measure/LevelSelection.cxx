// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Measure/LevelSelection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <queue>
#include <set>
#include <sstream>
#include <utility>

namespace carving
{

namespace
{

/** Numbers of vertices and steps are written out in messages: 1000000, not 1e+06. */
constexpr int DigitsOfCounts = 10;

/**
 * The last step such that all counts up to it are at most `limit`; -1 if even that of C0 exceeds
 * it.
 */
int LastStepWithin(const std::vector<int>& counts, double limit)
{
  const auto exceeding =
    std::find_if(counts.begin(), counts.end(), [limit](int count) { return count > limit; });
  return static_cast<int>(exceeding - counts.begin()) - 1;
}

SelectedStep SelectByCount(const std::vector<int>& counts, double target, const char* what)
{
  const int step = LastStepWithin(counts, target);
  if (step >= 0)
  {
    return { step, {} };
  }
  std::ostringstream problem;
  problem.precision(DigitsOfCounts);
  problem << "The target of " << target << " " << what << " is below the " << counts.front()
          << " of the initial approximation, which is given instead.";
  return { 0, problem.str() };
}

SelectedStep SelectByError(const Profile& profile, double target)
{
  if (profile.Error.empty())
  {
    return { profile.LastStep(),
      "The stream does not say how far its levels are from the mesh: carve it with ComputeError "
      "on. "
      "The last level, the closest, is given instead." };
  }
  const auto& errors = profile.Error;
  const auto last =
    std::find_if(errors.rbegin(), errors.rend(), [target](double error) { return error > target; });
  if (last != errors.rbegin())
  {
    return { static_cast<int>(errors.rend() - last), {} };
  }
  std::ostringstream problem;
  problem << "No level is as close as " << target << ": the last, which is given instead, is up to "
          << errors.back() << " away from the mesh.";
  return { profile.LastStep(), problem.str() };
}

SelectedStep SelectNearest(int last, double target)
{
  const double step = std::floor(target);
  if (step >= 0.0 && step <= last)
  {
    return { static_cast<int>(step), {} };
  }
  std::ostringstream problem;
  problem.precision(DigitsOfCounts);
  problem << "There is no step " << target << ": the stream ends with step " << last
          << ". The nearest is given instead.";
  return { step > last ? last : 0, problem.str() };
}

/**
 * Bisects the widest gap between steps, the first of equal ones, until there are as many steps as
 * wanted.
 */
void HalveGaps(int wanted, std::set<int>& steps)
{
  using Gap = std::pair<int, int>; // the width and the negative of the first step
  std::priority_queue<Gap> gaps;
  for (auto lower = steps.begin(), upper = std::next(lower); upper != steps.end(); lower = upper++)
  {
    gaps.push({ *upper - *lower, -*lower });
  }
  while (static_cast<int>(steps.size()) < wanted)
  {
    const auto [width, begin] = gaps.top();
    const int half = width / 2;
    gaps.pop();
    steps.insert(half - begin);
    gaps.push({ half, begin });
    gaps.push({ width - half, begin - half });
  }
}

} // namespace

const char* LevelTargetName(LevelTarget target)
{
  switch (target)
  {
    case LevelTarget::Triangles:
      return "TRIANGLES";
    case LevelTarget::FeatureSize:
      return "FEATURE_SIZE";
    case LevelTarget::Tunnels:
      return "TUNNELS";
    case LevelTarget::Components:
      return "COMPONENTS";
    case LevelTarget::ErrorBound:
      return "ERROR_BOUND";
    case LevelTarget::Step:
      return "STEP";
    default:
      return "VERTICES";
  }
}

SelectedStep SelectStep(const Profile& profile, LevelTarget type, double target)
{
  switch (type)
  {
    case LevelTarget::Triangles:
      return SelectByCount(profile.Triangles, target, "triangles");
    case LevelTarget::FeatureSize:
    {
      const auto& sizes = profile.FeatureSize; // does not increase; infinite at first
      const auto small =
        std::find_if(sizes.begin(), sizes.end(), [target](double size) { return size <= target; });
      return { std::max(0, static_cast<int>(small - sizes.begin()) - 1), {} };
    }
    case LevelTarget::Tunnels:
      return SelectByCount(profile.Tunnels, target, "tunnels");
    case LevelTarget::Components:
      return SelectByCount(profile.Components, target, "components");
    case LevelTarget::ErrorBound:
      return SelectByError(profile, target);
    case LevelTarget::Step:
      return SelectNearest(profile.LastStep(), target);
    default:
      return SelectByCount(profile.Vertices, target, "vertices");
  }
}

std::array<double, 2> GetTargetRange(const Profile& profile, LevelTarget type)
{
  const auto rangeOf = [](const std::vector<int>& counts)
  {
    return std::array<double, 2>{ static_cast<double>(counts.front()),
      static_cast<double>(*std::max_element(counts.begin(), counts.end())) };
  };
  switch (type)
  {
    case LevelTarget::Triangles:
      return rangeOf(profile.Triangles);
    case LevelTarget::FeatureSize:
    {
      // The feature size of C0 is infinite.
      const auto& sizes = profile.FeatureSize;
      return sizes.size() > 1 ? std::array<double, 2>{ sizes.back(), sizes[1] }
                              : std::array<double, 2>{ 0.0, 0.0 };
    }
    case LevelTarget::Tunnels:
      return rangeOf(profile.Tunnels);
    case LevelTarget::Components:
      return rangeOf(profile.Components);
    case LevelTarget::ErrorBound:
    {
      const auto& errors = profile.Error;
      return errors.empty()
        ? std::array<double, 2>{ 0.0, 0.0 }
        : std::array<double, 2>{ errors.back(), *std::max_element(errors.begin(), errors.end()) };
    }
    case LevelTarget::Step:
      return { 0.0, static_cast<double>(profile.LastStep()) };
    default:
      return rangeOf(profile.Vertices);
  }
}

std::vector<int> SpreadLevels(const Profile& profile, int count)
{
  const int numberOfSteps = static_cast<int>(profile.Vertices.size());
  if (count >= numberOfSteps)
  {
    std::vector<int> all(numberOfSteps);
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  if (count == 1)
  {
    return { profile.LastStep() };
  }
  std::set<int> steps = { 0, profile.LastStep() };
  // Running maxima, which are sorted.
  std::vector<int> most(profile.Vertices.size());
  std::partial_sum(profile.Vertices.begin(), profile.Vertices.end(), most.begin(),
    [](int a, int b) { return std::max(a, b); });
  const double first = profile.Vertices.front();
  const double ratio = profile.Vertices.back() / first;
  for (int i = 1; i < count - 1; ++i)
  {
    const double target = first * std::pow(ratio, static_cast<double>(i) / (count - 1));
    const auto exceeding = std::upper_bound(most.begin(), most.end(), target);
    steps.insert(std::max(0, static_cast<int>(exceeding - most.begin()) - 1));
  }
  HalveGaps(count, steps);
  return { steps.begin(), steps.end() };
}

} // namespace carving
