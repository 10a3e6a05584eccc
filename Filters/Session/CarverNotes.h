// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the outputs say of how they were made.
 */
#ifndef CarverNotes_h
#define CarverNotes_h

#include "Session/CarverSettings.h"

#include <string>
#include <vector>

class vtkFieldData;

/** Adds to the texts what the user should know besides and writes them as the string array `Notes`. */
void AddNotes(std::vector<std::string> texts, const carving::Reply& reply, int guessedRegions,
  bool nothingToCarve, vtkFieldData* fieldData);

/**
 * The settings that a stream has been made with, by the names of the filter's properties, and how its mesh
 * was tetrahedralized.
 */
void AddSettings(
  const CarverSettings& settings, const carving::Reply& reply, vtkFieldData* fieldData);

#endif
