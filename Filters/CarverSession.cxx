// SPDX-License-Identifier: BSD-3-Clause
#include "CarverSession.h"

#include "ArrayTools.h"
#include "CarverKind.h"
#include "CarverNotes.h"
#include "CompositeTree.h"
#include "HelperProcess.h"
#include "InitialDistance.h"
#include "LevelOutput.h"
#include "StoredStream.h"
#include "StreamError.h"
#include "StreamOutput.h"
#include "StreamTopology.h"
#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

/** What is kept of a leaf of the input between updates. */
template <int D>
struct CarverSession<D>::Leaf
{
  vtkMTimeType Time = 0; ///< of the leaf; unique, so that it identifies the leaf as well
  carving::HelperOptions Options;
  carving::SolidRule Solid = carving::SolidRule::NonzeroWinding; ///< as the helper was told
  vtkMTimeType InitialTime = 0; ///< of the given initial approximation
  typename Kind<D>::Input Input;
  typename Kind<D>::Input Initial;
  bool Empty = false;
  carving::Reply Reply;
};

/** What an update makes of a leaf. */
template <int D>
struct CarverSession<D>::Result
{
  carving::StoredStream<D> Stream;
  carving::Profile Profile;
  int GuessedRegions = 0;
  int LeftByBudget = 0;
};

/** Adds to the seconds of a stage while it lives. */
template <int D>
class CarverSession<D>::Timer
{
public:
  Timer(CarverSession& session, int stage)
    : Seconds(session.StageSeconds[stage])
  {
  }
  ~Timer()
  {
    this->Seconds += std::chrono::duration<double>(Clock::now() - this->Start).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  double& Seconds;
  Clock::time_point Start = Clock::now();
};

namespace
{

constexpr const char* OwnStageNames[] = { "transfer", "classify", "carve", "measure", "output" };

/** At which fraction of an update each stage begins; typical for a mesh of medium size. */
constexpr double StageBegins[NumberOfCarverStages + 1] = { 0.0, 0.02, 0.2, 0.8, 0.84, 0.86, 0.9,
  0.93, 1.0 };

} // namespace

const char* GetCarverStageName(int stage)
{
  return stage < carving::NumberOfStages ? carving::StageName(static_cast<carving::Stage>(stage))
                                         : OwnStageNames[stage - carving::NumberOfStages];
}

template <int D>
CarverSession<D>::CarverSession(vtkAlgorithm* filter)
  : Filter(filter)
{
}

template <int D>
CarverSession<D>::~CarverSession() = default;

template <int D>
bool CarverSession<D>::Update(vtkDataObject* input, vtkPolyData* initial,
  const CarverSettings& settings, const CarverPorts& ports)
{
  this->Settings = settings;
  this->Initial = initial;
  this->StageSeconds.fill(0.0);
  this->LeavesDone = 0;
  this->NumberOfLeaves = 1;
  bool good = false;
  if (auto* polyData = vtkPolyData::SafeDownCast(input))
  {
    good = this->CarveLeaf(polyData, ports);
  }
  else
  {
    const auto leaves = vtkCompositeDataSet::GetDataSets<vtkPolyData>(input);
    this->NumberOfLeaves = std::max(1, static_cast<int>(leaves.size()));
    good = this->CarveTree(input, ports);
  }
  // What an abort did not get to may still be wanted.
  if (!this->Filter->GetAbortExecute())
  {
    this->Cache = std::move(this->Used);
  }
  this->Used.clear();
  return good;
}

template <int D>
bool CarverSession<D>::Report(int stage, double fraction)
{
  const double begin = StageBegins[stage];
  const double ofLeaf = begin + fraction * (StageBegins[stage + 1] - begin);
  const double ofAll = (this->LeavesDone + ofLeaf) / this->NumberOfLeaves;
  this->Filter->SetProgressText(GetCarverStageName(stage));
  // Rounds of resolving start over; progress does not.
  this->Filter->UpdateProgress(std::max(ofAll, this->Filter->GetProgress()));
  return !this->Filter->GetAbortExecute();
}

template <int D>
std::shared_ptr<typename CarverSession<D>::Leaf> CarverSession<D>::Decompose(vtkPolyData* input)
{
  const bool custom = this->Settings.Initial == carving::InitialApproximation::Custom;
  const vtkMTimeType initialTime = custom && this->Initial ? this->Initial->GetMTime() : 0;
  for (const std::shared_ptr<Leaf>& leaf : this->Cache)
  {
    if (leaf->Time == input->GetMTime() && leaf->InitialTime == initialTime &&
      leaf->Options == this->Settings &&
      (leaf->Solid == this->Settings.Solid || leaf->Reply.SolidMatters == 0))
    {
      return leaf;
    }
  }
  const auto leaf = std::make_shared<Leaf>();
  leaf->Time = input->GetMTime();
  leaf->Options = this->Settings;
  leaf->Solid = this->Settings.Solid;
  leaf->InitialTime = initialTime;
  std::string error = leaf->Input.Gather(input);
  leaf->Empty = leaf->Input.IsEmpty();
  if (error.empty() && custom && !this->Initial)
  {
    error = "InitialApproximation is CUSTOM, but input port 1 has no polygonal data.";
  }
  else if (error.empty() && custom)
  {
    error = Kind<D>::GatherInitial(this->Initial, leaf->Input, leaf->Initial);
    error = error.empty() ? error : "The initial approximation on port 1: " + error;
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
  this->Cache.push_back(leaf);
  return leaf;
}

template <int D>
bool CarverSession<D>::RunHelper(Leaf& leaf, std::string& error)
{
  const Timer timer(*this, TransferStage);
  carving::Job job;
  static_cast<carving::HelperOptions&>(job) = leaf.Options;
  job.Solid = leaf.Solid;
  Kind<D>::Fill(job, leaf.Input, leaf.Initial);
  const HelperProcess::Outcome outcome = HelperProcess::Run(
    job, leaf.Reply,
    [this](carving::Stage stage, double fraction)
    { return this->Report(static_cast<int>(stage), fraction); },
    error);
  for (std::size_t stage = 0; stage < leaf.Reply.StageSeconds.size(); ++stage)
  {
    // The timer runs over the helper's stages too; transfer is what remains.
    this->StageSeconds[stage] += leaf.Reply.StageSeconds[stage];
    this->StageSeconds[TransferStage] -= leaf.Reply.StageSeconds[stage];
  }
  return outcome != HelperProcess::Outcome::Aborted;
}

template <int D>
bool CarverSession<D>::Carve(const Leaf& leaf, Result& result)
{
  const carving::Decomposition<D>& mesh = Kind<D>::GetResult(leaf.Reply);
  carving::Classification regions;
  {
    const Timer timer(*this, ClassifyStage);
    regions = carving::Classify(mesh, this->Settings.Solid);
  }
  result.GuessedRegions = static_cast<int>(std::count_if(regions.Regions.begin(),
    regions.Regions.end(), [](const carving::Region& region) { return region.Guessed; }));
  if (!this->Report(ClassifyStage, 1.0))
  {
    return false;
  }
  const Timer timer(*this, CarveStage);
  carving::CarveOptions options = this->Settings.Carve;
  if (this->Settings.DepthIsDistance)
  {
    options.Depths = ComputeInitialDistances(mesh);
  }
  carving::Stream stream;
  if (!carving::Carve(mesh, regions, options, stream,
        [this](double fraction) { return this->Report(CarveStage, fraction); }))
  {
    return false;
  }
  const carving::BettiNumbers& budget = options.Budget;
  if (std::any_of(budget.begin(), budget.end(), [](int limit) { return limit >= 0; }))
  {
    result.LeftByBudget = carving::CountLeft(regions, options, stream);
  }
  result.Stream = carving::Store(mesh, regions, stream);
  Kind<D>::Restore(leaf.Input, result.Stream.Mesh.Surface.Points);
  result.Stream.Measure = options.Measure;
  result.Stream.Folds =
    this->Settings.KeepBothFoldSides ? carving::FoldSides::Both : carving::FoldSides::One;
  result.Profile = carving::ComputeProfile(result.Stream);
  carving::SetTopology(result.Profile, mesh, regions, stream);
  return true;
}

template <int D>
bool CarverSession<D>::Measure(const Leaf& leaf, Result& result)
{
  if (!this->Settings.ComputeError &&
    (this->Settings.LevelTargets.empty() ||
      this->Settings.TargetType != carving::LevelTarget::ErrorBound))
  {
    return true;
  }
  const Timer timer(*this, MeasureStage);
  const carving::ResolvedInput<D>& unresolved = Kind<D>::GetResult(leaf.Reply).Unresolved;
  const bool conforming = unresolved.Facets.empty();
  return carving::ComputeErrors(result.Stream, conforming ? result.Stream.Mesh.Surface : unresolved,
    conforming, result.Profile.Error,
    [this](double fraction) { return this->Report(MeasureStage, fraction); });
}

template <int D>
std::vector<int> CarverSession<D>::SelectLevels(const carving::Profile& profile)
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
      vtkWarningWithObjectMacro(this->Filter, << selected.Problem);
    }
    steps.push_back(selected.Step);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

template <int D>
bool CarverSession<D>::CarveLeaf(vtkPolyData* input, const CarverPorts& ports)
{
  const std::shared_ptr<Leaf> leaf = this->Decompose(input);
  if (!leaf)
  {
    return false;
  }
  this->Used.push_back(leaf);
  if (leaf->Empty) // nothing in, nothing out
  {
    AddNotes(leaf->Input.Notes, {}, 0, false, ports.Levels->GetFieldData());
    ++this->LeavesDone;
    return true;
  }
  Result result;
  if (!this->Carve(*leaf, result) || !this->Measure(*leaf, result))
  {
    return false;
  }
  const Timer timer(*this, OutputStage);
  std::vector<std::string> notes = leaf->Input.Notes;
  if (result.LeftByBudget > 0)
  {
    notes.push_back("The budget of components, tunnels and voids leaves " +
      std::to_string(result.LeftByBudget) + (D == 3 ? " tetrahedra" : " triangles") +
      " that would exceed it: the last level is not the input.");
  }
  AddNotes(notes, leaf->Reply, result.GuessedRegions,
    result.Profile.LastStep() == 0 && result.LeftByBudget == 0, ports.Levels->GetFieldData());
  auto* grid = vtkUnstructuredGrid::SafeDownCast(ports.Stream);
  FillStream(result.Stream, result.Profile, input, leaf->Input.CellIds, grid);
  AddSettings(this->Settings, leaf->Reply, grid->GetFieldData());
  FillProfile(result.Profile, vtkTable::SafeDownCast(ports.Profile));
  const std::vector<int> steps = this->SelectLevels(result.Profile);
  const std::vector<carving::Level<D>> levels = carving::ExtractLevels(result.Stream, steps);
  const unsigned int count = static_cast<unsigned int>(steps.size());
  ports.Levels->SetNumberOfBlocks(count);
  for (unsigned int i = 0; i < count; ++i)
  {
    vtkNew<vtkPolyData> level;
    FillLevel(result.Stream, result.Profile, grid, levels[i], this->Settings.ManifoldOutput, level);
    ports.Levels->SetBlock(i, level);
    SetBlockName(ports.Levels, i, "LOD " + std::to_string(i));
    if (!this->Report(OutputStage, (i + 1.0) / (count + 1.0)))
    {
      return false;
    }
  }
  if constexpr (D == 3)
  {
    if (this->Settings.AppendInput && !leaf->Reply.Result.Kept.empty())
    {
      vtkNew<vtkPolyData> level;
      FillInputLevel(
        leaf->Reply.Result.Unresolved, result.Profile, input, leaf->Input.CellIds, grid, level);
      ports.Levels->SetBlock(count, level);
      SetBlockName(ports.Levels, count, "LOD " + std::to_string(count));
    }
  }
  const bool goOn = this->Report(OutputStage, 1.0);
  ++this->LeavesDone;
  return goOn;
}

template <int D>
bool CarverSession<D>::CarveTree(vtkDataObject* input, const CarverPorts& ports)
{
  std::vector<CompositeChild> children;
  if (!GetChildren(input, children))
  {
    vtkErrorWithObjectMacro(this->Filter,
      << "A " << input->GetClassName()
      << " cannot be carved. Apply Extract Surface, or merge it into polygonal data first.");
    return false;
  }
  vtkMultiBlockDataSet* parents[] = { ports.Levels,
    vtkMultiBlockDataSet::SafeDownCast(ports.Stream),
    vtkMultiBlockDataSet::SafeDownCast(ports.Profile) };
  for (vtkMultiBlockDataSet* parent : parents)
  {
    parent->SetNumberOfBlocks(static_cast<unsigned int>(children.size()));
  }
  for (unsigned int i = 0; i < children.size(); ++i)
  {
    const CompositeChild& child = children[i];
    vtkNew<vtkMultiBlockDataSet> levels;
    vtkSmartPointer<vtkDataObject> stream, profile;
    if (auto* leaf = vtkPolyData::SafeDownCast(child.Data))
    {
      stream = vtkSmartPointer<vtkUnstructuredGrid>::New();
      profile = vtkSmartPointer<vtkTable>::New();
      // A leaf that fails has said so and stays empty; the others still come out.
      this->CarveLeaf(leaf, { levels, stream, profile });
    }
    else if (child.Data && child.Data->IsA("vtkCompositeDataSet"))
    {
      stream = vtkSmartPointer<vtkMultiBlockDataSet>::New();
      profile = vtkSmartPointer<vtkMultiBlockDataSet>::New();
      this->CarveTree(child.Data, { levels, stream, profile });
    }
    else if (child.Data)
    {
      vtkErrorWithObjectMacro(this->Filter,
        << "Block " << i << " \"" << child.Name << "\" is a " << child.Data->GetClassName()
        << ": only polygonal data can be carved. Apply Extract Surface first.");
    }
    if (this->Filter->GetAbortExecute())
    {
      return false;
    }
    vtkDataObject* results[] = { stream ? levels.Get() : nullptr, stream, profile };
    for (int port = 0; port < 3; ++port)
    {
      parents[port]->SetBlock(i, results[port]);
      SetBlockName(parents[port], i, child.Name);
    }
  }
  return true;
}

template class CarverSession<2>;
template class CarverSession<3>;
