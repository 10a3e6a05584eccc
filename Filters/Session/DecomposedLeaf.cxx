// SPDX-License-Identifier: BSD-3-Clause
#include "Session/DecomposedLeaf.h"

#include "Session/MemoryNeed.h"
#include "Session/WithinMemory.h"
#include "vtkAlgorithm.h"
#include "vtkPolyData.h"
#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <new>

using carving::SecondsSince;

template <int D>
void DecomposedLeaves<D>::Start(const std::vector<vtkPolyData*>& inputs, vtkPolyData* initial,
  const HelperSettings& settings, int numberOfThreads, int threadsOfLeaf)
{
  const bool custom = settings.Initial == carving::InitialApproximation::Custom;
  this->Upcoming.assign(inputs.begin(), inputs.end());
  this->Initial = custom ? initial : nullptr;
  this->Settings = settings;
  this->NumberOfThreads = static_cast<std::size_t>(std::max(1, numberOfThreads));
  this->ThreadsOfLeaf = threadsOfLeaf;
}

template <int D>
typename DecomposedLeaves<D>::LeafPointer DecomposedLeaves<D>::FindKept(vtkPolyData* input) const
{
  const auto kept = std::find_if(this->Kept.begin(), this->Kept.end(),
    [&](const LeafPointer& leaf)
    {
      return leaf->Given.IsOf(input) && leaf->GivenInitial.IsOf(this->Initial) &&
        WouldAnswerAlike(leaf->Reply, leaf->Settings, this->Settings, D);
    });
  return kept != this->Kept.end() ? *kept : nullptr;
}

template <int D>
typename DecomposedLeaves<D>::LeafPointer DecomposedLeaves<D>::Get(
  vtkPolyData* input, const std::string& where)
{
  LeafPointer leaf = this->FindKept(input);
  if (!leaf)
  {
    this->StartNext();
    if (this->FindRun(input) == this->Runs.end()) // after an error, or a leaf given twice
    {
      this->StartRun(input);
    }
    leaf = this->FinishRun(*this->FindRun(input), where);
    this->Runs.erase(this->FindRun(input));
  }
  if (leaf && this->Settings.Reuse)
  {
    this->Used.push_back(leaf);
  }
  return leaf;
}

template <int D>
typename std::deque<typename DecomposedLeaves<D>::Run>::iterator DecomposedLeaves<D>::FindRun(
  vtkPolyData* input)
{
  return std::find_if(this->Runs.begin(), this->Runs.end(),
    [input](const Run& run) { return run.Leaf->Given.IsOf(input); });
}

/**
 * Starts programs for the next leaves, so that as many run as may run. The first of them is started
 * however large its leaf is.
 */
template <int D>
void DecomposedLeaves<D>::StartNext()
{
  constexpr std::size_t most = 64; // each has files open, also after its end
  while (!this->Upcoming.empty() && this->CountRunning() < this->NumberOfThreads &&
    (this->Runs.empty() ||
      (this->Runs.size() < most && this->HasMemoryFor(this->Upcoming.front()))))
  {
    vtkPolyData* input = this->Upcoming.front();
    this->Upcoming.pop_front();
    if (!this->FindKept(input) && this->FindRun(input) == this->Runs.end())
    {
      this->StartRun(input);
    }
  }
}

template <int D>
std::size_t DecomposedLeaves<D>::CountRunning()
{
  return std::count_if(this->Runs.begin(), this->Runs.end(),
    [](Run& run) { return run.IsStarted && (run.IsWaitedFor || run.Process.IsRunning()); });
}

/** Whether a program for a leaf fits into the machine's memory beside those that run. */
template <int D>
bool DecomposedLeaves<D>::HasMemoryFor(vtkPolyData* input) const
{
  const auto need = [this](vtkIdType points, vtkIdType cells)
  {
    return MemoryNeed::Estimate(
      static_cast<double>(points), static_cast<double>(cells), this->Settings)
      .Helper;
  };
  double needed = need(input->GetNumberOfPoints(), input->GetNumberOfCells());
  for (const Run& run : this->Runs)
  {
    needed += need(run.NumberOfPoints, run.NumberOfCells);
  }
  vtksys::SystemInformation system;
  return needed < GetMemoryOfMachine() - 1024.0 * static_cast<double>(system.GetHostMemoryUsed());
}

/** Starts the program for a leaf, unless the leaf is empty or has a mistake. */
template <int D>
void DecomposedLeaves<D>::StartRun(vtkPolyData* input)
{
  Run run;
  run.Leaf = std::make_shared<DecomposedLeaf<D>>();
  run.Leaf->Given = DataVersion(input); // by which the run is found, also after an error
  run.NumberOfPoints = input->GetNumberOfPoints();
  run.NumberOfCells = input->GetNumberOfCells();
  try
  {
    this->Start(input, run);
  }
  catch (const std::bad_alloc&)
  {
    run.Error = OutOfMemory; // of this leaf, also while another one is waited for
  }
  this->Runs.push_back(std::move(run));
}

template <int D>
void DecomposedLeaves<D>::Start(vtkPolyData* input, Run& run)
{
  DecomposedLeaf<D>& leaf = *run.Leaf;
  leaf.GivenInitial = DataVersion(this->Initial);
  leaf.Settings = this->Settings;
  run.Error = leaf.Input.Gather(input);
  leaf.Empty = leaf.Input.IsEmpty();
  if (run.Error.empty() && this->Settings.Initial == carving::InitialApproximation::Custom)
  {
    if (this->Initial)
    {
      run.Error = Kind<D>::GatherInitial(this->Initial, leaf.Input, leaf.Initial);
      run.Error =
        run.Error.empty() ? run.Error : "The initial approximation on port 1: " + run.Error;
    }
    else
    {
      run.Error = "InitialApproximation is CUSTOM, but input port 1 has no polygonal data.";
    }
  }
  if (run.Error.empty() && !leaf.Empty)
  {
    run.Begin = Clock::now();
    carving::Job job;
    static_cast<carving::HelperOptions&>(job) = this->Settings;
    job.Solid = this->Settings.Solid;
    job.DropSolid = !this->Settings.Reuse && !this->Settings.NeedsSolid;
    job.Processes = this->ThreadsOfLeaf;
    Kind<D>::Fill(job, leaf.Input, leaf.Initial);
    run.Error = CheckMemory(job);
    run.Error = run.Error.empty() ? run.Process.Start(job) : run.Error;
    run.IsStarted = run.Error.empty();
    run.Seconds = SecondsSince(run.Begin);
  }
}

template <int D>
typename DecomposedLeaves<D>::LeafPointer DecomposedLeaves<D>::FinishRun(
  Run& run, const std::string& where)
{
  carving::Reply& reply = run.Leaf->Reply;
  if (run.IsStarted)
  {
    const Clock::time_point begin = Clock::now();
    run.IsWaitedFor = true;
    const HelperProcess::Outcome outcome = run.Process.Wait(
      [this](const carving::WorkProgress& progress)
      {
        this->StartNext();
        return this->Stages.Report(
          static_cast<int>(progress.Stage), progress.Fraction, progress.Attempt);
      },
      reply, run.Error);
    run.Seconds += SecondsSince(begin);
    this->Stages.AddHelper(reply.StageSeconds, SecondsSince(run.Begin), run.Seconds);
    if (outcome == HelperProcess::Outcome::Aborted)
    {
      return nullptr;
    }
  }
  if (!run.Error.empty())
  {
    vtkErrorWithObjectMacro(this->Filter, << where << run.Error);
    return nullptr;
  }
  if (this->Settings.Reuse)
  {
    this->Kept.push_back(run.Leaf);
  }
  return run.Leaf;
}

template <int D>
void DecomposedLeaves<D>::FinishUpdate(bool aborted)
{
  if (!aborted)
  {
    this->Kept = std::move(this->Used);
  }
  this->Used.clear();
  this->Upcoming.clear();
  this->Runs.clear();
}

template class DecomposedLeaves<2>;
template class DecomposedLeaves<3>;
