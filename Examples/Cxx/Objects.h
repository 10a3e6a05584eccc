// SPDX-License-Identifier: BSD-3-Clause
#ifndef Objects_h
#define Objects_h

#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiBlockDataSet;

/** The levels of one mesh. */
struct Object
{
  std::string Input; ///< the file, as it was given
  std::string Block; ///< the name of the block in the file; empty if the file is a single mesh
  vtkMultiBlockDataSet* Levels;
};

/** The objects of a carver's output. It has a block for each input if there are several. */
std::vector<Object> ListObjects(
  const std::vector<std::string>& inputs, vtkMultiBlockDataSet* output);

/** Adds a block with a name. */
void AddBlock(vtkMultiBlockDataSet* tree, const std::string& name, vtkDataObject* block);

/** The name of a block; empty if it has none. */
std::string GetBlockName(vtkMultiBlockDataSet* tree, unsigned int block);

/** The notes in the field data of a carver's output or of an object in it. */
std::vector<std::string> GetNotes(vtkMultiBlockDataSet* output);

#endif
