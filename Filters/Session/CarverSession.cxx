// SPDX-License-Identifier: BSD-3-Clause
#include "Session/CarverSession.h"

#include "Convert/ArrayTools.h"
#include "Convert/InitialDistance.h"
#include "Convert/LevelOutput.h"
#include "Convert/OwnArrays.h"
#include "Convert/StreamOutput.h"
#include "Core/Measure/StreamError.h"
#include "Core/Measure/StreamTopology.h"
#include "Core/Stream/StoredStream.h"
#include "Objects/CompositeTree.h"
#include "Objects/DataVersion.h"
#include "Process/HelperProcess.h"
#include "Session/CarverKind.h"
#include "Session/CarverNotes.h"
#include "Session/HelperReuse.h"
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
#include "vtkVersionMacros.h"

#include <algorithm>
#include <initializer_list>

/** What is kept of a leaf of the input between updates. */
template <int D>
struct CarverSession<D>::Leaf
{
  DataVersion Given;
  DataVersion GivenInitial; ///< for InitialApproximation::Custom
  HelperSettings Settings;  ///< as the helper was told
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

bool IsAborted(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
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
    // The pipeline has passed the field data of the whole.
    RemoveOwnFieldData(ports.Levels->GetFieldData());
    RemoveOwnFieldData(ports.Stream->GetFieldData());
    RemoveOwnFieldData(ports.Profile->GetFieldData());
    good = this->CarveTree(input, ports);
  }
  // What an abort did not get to may still be wanted.
  if (!IsAborted(this->Filter))
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
  return !IsAborted(this->Filter);
}

template <int D>
std::shared_ptr<typename CarverSession<D>::Leaf> CarverSession<D>::Decompose(vtkPolyData* input)
{
  const bool custom = this->Settings.Initial == carving::InitialApproximation::Custom;
  vtkPolyData* initial = custom ? this->Initial : nullptr;
  for (const std::shared_ptr<Leaf>& leaf : this->Cache)
  {
    if (leaf->Given.IsOf(input) && leaf->GivenInitial.IsOf(initial) &&
      WouldAnswerAlike(leaf->Reply, leaf->Settings, this->Settings, D))
    {
      return leaf;
    }
  }
  const auto leaf = std::make_shared<Leaf>();
  leaf->Given = DataVersion(input);
  leaf->GivenInitial = DataVersion(initial);
  leaf->Settings = this->Settings;
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
  static_cast<carving::HelperOptions&>(job) = leaf.Settings;
  job.Solid = leaf.Settings.Solid;
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
  if (carving::HasLimits(options.Budget))
  {
    result.LeftByBudget = carving::CountLeft(regions, options, stream);
  }
  result.Stream = carving::Store(mesh, regions, stream);
  Kind<D>::Restore(leaf.Input, result.Stream.Mesh.Surface.Points);
  result.Stream.Measure = options.Measure;
  result.Stream.Folds = this->Settings.Folds;
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
bool CarverSession<D>::WriteLevels(const Result& result, const std::vector<int>& steps,
  vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* levels)
{
  // One walk over the stream finds the faces of this many levels. The number bounds the time between reports.
  constexpr std::size_t levelsAtOnce = 16;
  levels->SetNumberOfBlocks(static_cast<unsigned int>(steps.size()));
  for (std::size_t first = 0; first < steps.size(); first += levelsAtOnce)
  {
    const std::size_t end = std::min(first + levelsAtOnce, steps.size());
    const std::vector<carving::Level<D>> found =
      carving::ExtractLevels(result.Stream, { steps.begin() + first, steps.begin() + end });
    for (std::size_t i = first; i < end; ++i)
    {
      vtkNew<vtkPolyData> level;
      FillLevel(result.Stream, result.Profile, grid, found[i - first],
        this->Settings.ManifoldOutput, level);
      const unsigned int block = static_cast<unsigned int>(i);
      levels->SetBlock(block, level);
      SetBlockName(levels, block, "LOD " + std::to_string(i));
      if (!this->Report(OutputStage, (i + 1.0) / (steps.size() + 1.0)))
      {
        return false;
      }
    }
  }
  return true;
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
  for (vtkDataObject* output :
    std::initializer_list<vtkDataObject*>{ ports.Levels, ports.Stream, ports.Profile })
  {
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    RemoveOwnFieldData(output->GetFieldData());
  }
  std::vector<std::string> notes = leaf->Input.Notes;
  if (leaf->Empty) // nothing in, nothing out
  {
    AddNotes(notes, {}, 0, false, ports.Levels->GetFieldData());
    ++this->LeavesDone;
    return true;
  }
  Result result;
  if (!this->Carve(*leaf, result) || !this->Measure(*leaf, result))
  {
    return false;
  }
  const Timer timer(*this, OutputStage);
  const vtkSmartPointer<vtkPolyData> attributes = RenameForeignArrays(input, notes);
  if (result.LeftByBudget > 0)
  {
    notes.push_back("The budget of components, tunnels and voids leaves " +
      std::to_string(result.LeftByBudget) + (D == 3 ? " tetrahedra" : " triangles") +
      " that would exceed it: the last level is not the input.");
  }
  AddNotes(notes, leaf->Reply, result.GuessedRegions,
    result.Profile.LastStep() == 0 && result.LeftByBudget == 0, ports.Levels->GetFieldData());
  auto* grid = vtkUnstructuredGrid::SafeDownCast(ports.Stream);
  FillStream(result.Stream, result.Profile, attributes, leaf->Input.CellIds, grid);
  AddSettings(this->Settings, leaf->Reply, grid->GetFieldData());
  FillProfile(result.Profile, vtkTable::SafeDownCast(ports.Profile));
  const std::vector<int> steps = this->SelectLevels(result.Profile);
  if (!this->WriteLevels(result, steps, grid, ports.Levels))
  {
    return false;
  }
  if constexpr (D == 3)
  {
    if (this->Settings.AppendInput && !leaf->Reply.Result.Kept.empty())
    {
      vtkNew<vtkPolyData> level;
      FillInputLevel(leaf->Reply.Result.Unresolved, result.Profile, attributes, leaf->Input.CellIds,
        grid, level);
      const unsigned int count = ports.Levels->GetNumberOfBlocks();
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
    if (IsAborted(this->Filter))
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
