// SPDX-License-Identifier: BSD-3-Clause
#ifndef Help_h
#define Help_h

#include <string>

struct vtkCarverProperty;

/**
 * The name of a property, or of a value, as `carve` spells it: "depth-exponent" for
 * "DepthExponent".
 */
std::string ToOption(const std::string& name);

/**
 * The values of a property as `carve` spells them, with | between them; empty if they are numbers.
 */
std::string ListChoices(const vtkCarverProperty& property);

/** The manual page. */
std::string GetHelp();

#endif
