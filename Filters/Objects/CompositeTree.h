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
  vtkDataObject* Data; ///< null where the composite has a null child
  std::string Name;    ///< empty if it has none
};

/**
 * Fills `children` with blocks, pieces, partitions or partitioned data sets. Returns false for a
 * composite that is not a tree of those (AMR, say).
 */
bool GetChildren(vtkDataObject* composite, std::vector<CompositeChild>& children);

/** Names a block, unless the name is empty. */
void SetBlockName(vtkMultiBlockDataSet* parent, unsigned int block, const std::string& name);

#endif
