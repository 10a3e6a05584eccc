// SPDX-License-Identifier: BSD-3-Clause
#include "Session/DecomposedLeaf.h"

#include "Process/HelperProcess.h"
#include "vtkAlgorithm.h"
#include "vtkPolyData.h"

#include <algorithm>

template <int D>
typename DecomposedLeaves<D>::LeafPointer DecomposedLeaves<D>::Get(
  vtkPolyData* input, vtkPolyData* initial, const HelperSettings& settings)
{
  const bool custom = settings.Initial == carving::InitialApproximation::Custom;
  const auto kept = std::find_if(this->Kept.begin(), this->Kept.end(),
    [&](const LeafPointer& leaf)
    {
      return leaf->Given.IsOf(input) && leaf->GivenInitial.IsOf(custom ? initial : nullptr) &&
        WouldAnswerAlike(leaf->Reply, leaf->Settings, settings, D);
    });
  const LeafPointer leaf =
    kept != this->Kept.end() ? *kept : this->Decompose(input, custom ? initial : nullptr, settings);
  if (leaf)
  {
    this->Used.push_back(leaf);
  }
  return leaf;
}

template <int D>
typename DecomposedLeaves<D>::LeafPointer DecomposedLeaves<D>::Decompose(
  vtkPolyData* input, vtkPolyData* initial, const HelperSettings& settings)
{
  const auto leaf = std::make_shared<DecomposedLeaf<D>>();
  leaf->Given = DataVersion(input);
  leaf->GivenInitial = DataVersion(initial);
  leaf->Settings = settings;
  std::string error = leaf->Input.Gather(input);
  leaf->Empty = leaf->Input.IsEmpty();
  if (error.empty() && settings.Initial == carving::InitialApproximation::Custom)
  {
    if (initial)
    {
      error = Kind<D>::GatherInitial(initial, leaf->Input, leaf->Initial);
      error = error.empty() ? error : "The initial approximation on port 1: " + error;
    }
    else
    {
      error = "InitialApproximation is CUSTOM, but input port 1 has no polygonal data.";
    }
  }
  if (error.empty() && !leaf->Empty && !this->RunHelper(*leaf, error))
  {
    return nullptr;
  }
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(this->Filter, << error);
    return nullptr;
  }
  this->Kept.push_back(leaf);
  return leaf;
}

template <int D>
bool DecomposedLeaves<D>::RunHelper(DecomposedLeaf<D>& leaf, std::string& error)
{
  const CarverStages::Timer timer(this->Stages, TransferStage);
  carving::Job job;
  static_cast<carving::HelperOptions&>(job) = leaf.Settings;
  job.Solid = leaf.Settings.Solid;
  Kind<D>::Fill(job, leaf.Input, leaf.Initial);
  const HelperProcess::Outcome outcome = HelperProcess::Run(
    job, leaf.Reply,
    [this](const carving::WorkProgress& progress)
    {
      return this->Stages.Report(
        static_cast<int>(progress.Stage), progress.Fraction, progress.Attempt);
    },
    error);
  this->Stages.MoveToHelper(leaf.Reply.StageSeconds);
  return outcome != HelperProcess::Outcome::Aborted;
}

template <int D>
void DecomposedLeaves<D>::FinishUpdate(bool aborted)
{
  if (!aborted)
  {
    this->Kept = std::move(this->Used);
  }
  this->Used.clear();
}

template class DecomposedLeaves<2>;
template class DecomposedLeaves<3>;
