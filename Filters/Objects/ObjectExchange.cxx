// SPDX-License-Identifier: BSD-3-Clause
#include "Objects/ObjectExchange.h"

#include "Convert/ArrayNames.h"
#include "Objects/CompositeTree.h"
#include "Objects/LeafPlacement.h"
#include "vtkAppendPolyData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTypes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{

/** The kind of a node of a tree. If processes disagree, the greatest value holds. */
enum NodeKind
{
  NoData,
  LeafData,
  Composite
};

NodeKind GetKind(vtkDataObject* node)
{
  return !node ? NoData : node->IsA("vtkCompositeDataSet") ? Composite : LeafData;
}

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

/** Writes the numeric arrays. Other processes do not need texts. */
void WriteNumbers(vtkFieldData* fieldData, vtkMultiProcessStream& stream)
{
  for (int i = 0; i < fieldData->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = fieldData->GetArray(i))
    {
      vtkNew<vtkDoubleArray> numbers;
      numbers->DeepCopy(array);
      const char* name = array->GetName();
      stream << (name != nullptr) << std::string(name ? name : "") << array->GetDataType()
             << array->GetNumberOfComponents() << static_cast<int>(array->GetNumberOfTuples());
      stream.Push(numbers->GetPointer(0), static_cast<unsigned int>(numbers->GetNumberOfValues()));
    }
  }
}

/** Reads arrays up to the end of the stream. */
void ReadNumbers(vtkMultiProcessStream& stream, vtkFieldData* fieldData)
{
  while (!stream.Empty())
  {
    bool named = false;
    std::string name;
    int type = 0, components = 0, count = 0;
    stream >> named >> name >> type >> components >> count;
    vtkNew<vtkDoubleArray> numbers;
    numbers->SetNumberOfComponents(components);
    numbers->SetNumberOfTuples(count);
    double* values = numbers->GetPointer(0);
    unsigned int length = static_cast<unsigned int>(numbers->GetNumberOfValues());
    stream.Pop(values, length);
    vtkSmartPointer<vtkDataArray> array;
    array.TakeReference(vtkDataArray::CreateDataArray(type));
    array->DeepCopy(numbers);
    array->SetName(named ? name.c_str() : nullptr);
    fieldData->AddArray(array);
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
  int largest = value;
  this->Controller->AllReduce(&value, &largest, 1, vtkCommunicator::MAX_OP);
  return largest;
}

std::vector<int> ObjectExchange::All(int value) const
{
  std::vector<int> all(this->Controller->GetNumberOfProcesses());
  this->Controller->AllGather(&value, all.data(), 1);
  return all;
}

/** The text of the first process whose text is not empty. */
std::string ObjectExchange::First(const std::string& text) const
{
  const std::vector<int> lengths = this->All(static_cast<int>(text.size()));
  const auto owner =
    std::find_if(lengths.begin(), lengths.end(), [](int length) { return length > 0; });
  if (owner == lengths.end())
  {
    return {};
  }
  vtkMultiProcessStream stream;
  stream << text;
  this->Controller->Broadcast(stream, static_cast<int>(owner - lengths.begin()));
  std::string first;
  stream >> first;
  return first;
}

vtkSmartPointer<vtkDataObject> ObjectExchange::Gather(vtkDataObject* input, int& numberOfMerged)
{
  std::vector<Leaf> leaves;
  vtkSmartPointer<vtkDataObject> result = this->GatherNode(input, nullptr, 0, leaves);
  const std::vector<Owners> owners = this->FindOwners(leaves);
  std::vector<double> costs;
  std::vector<int> first;
  for (const Owners& ofLeaf : owners)
  {
    costs.push_back(ofLeaf.Cells);
    first.push_back(ofLeaf.First);
  }
  const std::vector<int> destinations =
    PlaceLeaves(costs, first, this->Controller->GetNumberOfProcesses());
  this->Cache.resize(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    vtkPolyData* mesh =
      this->GatherLeaf(leaves[i].Part, owners[i], destinations[i], this->Cache[i], numberOfMerged);
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
vtkSmartPointer<vtkDataObject> ObjectExchange::GatherNode(
  vtkDataObject* node, vtkMultiBlockDataSet* parent, unsigned int block, std::vector<Leaf>& leaves)
{
  switch (this->Largest(GetKind(node)))
  {
    case NoData:
      return nullptr;
    case LeafData:
    {
      auto* mesh = vtkPolyData::SafeDownCast(node);
      // Data that cannot be carved stays where it is; its process reports an error.
      if (this->Largest(node && !mesh) != 0)
      {
        return node;
      }
      leaves.push_back({ mesh, parent, block });
      return nullptr;
    }
    default:
      break;
  }
  std::vector<CompositeChild> children;
  const bool known = !node || GetKind(node) == LeafData || GetChildren(node, children);
  if (this->Largest(!known) != 0)
  {
    return node; // not a tree
  }
  children.resize(this->Largest(static_cast<int>(children.size())));
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(static_cast<unsigned int>(children.size()));
  for (unsigned int i = 0; i < children.size(); ++i)
  {
    blocks->SetBlock(i, this->GatherNode(children[i].Data, blocks, i, leaves));
    SetBlockName(blocks, i, this->First(children[i].Name));
  }
  return blocks;
}

std::vector<ObjectExchange::Owners> ObjectExchange::FindOwners(
  const std::vector<Leaf>& leaves) const
{
  std::vector<double> here;
  for (const Leaf& leaf : leaves)
  {
    here.push_back(leaf.Part ? static_cast<double>(leaf.Part->GetNumberOfCells()) : 0.0);
  }
  const int processes = this->Controller->GetNumberOfProcesses();
  std::vector<double> all(processes * here.size());
  if (!here.empty())
  {
    this->Controller->AllGather(here.data(), all.data(), static_cast<vtkIdType>(here.size()));
  }
  std::vector<Owners> owners(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    for (int process = 0; process < processes; ++process)
    {
      const double cells = all[process * leaves.size() + i];
      owners[i].First = owners[i].Number == 0 && cells > 0.0 ? process : owners[i].First;
      owners[i].Number += cells > 0.0;
      owners[i].Cells += cells;
    }
  }
  return owners;
}

/** Returns the whole mesh on its destination, and null elsewhere. */
vtkPolyData* ObjectExchange::GatherLeaf(
  vtkPolyData* part, const Owners& owners, int destination, Merged& merged, int& numberOfMerged)
{
  const bool isHere = this->Controller->GetLocalProcessId() == destination;
  if (owners.Number == 0 || (owners.Number == 1 && owners.First == destination))
  {
    merged = {};
    return owners.Number == 1 && isHere ? part : nullptr;
  }
  const bool changed = merged.Destination != destination || !merged.Given.IsOf(part);
  if (this->Largest(changed) != 0)
  {
    merged = { DataVersion(part),
      owners.Number == 1 ? this->Move(part, owners.First, destination)
                         : this->Merge(part, destination),
      destination };
    numberOfMerged += owners.Number > 1 && isHere;
  }
  return merged.Mesh;
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
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output);
  if (!blocks)
  {
    this->MatchFieldData(output);
    return;
  }
  const int count = this->Largest(static_cast<int>(blocks->GetNumberOfBlocks()));
  blocks->SetNumberOfBlocks(static_cast<unsigned int>(count));
  std::vector<CompositeChild> children;
  GetChildren(blocks, children);
  for (int i = 0; i < count; ++i)
  {
    vtkSmartPointer<vtkDataObject> child = children[i].Data;
    const std::string name = this->First(children[i].Name);
    const std::string type = this->First(child ? child->GetClassName() : "");
    if (!child && !type.empty() && type != "vtkPolyData")
    {
      child.TakeReference(vtkDataObjectTypes::NewDataObject(type.c_str()));
      blocks->SetBlock(i, child);
    }
    SetBlockName(blocks, i, name);
    if (!type.empty() && type != "vtkPolyData")
    {
      this->Match(child);
    }
  }
}

void ObjectExchange::MatchFieldData(vtkDataObject* leaf)
{
  vtkFieldData* fieldData = leaf->GetFieldData();
  const bool own = fieldData->HasArray(StreamArrays::ProfilePriority) != 0;
  const std::vector<int> owners = this->All(own);
  const auto owner = std::find(owners.begin(), owners.end(), 1);
  if (owner == owners.end())
  {
    return;
  }
  vtkMultiProcessStream stream;
  if (own)
  {
    WriteNumbers(fieldData, stream);
  }
  this->Controller->Broadcast(stream, static_cast<int>(owner - owners.begin()));
  if (!own)
  {
    ReadNumbers(stream, fieldData);
  }
}
