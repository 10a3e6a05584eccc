// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which process of a parallel run carves which object.
 */
#ifndef LeafPlacement_h
#define LeafPlacement_h

#include <vector>

/**
 * Returns the process that carves each leaf. A leaf stays with its owner unless the owner would get
 * clearly more than its share of all costs. `costs` are estimates in any unit; `owners` are
 * processes. The result depends on the arguments alone, so that all processes agree on it.
 */
std::vector<int> PlaceLeaves(
  const std::vector<double>& costs, const std::vector<int>& owners, int numberOfProcesses);

#endif
