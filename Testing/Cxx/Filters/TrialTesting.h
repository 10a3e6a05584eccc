// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Trials for simplified levels, and a carving that they may come from.
 */
#ifndef TrialTesting_h
#define TrialTesting_h

#include "Session/LevelTrials.h"

#include <utility>
#include <vector>

constexpr int LastStep = 100;
constexpr int VerticesOfM = 10000;

/** A number of vertices that a decimated step has reached, and its distance from M. */
using Reached = std::pair<double, double>;

LevelTrial MakeTrial(int step, const std::vector<Reached>& surfaces, double leastVertices = 4.0);

/** Targets for numbers of vertices, at any step. */
std::vector<carving::SimplifiedTarget> MakeTargets(const std::vector<double>& numbers);

carving::Profile TunnelAtEachStep();

#endif
