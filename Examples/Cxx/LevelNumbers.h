// SPDX-License-Identifier: BSD-3-Clause
#ifndef LevelNumbers_h
#define LevelNumbers_h

#include "vtk_jsoncpp.h"

#include <string>

class vtkPolyData;

/**
 * The numbers of a level as a JSON object with the keys step, vertices, triangles, components,
 * tunnels, voids, feature_size and error. Unknown numbers are null.
 */
Json::Value GetLevelNumbers(vtkPolyData* level);

/** A JSON text, on one line if `indentation` is empty. */
std::string ToText(const Json::Value& value, const std::string& indentation);

#endif
