// SPDX-License-Identifier: BSD-3-Clause
#ifndef OptionValues_h
#define OptionValues_h

#include <string>
#include <vector>

struct Options;
struct vtkCarverProperty;

/** A property by its name, which has to exist. */
const vtkCarverProperty& FindProperty(const char* name);

/** The types of level targets, each of which has an option. */
const std::vector<std::string>& GetTargetTypes();

/**
 * Takes the targets of a type, and a number of vertices as a limit for those of another type.
 * Returns an empty string, or a description of the mistake.
 */
std::string TakeTargets(int type, const std::string& text, Options& options);

/** Reads the value of a property. Returns an empty string, or a description of the mistake. */
std::string ParseValue(const std::string& option, const vtkCarverProperty& property,
  const std::string& text, double& value);

#endif
