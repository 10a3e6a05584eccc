// SPDX-License-Identifier: BSD-3-Clause
#include "Objects/ObjectExchange.h"

#include "Convert/TargetRanges.h"
#include "Objects/CompositeTree.h"
#include "Objects/LeafPlacement.h"
#include "Objects/TreeSummary.h"
#include "vtkAppendPolyData.h"
#include "vtkCommunicator.h"
#include "vtkDataObjectTypes.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace
{

vtkSmartPointer<vtkPolyData> Append(const std::vector<vtkSmartPointer<vtkDataObject>>& parts)
{
  vtkNew<vtkAppendPolyData> append;
  for (const auto& part : parts)
  {
    auto* mesh = vtkPolyData::SafeDownCast(part);
    if (mesh && mesh->GetNumberOfCells() > 0) // an empty mesh would remove the arrays of the others
    {
      append->AddInputData(mesh);
    }
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  append->Update();
  return append->GetOutput();
}

/** Gives a node the blocks, names and ranges that it has on any process. */
void MatchNode(const TreeSummary& summary, vtkDataObject* node)
{
  if (!summary.TargetRanges.empty())
  {
    AddTargetRanges(summary.TargetRanges, node->GetFieldData());
  }
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(node);
  if (!blocks)
  {
    return;
  }
  blocks->SetNumberOfBlocks(static_cast<unsigned int>(summary.Children.size()));
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    const TreeSummary& child = summary.Children[i];
    const bool known = !child.Type.empty() && child.Type != "vtkPolyData";
    if (known && !blocks->GetBlock(i))
    {
      vtkSmartPointer<vtkDataObject> made;
      made.TakeReference(vtkDataObjectTypes::NewDataObject(child.Type.c_str()));
      blocks->SetBlock(i, made);
    }
    if (known)
    {
      MatchNode(child, blocks->GetBlock(i));
    }
    SetBlockName(blocks, i, child.Name);
  }
}

} // namespace

bool ObjectExchange::IsParallel() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

bool ObjectExchange::IsTrueOnAll(bool here) const
{
  return this->IsParallel() ? this->Largest(!here) == 0 : here;
}

int ObjectExchange::Largest(int value) const
{
  std::vector<int> largest = { value };
  this->Reduce(largest, vtkCommunicator::MAX_OP);
  return largest[0];
}

/** Replaces each value by the result of an operation on the values of all processes. */
template <class Value>
void ObjectExchange::Reduce(std::vector<Value>& values, int operation) const
{
  if (!values.empty())
  {
    const std::vector<Value> here = values;
    this->Controller->AllReduce(
      here.data(), values.data(), static_cast<vtkIdType>(values.size()), operation);
  }
}

vtkSmartPointer<vtkDataObject> ObjectExchange::Gather(vtkDataObject* input, int& numberOfMerged)
{
  std::vector<Leaf> leaves;
  vtkSmartPointer<vtkDataObject> result =
    GatherNode(input, TreeSummary::MergeAll(input, this->Controller), nullptr, 0, leaves);
  const std::vector<Owners> owners = this->FindOwners(leaves);
  this->FillCache(leaves, owners);
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const Merged& merged = this->Cache[i];
    const bool isHere = this->Controller->GetLocalProcessId() == merged.Destination;
    numberOfMerged += isHere && merged.IsNew && owners[i].Number > 1;
    vtkPolyData* mesh = !isHere                     ? nullptr
      : StaysInPlace(owners[i], merged.Destination) ? leaves[i].Part
                                                    : merged.Mesh.Get();
    if (leaves[i].Parent)
    {
      leaves[i].Parent->SetBlock(leaves[i].Block, mesh);
    }
    else
    {
      result = mesh;
    }
  }
  if (!result)
  {
    result.TakeReference(vtkDataObjectTypes::NewDataObject(input->GetClassName()));
  }
  return result;
}

/** Returns a node whose leaves are still missing, and adds them to `leaves`. */
vtkSmartPointer<vtkDataObject> ObjectExchange::GatherNode(vtkDataObject* node,
  const TreeSummary& summary, vtkMultiBlockDataSet* parent, unsigned int block,
  std::vector<Leaf>& leaves)
{
  if (summary.Type.empty())
  {
    return nullptr;
  }
  if (!summary.IsMesh)
  {
    return node; // data that cannot be carved stay where they are; their process reports an error
  }
  if (!summary.IsTree)
  {
    leaves.push_back({ vtkPolyData::SafeDownCast(node), parent, block });
    return nullptr;
  }
  std::vector<CompositeChild> children;
  GetChildren(node, children);
  children.resize(summary.Children.size());
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(static_cast<unsigned int>(children.size()));
  for (unsigned int i = 0; i < children.size(); ++i)
  {
    const TreeSummary& child = summary.Children[i];
    blocks->SetBlock(i, GatherNode(children[i].Data, child, blocks, i, leaves));
    SetBlockName(blocks, i, child.Name);
  }
  return blocks;
}

std::vector<ObjectExchange::Owners> ObjectExchange::FindOwners(
  const std::vector<Leaf>& leaves) const
{
  const std::size_t count = leaves.size();
  std::vector<int> first(count, this->Controller->GetNumberOfProcesses()), number(count, 0);
  std::vector<double> cells(count, 0.0);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (leaves[i].Part && leaves[i].Part->GetNumberOfCells() > 0)
    {
      first[i] = this->Controller->GetLocalProcessId();
      number[i] = 1;
      cells[i] = static_cast<double>(leaves[i].Part->GetNumberOfCells());
    }
  }
  this->Reduce(first, vtkCommunicator::MIN_OP);
  this->Reduce(number, vtkCommunicator::SUM_OP);
  this->Reduce(cells, vtkCommunicator::SUM_OP);
  std::vector<Owners> owners;
  for (std::size_t i = 0; i < count; ++i)
  {
    owners.push_back({ first[i], number[i], cells[i] });
  }
  return owners;
}

/** Fills the cache: each leaf gets its destination, and its mesh there. */
void ObjectExchange::FillCache(const std::vector<Leaf>& leaves, const std::vector<Owners>& owners)
{
  std::vector<double> costs;
  std::vector<int> first;
  for (const Owners& ofLeaf : owners)
  {
    costs.push_back(ofLeaf.Cells);
    first.push_back(ofLeaf.Number > 0 ? ofLeaf.First : 0);
  }
  const std::vector<int> destinations =
    PlaceLeaves(costs, first, this->Controller->GetNumberOfProcesses());
  this->Cache.resize(leaves.size());
  std::vector<int> changed;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const Merged& merged = this->Cache[i];
    changed.push_back(
      merged.Destination != destinations[i] || !merged.Given.IsOf(leaves[i].Part) ? 1 : 0);
  }
  this->Reduce(changed, vtkCommunicator::MAX_OP);
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    Merged& merged = this->Cache[i];
    merged.IsNew = changed[i] != 0;
    if (merged.IsNew)
    {
      merged = { DataVersion(leaves[i].Part),
        this->GatherLeaf(leaves[i].Part, owners[i], destinations[i]), destinations[i], true };
    }
  }
}

/**
 * Returns the whole mesh on its destination, and null elsewhere and for a mesh that stays in place.
 */
vtkSmartPointer<vtkPolyData> ObjectExchange::GatherLeaf(
  vtkPolyData* part, const Owners& owners, int destination) const
{
  if (StaysInPlace(owners, destination))
  {
    return nullptr;
  }
  return owners.Number == 1 ? this->Move(part, owners.First, destination)
                            : this->Merge(part, destination);
}

vtkSmartPointer<vtkPolyData> ObjectExchange::Move(
  vtkPolyData* mesh, int owner, int destination) const
{
  constexpr int tag = 7301; // any number that other messages do not have
  const int self = this->Controller->GetLocalProcessId();
  vtkSmartPointer<vtkPolyData> moved;
  if (self == owner)
  {
    this->Controller->Send(mesh, destination, tag);
  }
  else if (self == destination)
  {
    moved = vtkSmartPointer<vtkPolyData>::New();
    this->Controller->Receive(moved, owner, tag);
  }
  return moved;
}

vtkSmartPointer<vtkPolyData> ObjectExchange::Merge(vtkPolyData* part, int destination) const
{
  vtkNew<vtkPolyData> nothing;
  std::vector<vtkSmartPointer<vtkDataObject>> parts;
  this->Controller->Gather(part ? part : nothing.Get(), parts, destination);
  const bool isHere = this->Controller->GetLocalProcessId() == destination;
  return isHere ? Append(parts) : nullptr;
}

vtkSmartPointer<vtkPolyData> ObjectExchange::GatherOnAll(vtkPolyData* mesh)
{
  if (this->Largest(!this->OnAll.Given.IsOf(mesh)) != 0)
  {
    vtkNew<vtkPolyData> nothing;
    std::vector<vtkSmartPointer<vtkDataObject>> parts;
    this->Controller->AllGather(mesh ? mesh : nothing.Get(), parts);
    this->OnAll = { DataVersion(mesh), Append(parts), -1 };
  }
  return this->OnAll.Mesh;
}

void ObjectExchange::Match(vtkDataObject* output)
{
  MatchNode(TreeSummary::MergeAll(output, this->Controller), output);
}
