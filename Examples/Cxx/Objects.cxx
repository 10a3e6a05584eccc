// SPDX-License-Identifier: BSD-3-Clause
#include "Objects.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"

namespace
{

/** Adds the objects of one input. Levels are polydata, so a block of multiblocks is a scene. */
void AddObjects(const std::string& input, vtkMultiBlockDataSet* tree, std::vector<Object>& objects)
{
  if (tree->GetNumberOfBlocks() == 0 || !vtkMultiBlockDataSet::SafeDownCast(tree->GetBlock(0)))
  {
    objects.push_back({ input, "", tree });
    return;
  }
  for (unsigned int i = 0; i < tree->GetNumberOfBlocks(); ++i)
  {
    objects.push_back(
      { input, GetBlockName(tree, i), vtkMultiBlockDataSet::SafeDownCast(tree->GetBlock(i)) });
  }
}

} // namespace

std::vector<Object> ListObjects(
  const std::vector<std::string>& inputs, vtkMultiBlockDataSet* output)
{
  std::vector<Object> objects;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    vtkDataObject* own = inputs.size() == 1 ? output : output->GetBlock(static_cast<unsigned>(i));
    AddObjects(inputs[i], vtkMultiBlockDataSet::SafeDownCast(own), objects);
  }
  return objects;
}

void AddBlock(vtkMultiBlockDataSet* tree, const std::string& name, vtkDataObject* block)
{
  const unsigned int index = tree->GetNumberOfBlocks();
  tree->SetBlock(index, block);
  tree->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name);
}

std::string GetBlockName(vtkMultiBlockDataSet* tree, unsigned int block)
{
  const char* name =
    tree->HasMetaData(block) ? tree->GetMetaData(block)->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "";
}

std::vector<std::string> GetNotes(vtkMultiBlockDataSet* output)
{
  std::vector<std::string> notes;
  auto* array = vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("Notes"));
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    notes.push_back(array->GetValue(i));
  }
  return notes;
}
