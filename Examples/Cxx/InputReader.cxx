// SPDX-License-Identifier: BSD-3-Clause
#include "InputReader.h"

#include "ErrorLog.h"
#include "FileName.h"
#include "GltfReader.h"
#include "Objects.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPartitionedDataSetCollectionReader.h"

namespace
{

/** Adds all data of a tree, but no empty polydata, under the names of their branches. */
void AddLeaves(vtkDataObjectTree* tree, const std::string& path, vtkMultiBlockDataSet* leaves)
{
  vtkSmartPointer<vtkDataObjectTreeIterator> block;
  block.TakeReference(tree->NewTreeIterator());
  block->VisitOnlyLeavesOff();
  block->TraverseSubTreeOff();
  for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    vtkDataObject* data = block->GetCurrentDataObject();
    const char* name = block->HasCurrentMetaData()
      ? block->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
      : nullptr;
    std::string full = path;
    if (name && *name)
    {
      full += (path.empty() ? "" : "/") + std::string(name);
    }
    else if (path.empty())
    {
      full = "Block " + std::to_string(leaves->GetNumberOfBlocks());
    }
    auto* inner = vtkDataObjectTree::SafeDownCast(data);
    auto* mesh = vtkPolyData::SafeDownCast(data);
    if (inner)
    {
      AddLeaves(inner, full, leaves);
    }
    else if (!mesh || mesh->GetNumberOfCells() > 0)
    {
      AddBlock(leaves, full, data);
    }
  }
}

template <class Reader>
std::string ReadTree(const std::string& fileName, ErrorLog* log, vtkMultiBlockDataSet* leaves)
{
  const std::size_t errorsBefore = log->Errors.size();
  vtkNew<Reader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  AddLeaves(vtkDataObjectTree::SafeDownCast(reader->GetOutputDataObject(0)), "", leaves);
  return log->GetErrorSince(errorsBefore);
}

} // namespace

std::string ReadInput(
  const std::string& fileName, Wanted wanted, ErrorLog* log, vtkSmartPointer<vtkDataObject>& input)
{
  using Read = std::string (*)(const std::string&, ErrorLog*, vtkMultiBlockDataSet*);
  const std::string extension = FileName::GetExtension(fileName);
  const Read read = extension == ".vtm" ? &ReadTree<vtkXMLMultiBlockDataReader>
    : extension == ".vtpc"              ? &ReadTree<vtkXMLPartitionedDataSetCollectionReader>
    : extension == ".glb" || extension == ".gltf" ? &GltfReader::Read
                                                  : nullptr;
  if (!read)
  {
    vtkNew<vtkPolyData> mesh;
    input = mesh;
    return ReadMesh(fileName, wanted, log, mesh);
  }
  vtkNew<vtkMultiBlockDataSet> meshes;
  std::string error = CheckFile(fileName);
  error = error.empty() ? read(fileName, log, meshes) : error;
  // The filter says what is wrong with other data.
  const std::vector<vtkPolyData*> all = vtkCompositeDataSet::GetDataSets<vtkPolyData>(meshes);
  if (error.empty() && all.size() == meshes->GetNumberOfBlocks())
  {
    error = CheckCells(all, wanted);
  }
  const bool isSingle =
    meshes->GetNumberOfBlocks() == 1 && vtkPolyData::SafeDownCast(meshes->GetBlock(0));
  input = isSingle ? meshes->GetBlock(0) : meshes.Get();
  return error;
}
