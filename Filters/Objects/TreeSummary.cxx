// SPDX-License-Identifier: BSD-3-Clause
#include "Objects/TreeSummary.h"

#include "Convert/TargetRanges.h"
#include "Objects/CompositeTree.h"
#include "vtkDataObject.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"

#include <algorithm>

TreeSummary::TreeSummary(vtkDataObject* node, const std::string& name)
  : Name(name)
{
  if (!node)
  {
    return;
  }
  this->Type = node->GetClassName();
  this->IsTree = node->IsA("vtkCompositeDataSet");
  std::vector<CompositeChild> children;
  this->IsMesh = this->IsTree ? GetChildren(node, children) : node->IsA("vtkPolyData");
  for (const CompositeChild& child : children)
  {
    this->Children.emplace_back(child.Data, child.Name);
  }
  this->TargetRanges = ReadTargetRanges(node->GetFieldData());
}

void TreeSummary::Write(vtkMultiProcessStream& stream) const
{
  stream << this->Name << this->Type << this->IsTree << this->IsMesh
         << static_cast<int>(this->TargetRanges.size());
  for (const double value : this->TargetRanges)
  {
    stream << value;
  }
  stream << static_cast<int>(this->Children.size());
  for (const TreeSummary& child : this->Children)
  {
    child.Write(stream);
  }
}

TreeSummary::TreeSummary(vtkMultiProcessStream& stream)
{
  int count = 0;
  stream >> this->Name >> this->Type >> this->IsTree >> this->IsMesh >> count;
  this->TargetRanges.resize(count);
  for (double& value : this->TargetRanges)
  {
    stream >> value;
  }
  stream >> count;
  for (int i = 0; i < count; ++i)
  {
    this->Children.emplace_back(stream);
  }
}

void TreeSummary::Add(const TreeSummary& other)
{
  const auto addTo = [](auto& own, const auto& others)
  {
    if (own.empty())
    {
      own = others;
    }
  };
  addTo(this->Name, other.Name);
  addTo(this->TargetRanges, other.TargetRanges);
  if (other.IsTree && !this->IsTree)
  {
    this->Type.clear();
  }
  addTo(this->Type, other.Type);
  this->IsTree = this->IsTree || other.IsTree;
  this->IsMesh = this->IsMesh && other.IsMesh;
  this->Children.resize(std::max(this->Children.size(), other.Children.size()));
  for (std::size_t i = 0; i < other.Children.size(); ++i)
  {
    this->Children[i].Add(other.Children[i]);
  }
}

TreeSummary TreeSummary::MergeAll(vtkDataObject* tree, vtkMultiProcessController* controller)
{
  constexpr int tag = 7302; // any number that other messages do not have
  const int self = controller->GetLocalProcessId();
  TreeSummary sum(tree, {});
  // In pairs, so that no process ever holds the summaries of all.
  bool isSent = false;
  for (int distance = 1; !isSent && distance < controller->GetNumberOfProcesses(); distance *= 2)
  {
    vtkMultiProcessStream message;
    isSent = self / distance % 2 == 1;
    if (isSent)
    {
      sum.Write(message);
      controller->Send(message, self - distance, tag);
    }
    else if (self + distance < controller->GetNumberOfProcesses())
    {
      controller->Receive(message, self + distance, tag);
      sum.Add(TreeSummary(message));
    }
  }
  vtkMultiProcessStream merged;
  if (self == 0)
  {
    sum.Write(merged);
  }
  controller->Broadcast(merged, 0);
  return TreeSummary(merged);
}
