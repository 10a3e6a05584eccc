// SPDX-License-Identifier: BSD-3-Clause
#include "Objects/ObjectExchange.h"

#include "Convert/ArrayNames.h"
#include "Objects/CompositeTree.h"
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
  Leaf,
  Composite
};

NodeKind GetKind(vtkDataObject* node)
{
  return !node ? NoData : node->IsA("vtkCompositeDataSet") ? Composite : Leaf;
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
  this->NextLeaf = 0;
  vtkSmartPointer<vtkDataObject> result = this->GatherNode(input, numberOfMerged);
  this->Cache.resize(this->NextLeaf);
  if (!result)
  {
    result.TakeReference(vtkDataObjectTypes::NewDataObject(input->GetClassName()));
  }
  return result;
}

vtkSmartPointer<vtkDataObject> ObjectExchange::GatherNode(vtkDataObject* node, int& numberOfMerged)
{
  switch (this->Largest(GetKind(node)))
  {
    case NoData:
      return nullptr;
    case Leaf:
    {
      auto* mesh = vtkPolyData::SafeDownCast(node);
      // Data that cannot be carved stays where it is; its process reports an error.
      const bool foreign = this->Largest(node && !mesh) != 0;
      return foreign ? vtkSmartPointer<vtkDataObject>(node)
                     : this->GatherLeaf(mesh, numberOfMerged);
    }
    default:
      break;
  }
  std::vector<CompositeChild> children;
  const bool known = !node || GetKind(node) == Leaf || GetChildren(node, children);
  if (this->Largest(!known) != 0)
  {
    return node; // not a tree
  }
  children.resize(this->Largest(static_cast<int>(children.size())));
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(static_cast<unsigned int>(children.size()));
  for (unsigned int i = 0; i < children.size(); ++i)
  {
    blocks->SetBlock(i, this->GatherNode(children[i].Data, numberOfMerged));
    SetBlockName(blocks, i, this->First(children[i].Name));
  }
  return blocks;
}

vtkSmartPointer<vtkDataObject> ObjectExchange::GatherLeaf(vtkPolyData* leaf, int& numberOfMerged)
{
  const std::size_t index = this->NextLeaf++;
  this->Cache.resize(std::max(this->Cache.size(), this->NextLeaf));
  Merged& merged = this->Cache[index];
  const std::vector<int> sizes = this->All(leaf && leaf->GetNumberOfCells() > 0 ? 1 : 0);
  const auto owner = std::find(sizes.begin(), sizes.end(), 1);
  const int owners = static_cast<int>(std::count(sizes.begin(), sizes.end(), 1));
  const int self = this->Controller->GetLocalProcessId();
  if (owners < 2)
  {
    merged = {};
    return owner == sizes.begin() + self ? leaf : nullptr;
  }
  const bool changed = this->Largest(!merged.Given.IsOf(leaf)) != 0;
  const int destination = static_cast<int>(owner - sizes.begin());
  if (changed)
  {
    merged = { DataVersion(leaf), nullptr };
    vtkNew<vtkPolyData> nothing;
    std::vector<vtkSmartPointer<vtkDataObject>> parts;
    this->Controller->Gather(leaf ? leaf : nothing.Get(), parts, destination);
    if (self == destination)
    {
      merged.Mesh = Append(parts);
      ++numberOfMerged;
    }
  }
  return merged.Mesh;
}

vtkSmartPointer<vtkPolyData> ObjectExchange::GatherOnAll(vtkPolyData* mesh)
{
  if (this->Largest(!this->OnAll.Given.IsOf(mesh)) != 0)
  {
    vtkNew<vtkPolyData> nothing;
    std::vector<vtkSmartPointer<vtkDataObject>> parts;
    this->Controller->AllGather(mesh ? mesh : nothing.Get(), parts);
    this->OnAll = { DataVersion(mesh), Append(parts) };
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
