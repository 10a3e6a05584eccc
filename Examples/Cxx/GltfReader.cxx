// SPDX-License-Identifier: BSD-3-Clause
#include "GltfReader.h"

#include "ErrorLog.h"
#include "Objects.h"
#include "ReadCarefully.h"

#include "vtkAppendPolyData.h"
#include "vtkGLTFDocumentLoader.h"
#include "vtkGLTFReader.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cstdlib>

namespace
{

using Nodes = std::vector<vtkGLTFDocumentLoader::Node>;

/** The name of a node, which the reader calls "Node_" and its number. */
std::string GetNodeName(const std::string& block, const Nodes& nodes)
{
  const std::size_t node = std::strtoul(block.c_str() + block.find('_') + 1, nullptr, 10);
  return node < nodes.size() && !nodes[node].Name.empty() ? nodes[node].Name : block;
}

/** All parts of a mesh as one: a mesh has a part for each of its materials. */
vtkSmartPointer<vtkPolyData> AppendParts(vtkMultiBlockDataSet* mesh)
{
  vtkNew<vtkAppendPolyData> append;
  for (unsigned int i = 0; i < mesh->GetNumberOfBlocks(); ++i)
  {
    if (auto* part = vtkPolyData::SafeDownCast(mesh->GetBlock(i)))
    {
      append->AddInputData(part);
    }
  }
  append->Update();
  return append->GetOutput();
}

/** Adds the meshes of all nodes of a tree. */
void AddMeshes(vtkMultiBlockDataSet* tree, const std::string& path, const Nodes& nodes,
  vtkMultiBlockDataSet* meshes)
{
  for (unsigned int i = 0; i < tree->GetNumberOfBlocks(); ++i)
  {
    const std::string name = GetBlockName(tree, i);
    auto* inner = vtkMultiBlockDataSet::SafeDownCast(tree->GetBlock(i));
    if (inner && name.find("Mesh_") == 0)
    {
      AddBlock(meshes, path, AppendParts(inner));
    }
    else if (inner)
    {
      const std::string nodeName = GetNodeName(name, nodes);
      AddMeshes(inner, path.empty() ? nodeName : path + "/" + nodeName, nodes, meshes);
    }
  }
}

std::string ReadAll(const std::string& fileName, ErrorLog* log, vtkMultiBlockDataSet* meshes)
{
  const std::size_t errorsBefore = log->Errors.size();
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  vtkNew<vtkGLTFDocumentLoader> document; // has the names, which the reader drops
  if (log->Errors.size() == errorsBefore && document->LoadModelMetaDataFromFile(fileName))
  {
    AddMeshes(reader->GetOutput(), "", document->GetInternalModel()->Nodes, meshes);
  }
  return log->GetErrorSince(errorsBefore);
}

} // namespace

std::string GltfReader::Read(
  const std::string& fileName, ErrorLog* log, vtkMultiBlockDataSet* meshes)
{
  return ReadCarefully([&] { return ReadAll(fileName, log, meshes); });
}
