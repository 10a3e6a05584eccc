// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The children of any composite data set, whatever its class.
 */
#ifndef CompositeTree_h
#define CompositeTree_h

#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiBlockDataSet;

struct CompositeChild
{
  vtkDataObject* Data; ///< null for a null child
  std::string Name;    ///< empty if the child has no name

  /**
   * The words with which messages about the child begin, after those about its parent: the name, or
   * the index if there is none.
   */
  std::string Where(const std::string& ofParent, std::size_t index) const
  {
    return ofParent + "Block " + (this->Name.empty() ? std::to_string(index) : this->Name) + ": ";
  }
};

/**
 * Fills `children` with the blocks, pieces, partitions or partitioned data sets of a composite.
 * Returns false for a composite without such children, AMR data for example.
 */
bool GetChildren(vtkDataObject* composite, std::vector<CompositeChild>& children);

/** Gives a block its name, unless the name is empty. */
void SetBlockName(vtkMultiBlockDataSet* parent, unsigned int block, const std::string& name);

#endif
