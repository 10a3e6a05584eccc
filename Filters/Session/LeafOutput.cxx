// SPDX-License-Identifier: BSD-3-Clause
#include "Session/LeafOutput.h"

#include "Convert/ArrayNames.h"
#include "Convert/ArrayTools.h"
#include "Convert/LevelOutput.h"
#include "Convert/OwnArrays.h"
#include "Convert/SimplifiedOutput.h"
#include "Convert/StreamOutput.h"
#include "Convert/TargetRanges.h"
#include "Core/Mesh/ForEach.h"
#include "Objects/CompositeTree.h"
#include "Session/CarverNotes.h"
#include "Session/SimplifyLevels.h"
#include "vtkAlgorithm.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

namespace
{

/** Adds notes on the carving. */
template <int D>
void Describe(
  const DecomposedLeaf<D>& leaf, const CarvedLeaf<D>& carved, std::vector<std::string>& notes)
{
  if (carved.LeftByBudget > 0)
  {
    notes.push_back("The budget of components, tunnels and voids leaves " +
      std::to_string(carved.LeftByBudget) + (D == 3 ? " tetrahedra" : " triangles") +
      " that would exceed it: the last level is not the input.");
  }
  DescribeDecomposition(leaf.Reply, D, notes);
  if (carved.GuessedRegions > 0)
  {
    notes.push_back("The input is open or inconsistently oriented: whether " +
      std::to_string(carved.GuessedRegions) + " of its enclosed regions are solid is a guess.");
  }
  const std::vector<char>& kept = leaf.Reply.Result.Kept;
  if (carved.Profile.LastStep() == 0 && carved.LeftByBudget == 0 &&
    std::count(kept.begin(), kept.end(), 1) == 0)
  {
    notes.push_back("The input is its own initial approximation: there is nothing to carve.");
  }
}

} // namespace

template <int D>
void LeafOutput<D>::WriteEmpty(vtkPolyData* input, const DecomposedLeaf<D>& leaf)
{
  this->PassFieldData(input);
  WriteNotes(leaf.Input.Notes, this->Ports.Levels->GetFieldData());
}

template <int D>
bool LeafOutput<D>::Write(vtkPolyData* input, const DecomposedLeaf<D>& leaf, CarvedLeaf<D>& carved)
{
  const CarverStages::Timer timer(this->Stages, OutputStage);
  this->PassFieldData(input);
  std::vector<std::string> notes = leaf.Input.Notes;
  const vtkSmartPointer<vtkPolyData> attributes = WithUsableArrays(input, notes);
  Describe(leaf, carved, notes);
  WriteNotes(notes, this->Ports.Levels->GetFieldData());
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->Ports.Stream);
  this->WriteStreamAndProfile(attributes, leaf, carved, grid);
  if (D == 3 && this->Settings.Simplify
      ? !this->WriteSimplifiedLevels(carved, grid)
      : !this->WriteLevels(this->SelectSteps(carved.Profile), carved, grid))
  {
    return false;
  }
  if (this->Settings.AppendInput)
  {
    this->AppendInput(attributes, leaf, carved.Profile, grid);
  }
  return this->Stages.Report(OutputStage, 1.0);
}

template <int D>
void LeafOutput<D>::PassFieldData(vtkPolyData* input)
{
  for (vtkDataObject* output : this->Ports.GetAll())
  {
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    RemoveOwnFieldData(output->GetFieldData(), this->Settings.Stored);
  }
}

template <int D>
void LeafOutput<D>::WriteStreamAndProfile(vtkPolyData* attributes, const DecomposedLeaf<D>& leaf,
  CarvedLeaf<D>& carved, vtkUnstructuredGrid* grid)
{
  auto* profile = vtkTable::SafeDownCast(this->Ports.Profile);
  FillProfile(carved.Profile, profile);
  FillStream(carved.Stream, attributes, leaf.Input.CellIds, grid);
  AddProfile(profile, !carved.Profile.Error.empty(), grid->GetFieldData());
  FillSimplifiedStream(carved.Simplified, grid->GetFieldData());
  AddTargetRanges(carved.Profile, carved.Simplified, grid->GetFieldData());
  const carving::Reply& reply = leaf.Reply;
  vtkFieldData* fieldData = grid->GetFieldData();
  AddFieldValue<vtkStringArray>(fieldData, StreamArrays::Strategy, reply.Strategy.c_str());
  if (!reply.Result.Kept.empty())
  {
    AddFieldValue<vtkDoubleArray>(fieldData, StreamArrays::KeptDistance, reply.KeptDistance);
    AddFieldValue<vtkDoubleArray>(fieldData, StreamArrays::KeptDistance99, reply.KeptDistance99);
    AddFieldValue<vtkDoubleArray>(
      fieldData, StreamArrays::KeptDistanceMean, reply.KeptDistanceMean);
    AddFieldValue<vtkDoubleArray>(fieldData, StreamArrays::MetShare, reply.MetShare);
  }
  if (reply.SnapDistance > 0.0)
  {
    AddFieldValue<vtkDoubleArray>(fieldData, StreamArrays::SnapDistance, reply.SnapDistance);
  }
  for (int i = 0; i < this->Settings.Stored->GetNumberOfArrays(); ++i)
  {
    fieldData->AddArray(this->Settings.Stored->GetAbstractArray(i));
  }
}

template <int D>
std::vector<int> LeafOutput<D>::SelectSteps(const carving::Profile& profile)
{
  if (this->Settings.LevelTargets.empty())
  {
    return carving::SpreadLevels(profile, this->Settings.NumberOfLevels);
  }
  std::vector<int> steps;
  for (const double target : this->Settings.LevelTargets)
  {
    const carving::SelectedStep selected =
      carving::SelectStep(profile, this->Settings.TargetType, target);
    if (!selected.Problem.empty())
    {
      vtkWarningWithObjectMacro(this->Filter, << this->Where << selected.Problem);
    }
    steps.push_back(selected.Step);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

template <int D>
bool LeafOutput<D>::WriteLevels(
  const std::vector<int>& steps, const CarvedLeaf<D>& carved, vtkUnstructuredGrid* grid)
{
  // One walk over the stream finds the faces of this many levels. The number bounds the time
  // between reports.
  constexpr std::size_t levelsAtOnce = 16;
  for (std::size_t first = 0; first < steps.size(); first += levelsAtOnce)
  {
    const std::size_t end = std::min(first + levelsAtOnce, steps.size());
    // In the loop below, other threads may fill all levels, so that this thread never reports.
    if (!this->Stages.Report(OutputStage, first / (steps.size() + 1.0)))
    {
      return false;
    }
    std::vector<carving::Level<D>> found = carving::ExtractLevels(
      carved.Stream, { steps.begin() + first, steps.begin() + end }, carved.Profile.Triangles);
    std::vector<vtkNew<vtkPolyData>> levels(found.size());
    std::atomic<std::size_t> done{ first };
    std::atomic<bool> goOn{ true };
    const auto self = std::this_thread::get_id(); // the only thread that may report
    carving::ForEach(this->Settings.ThreadsOfLeaf, static_cast<int>(found.size()),
      [&](int i)
      {
        const std::size_t level = found.size() - 1 - i; // the largest first
        if (goOn)
        {
          const carving::Level<D> faces = std::move(found[level]); // released when filled
          FillLevel(carved.Stream, carved.Profile, grid, faces, this->Settings.ManifoldOutput,
            levels[level]);
          ++done;
        }
        if (goOn && std::this_thread::get_id() == self)
        {
          goOn = this->Stages.Report(OutputStage, done / (steps.size() + 1.0));
        }
      });
    if (!goOn)
    {
      return false;
    }
    for (std::size_t i = first; i < end; ++i)
    {
      this->SetLevel(static_cast<unsigned int>(i), levels[i - first]);
    }
  }
  return true;
}

template <int D>
bool LeafOutput<D>::WriteSimplifiedLevels(const CarvedLeaf<D>& carved, vtkUnstructuredGrid* grid)
{
  const std::vector<carving::SimplifiedTarget> targets =
    MakeSimplifiedTargets(carved.Profile, this->Settings);
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    vtkNew<vtkPolyData> level;
    std::string problem = targets[i].Problem;
    if constexpr (D == 3)
    {
      problem += FillSimplifiedLevel(carved.Stream, carved.Simplified, carved.Profile, grid,
        targets[i], this->Settings.ManifoldOutput, level);
    }
    if (!problem.empty())
    {
      vtkWarningWithObjectMacro(this->Filter, << this->Where << problem);
    }
    this->SetLevel(static_cast<unsigned int>(i), level);
    if (!this->Stages.Report(OutputStage, (i + 1.0) / (targets.size() + 1.0)))
    {
      return false;
    }
  }
  return true;
}

template <int D>
void LeafOutput<D>::AppendInput(vtkPolyData* attributes, const DecomposedLeaf<D>& leaf,
  const carving::Profile& profile, vtkUnstructuredGrid* grid)
{
  if (!leaf.Reply.Result.Kept.empty()) // else the last level is the input; in a plane it always is
  {
    vtkNew<vtkPolyData> level;
    FillInputLevel(leaf.Reply.Result, profile, attributes, leaf.Input.CellIds, grid, level);
    this->SetLevel(this->Ports.Levels->GetNumberOfBlocks(), level);
  }
}

template <int D>
void LeafOutput<D>::SetLevel(unsigned int index, vtkPolyData* level)
{
  this->Ports.Levels->SetBlock(index, level);
  SetBlockName(this->Ports.Levels, index, "LOD " + std::to_string(index));
}

template class LeafOutput<2>;
template class LeafOutput<3>;
