// SPDX-License-Identifier: BSD-3-Clause
#include "LevelSelection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace carving
{

int LastStepWithin(const std::vector<int>& counts, double limit)
{
  const auto exceeding =
    std::find_if(counts.begin(), counts.end(), [limit](int count) { return count > limit; });
  return static_cast<int>(exceeding - counts.begin()) - 1;
}

std::vector<int> SpreadLevels(const Profile& profile, int count)
{
  const int last = profile.LastStep();
  std::set<int> steps = { last };
  if (count > 1)
  {
    steps.insert(0);
  }
  const double first = profile.Vertices.front();
  const double ratio = profile.Vertices.back() / first;
  for (int i = 1; i < count - 1; ++i)
  {
    const double target = first * std::pow(ratio, static_cast<double>(i) / (count - 1));
    steps.insert(std::max(0, LastStepWithin(profile.Vertices, target)));
  }
  const std::size_t wanted = std::min<std::size_t>(count, profile.Vertices.size());
  while (steps.size() < wanted)
  {
    // Halve the widest gap, the first of equal ones.
    int middle = 0, widest = 0;
    for (auto lower = steps.begin(), upper = std::next(lower); upper != steps.end();
         lower = upper++)
    {
      if (*upper - *lower > widest)
      {
        widest = *upper - *lower;
        middle = *lower + widest / 2;
      }
    }
    steps.insert(middle);
  }
  return { steps.begin(), steps.end() };
}

} // namespace carving
