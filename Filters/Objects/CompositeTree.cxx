// SPDX-License-Identifier: BSD-3-Clause
#include "Objects/CompositeTree.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

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
  // GetMetaData alone would add metadata to the input.
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(composite))
  {
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      children.push_back({ blocks->GetBlock(i),
        GetName(blocks->HasMetaData(i) ? blocks->GetMetaData(i) : nullptr) });
    }
    return true;
  }
  if (auto* pieces = vtkPartitionedDataSet::SafeDownCast(composite))
  {
    for (unsigned int i = 0; i < pieces->GetNumberOfPartitions(); ++i)
    {
      children.push_back({ pieces->GetPartitionAsDataObject(i),
        GetName(pieces->HasMetaData(i) ? pieces->GetMetaData(i) : nullptr) });
    }
    return true;
  }
  if (auto* sets = vtkPartitionedDataSetCollection::SafeDownCast(composite))
  {
    for (unsigned int i = 0; i < sets->GetNumberOfPartitionedDataSets(); ++i)
    {
      children.push_back({ sets->GetPartitionedDataSet(i),
        GetName(sets->HasMetaData(i) ? sets->GetMetaData(i) : nullptr) });
    }
    return true;
  }
  return false;
}

void SetBlockName(vtkMultiBlockDataSet* parent, unsigned int block, const std::string& name)
{
  if (!name.empty())
  {
    parent->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name);
  }
}
