// SPDX-License-Identifier: BSD-3-Clause
#ifndef OptionChecks_h
#define OptionChecks_h

#include <string>

struct Options;

/** Returns an empty string, or a description of options that contradict each other. */
std::string CheckCombination(const Options& options);

/** Returns an empty string, or a description of options that contours exclude. */
std::string CheckContours(const Options& options);

/**
 * Returns an empty string, or a description of options that an input with several meshes excludes.
 */
std::string CheckSeveralMeshes(const Options& options, const std::string& input);

#endif
