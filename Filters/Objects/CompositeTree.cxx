// SPDX-License-Identifier: BSD-3-Clause
#include "Objects/CompositeTree.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"

namespace
{

std::string GetName(vtkInformation* metaData)
{
  const char* name = metaData ? metaData->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "";
}

} // namespace

bool GetChildren(vtkDataObject* composite, std::vector<CompositeChild>& children)
{
  children.clear();
  auto* tree = vtkDataObjectTree::SafeDownCast(composite);
  if (!tree)
  {
    return false;
  }
  for (const auto& child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
  {
    // GetMetaData alone would add metadata to the input.
    children.push_back(
      { child.GetDataObject(), GetName(child.HasMetaData() ? child.GetMetaData() : nullptr) });
  }
  return true;
}

void SetBlockName(vtkMultiBlockDataSet* parent, unsigned int block, const std::string& name)
{
  if (!name.empty())
  {
    parent->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name);
  }
}
