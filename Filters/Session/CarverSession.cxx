// SPDX-License-Identifier: BSD-3-Clause
#include "Session/CarverSession.h"

#include "Convert/OwnArrays.h"
#include "Objects/CompositeTree.h"
#include "Session/CarvedLeaf.h"
#include "Session/LeafOutput.h"
#include "Session/SimplifyLevels.h"
#include "Session/WithinMemory.h"
#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

template <int D>
bool CarverSession<D>::Update(vtkDataObject* input, vtkPolyData* initial,
  const CarverSettings& settings, const CarverPorts& ports)
{
  this->Settings = settings;
  bool good = false;
  if (auto* polyData = vtkPolyData::SafeDownCast(input))
  {
    this->Stages.Start(1, settings.Simplify);
    this->Settings.ThreadsOfLeaf = settings.NumberOfThreads;
    this->Leaves.Start({ polyData }, initial, settings, 1, this->Settings.ThreadsOfLeaf);
    good = this->UpdateLeaf(polyData, "", ports);
  }
  else
  {
    const auto leaves = vtkCompositeDataSet::GetDataSets<vtkPolyData>(input);
    this->Stages.Start(static_cast<int>(leaves.size()), settings.Simplify);
    const int numberOfLeaves = std::max(1, static_cast<int>(leaves.size()));
    this->Settings.ThreadsOfLeaf = std::max(1, settings.NumberOfThreads / numberOfLeaves);
    this->Leaves.Start(
      leaves, initial, settings, settings.NumberOfThreads, this->Settings.ThreadsOfLeaf);
    // The pipeline has passed on the field data of the whole input.
    for (vtkDataObject* output : ports.GetAll())
    {
      RemoveOwnFieldData(output->GetFieldData(), settings.Stored);
    }
    good = this->UpdateTree(input, "", ports);
  }
  this->Leaves.FinishUpdate(IsAborted(this->Filter));
  return good;
}

template <int D>
bool CarverSession<D>::UpdateLeaf(
  vtkPolyData* input, const std::string& where, const CarverPorts& ports)
{
  const bool good = WithinMemory(
    this->Filter, where, [&] { return this->UpdateLeafUnguarded(input, where, ports); });
  if (!good)
  {
    for (vtkDataObject* output : ports.GetAll())
    {
      output->Initialize();
    }
  }
  return good;
}

template <int D>
bool CarverSession<D>::UpdateLeafUnguarded(
  vtkPolyData* input, const std::string& where, const CarverPorts& ports)
{
  const auto leaf = this->Leaves.Get(input, where);
  if (!leaf)
  {
    return false;
  }
  LeafOutput<D> output(this->Filter, where, this->Settings, this->Stages, ports);
  if (leaf->Empty)
  {
    output.WriteEmpty(input, *leaf);
    this->Stages.FinishLeaf();
    return true;
  }
  CarvedLeaf<D> carved;
  if (!CarveLeaf(*leaf, this->Settings, this->Stages, carved) ||
    !this->Simplify(*leaf, where, carved))
  {
    return false;
  }
  const bool goOn = output.Write(input, *leaf, carved);
  this->Stages.FinishLeaf();
  return goOn;
}

template <int D>
bool CarverSession<D>::Simplify(
  const DecomposedLeaf<D>& leaf, const std::string& where, CarvedLeaf<D>& carved)
{
  bool goOn = true;
  if constexpr (D == 3)
  {
    if (this->Settings.Simplify)
    {
      std::vector<std::string> problems;
      goOn = SimplifyLevels(leaf, this->Settings, this->Stages, carved, problems);
      for (const std::string& problem : problems)
      {
        vtkWarningWithObjectMacro(this->Filter, << where << problem);
      }
    }
  }
  return goOn;
}

template <int D>
bool CarverSession<D>::UpdateTree(
  vtkDataObject* input, const std::string& where, const CarverPorts& ports)
{
  std::vector<CompositeChild> children;
  if (!GetChildren(input, children))
  {
    vtkErrorWithObjectMacro(this->Filter,
      << where << "A " << input->GetClassName()
      << " cannot be carved. Apply Extract Surface, or merge it into polygonal data first.");
    return false;
  }
  const std::array<vtkMultiBlockDataSet*, 3> parents = { ports.Levels,
    vtkMultiBlockDataSet::SafeDownCast(ports.Stream),
    vtkMultiBlockDataSet::SafeDownCast(ports.Profile) };
  for (vtkMultiBlockDataSet* parent : parents)
  {
    parent->SetNumberOfBlocks(static_cast<unsigned int>(children.size()));
  }
  for (unsigned int i = 0; i < children.size(); ++i)
  {
    this->UpdateChild(children[i], children[i].Where(where, i), i, parents);
    if (IsAborted(this->Filter))
    {
      return false;
    }
  }
  return true;
}

template <int D>
void CarverSession<D>::UpdateChild(const CompositeChild& child, const std::string& where,
  unsigned int index, const std::array<vtkMultiBlockDataSet*, 3>& parents)
{
  vtkNew<vtkMultiBlockDataSet> levels;
  vtkSmartPointer<vtkDataObject> stream, profile;
  // After an error, which has been reported, the child's outputs stay empty and the other children
  // go on.
  if (auto* leaf = vtkPolyData::SafeDownCast(child.Data))
  {
    stream = vtkSmartPointer<vtkUnstructuredGrid>::New();
    profile = vtkSmartPointer<vtkTable>::New();
    this->UpdateLeaf(leaf, where, { levels, stream, profile });
  }
  else if (child.Data && child.Data->IsA("vtkCompositeDataSet"))
  {
    stream = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    profile = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    this->UpdateTree(child.Data, where, { levels, stream, profile });
  }
  else if (child.Data)
  {
    vtkErrorWithObjectMacro(this->Filter,
      << where << "A " << child.Data->GetClassName()
      << " is given: only polygonal data can be carved. Apply Extract Surface first.");
  }
  vtkDataObject* const results[] = { stream ? levels.Get() : nullptr, stream, profile };
  for (int port = 0; port < 3; ++port)
  {
    parents[port]->SetBlock(index, results[port]);
    SetBlockName(parents[port], index, child.Name);
  }
}

template class CarverSession<2>;
template class CarverSession<3>;
