// SPDX-License-Identifier: BSD-3-Clause
#include "TrialTesting.h"

using carving::LevelTarget;
using carving::SimplifiedTarget;

LevelTrial MakeTrial(int step, const std::vector<Reached>& surfaces, double leastVertices)
{
  LevelTrial trial;
  trial.LastStep = LastStep;
  trial.Step = step;
  trial.LeastVertices = leastVertices;
  trial.Result.Chain.Vertices = VerticesOfM;
  for (const auto& [vertices, error] : surfaces)
  {
    trial.Targets.push_back({ vertices });
    trial.Result.Surfaces.push_back({ VerticesOfM - static_cast<int>(vertices), true, error });
  }
  return trial;
}

std::vector<SimplifiedTarget> MakeTargets(const std::vector<double>& numbers)
{
  std::vector<SimplifiedTarget> targets;
  for (const double number : numbers)
  {
    targets.push_back({ LevelTarget::Vertices, LastStep, number, {} });
  }
  return targets;
}

carving::Profile TunnelAtEachStep()
{
  carving::Profile profile;
  for (int step = 0; step <= LastStep; ++step)
  {
    profile.Vertices.push_back(VerticesOfM - LastStep + step);
    profile.Components.push_back(1);
    profile.Tunnels.push_back(step);
    profile.Voids.push_back(0);
    profile.Error.push_back(LastStep - step);
  }
  return profile;
}
