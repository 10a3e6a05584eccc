// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Notes for the user: sentences in the field data of port 0.
 */
#ifndef CarverNotes_h
#define CarverNotes_h

#include "Core/Protocol/Protocol.h"

#include <string>
#include <vector>

class vtkFieldData;

/**
 * Adds notes on how the helper program has decomposed a mesh (dimension 3) or contours (2), unless
 * the first attempt succeeded.
 */
void DescribeDecomposition(
  const carving::Reply& reply, int dimension, std::vector<std::string>& notes);

/** Writes the notes, if there are any, as the string array `Notes`. */
void WriteNotes(const std::vector<std::string>& notes, vtkFieldData* fieldData);

#endif
