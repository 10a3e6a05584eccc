// SPDX-License-Identifier: BSD-3-Clause
#include "CarverSession.h"

#include "CarverInput.h"
#include "CarverOutput.h"
#include "CompositeTree.h"
#include "HelperProcess.h"
#include "InitialDistance.h"
#include "LevelSelection.h"
#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

/** What is kept of a leaf of the input between updates. */
struct CarverSession::Leaf
{
  vtkMTimeType Time = 0; ///< of the leaf; unique, so that it identifies the leaf as well
  carving::InitialApproximation Initial = carving::InitialApproximation::ConvexHull;
  CarverInput Input;
  carving::Reply Reply;
};

/** Adds to the seconds of a stage while it lives. */
class CarverSession::Timer
{
public:
  Timer(CarverSession& session, Stage stage)
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

constexpr const char* OwnStageNames[] = { "transfer", "classify", "carve", "output" };

/** At which fraction of an update each stage begins; typical for a mesh of medium size. */
constexpr double StageBegins[CarverSession::NumberOfStages + 1] = { 0.0, 0.02, 0.2, 0.8, 0.84, 0.86,
  0.93, 1.0 };

void SetName(vtkMultiBlockDataSet* parent, unsigned int block, const std::string& name)
{
  if (!name.empty())
  {
    parent->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name);
  }
}

/** What the user should know, as the string array `Notes`. */
void AddNotes(const CarverInput& input, const carving::Reply& reply, const CarvedMesh& carved,
  vtkFieldData* fieldData)
{
  std::vector<std::string> texts = input.Notes;
  if (reply.IntersectingPairs > 0)
  {
    texts.push_back(std::to_string(reply.IntersectingPairs) +
      " pairs of triangles cross each other and were split where they meet.");
  }
  const auto& regions = carved.Regions.Regions;
  const auto guessed = std::count_if(
    regions.begin(), regions.end(), [](const carving::Region& region) { return region.Guessed; });
  if (guessed > 0)
  {
    texts.push_back("The mesh is open or inconsistently oriented: whether " +
      std::to_string(guessed) + " of its enclosed regions are solid is a guess.");
  }
  if (carved.Stream.LastStep() == 0 && !carved.Mesh.Surface.Triangles.empty())
  {
    texts.push_back("The mesh is its own convex hull: there is nothing to carve.");
  }
  if (texts.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> notes;
  notes->SetName("Notes");
  for (const std::string& text : texts)
  {
    notes->InsertNextValue(text);
  }
  fieldData->AddArray(notes);
}

} // namespace

CarverSession::CarverSession(vtkAlgorithm* filter)
  : Filter(filter)
{
}

CarverSession::~CarverSession() = default;

const char* CarverSession::GetStageName(int stage)
{
  return stage < carving::NumberOfStages ? carving::StageName(static_cast<carving::Stage>(stage))
                                         : OwnStageNames[stage - carving::NumberOfStages];
}

bool CarverSession::Update(
  vtkDataObject* input, const CarverSettings& settings, const CarverPorts& ports)
{
  this->Settings = settings;
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

bool CarverSession::Report(int stage, double fraction)
{
  const double begin = StageBegins[stage];
  const double ofLeaf = begin + fraction * (StageBegins[stage + 1] - begin);
  const double ofAll = (this->LeavesDone + ofLeaf) / this->NumberOfLeaves;
  this->Filter->SetProgressText(GetStageName(stage));
  // Rounds of resolving start over; progress does not.
  this->Filter->UpdateProgress(std::max(ofAll, this->Filter->GetProgress()));
  return !this->Filter->GetAbortExecute();
}

std::shared_ptr<CarverSession::Leaf> CarverSession::Tetrahedralize(vtkPolyData* input)
{
  for (const std::shared_ptr<Leaf>& leaf : this->Cache)
  {
    if (leaf->Time == input->GetMTime() && leaf->Initial == this->Settings.Initial)
    {
      return leaf;
    }
  }
  const auto leaf = std::make_shared<Leaf>();
  leaf->Time = input->GetMTime();
  leaf->Initial = this->Settings.Initial;
  std::string error = leaf->Input.Gather(input);
  if (error.empty() && !leaf->Input.Mesh.Triangles.empty())
  {
    const Timer timer(*this, Transfer);
    carving::Job job;
    job.Initial = leaf->Initial;
    job.Mesh = std::move(leaf->Input.Mesh);
    const HelperProcess::Outcome outcome = HelperProcess::Run(
      job, leaf->Reply,
      [this](carving::Stage stage, double fraction)
      { return this->Report(static_cast<int>(stage), fraction); },
      error);
    if (outcome == HelperProcess::Outcome::Aborted)
    {
      return nullptr;
    }
    for (std::size_t stage = 0; stage < leaf->Reply.StageSeconds.size(); ++stage)
    {
      // The timer runs over the helper's stages too; transfer is what remains.
      this->StageSeconds[stage] += leaf->Reply.StageSeconds[stage];
      this->StageSeconds[Transfer] -= leaf->Reply.StageSeconds[stage];
    }
  }
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(this->Filter, << error);
    return nullptr;
  }
  this->Cache.push_back(leaf);
  return leaf;
}

bool CarverSession::CarveTetrahedra(CarvedMesh& carved)
{
  {
    const Timer timer(*this, Classify);
    carved.Regions = carving::Classify(carved.Mesh, this->Settings.Solid);
  }
  if (!this->Report(Classify, 1.0))
  {
    return false;
  }
  const Timer timer(*this, Carve);
  carving::CarveOptions options = this->Settings.Carve;
  if (this->Settings.DepthIsDistance)
  {
    options.Depths = ComputeInitialDistances(carved.Mesh);
  }
  if (!carving::Carve(carved.Mesh, carved.Regions, options, carved.Stream,
        [this](double fraction) { return this->Report(Carve, fraction); }))
  {
    return false;
  }
  carved.Profile = carving::ComputeProfile(carved.Mesh, carved.Stream);
  double smallest = std::numeric_limits<double>::infinity();
  for (const double priority : carved.Stream.StepPriority)
  {
    // The priority of step 0 is NaN, which fmin passes over.
    smallest = std::fmin(smallest, carving::PriorityAsLength(priority, options.Measure));
    carved.FeatureSizes.push_back(smallest);
  }
  return true;
}

std::vector<int> CarverSession::SelectLevels(const carving::Profile& profile)
{
  if (this->Settings.LevelTargets.empty())
  {
    return carving::SpreadLevels(profile, this->Settings.NumberOfLevels);
  }
  const bool byTriangles = this->Settings.TargetsAreTriangles;
  const std::vector<int>& counts = byTriangles ? profile.Triangles : profile.Vertices;
  std::vector<int> steps;
  for (const double target : this->Settings.LevelTargets)
  {
    const int step = carving::LastStepWithin(counts, target);
    if (step < 0)
    {
      vtkWarningWithObjectMacro(this->Filter, << "The target of " << target
                                              << (byTriangles ? " triangles" : " vertices")
                                              << " is below the " << counts.front()
                                              << " of the initial approximation, which is given "
                                                 "instead.");
    }
    steps.push_back(std::max(0, step));
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

bool CarverSession::CarveLeaf(vtkPolyData* input, const CarverPorts& ports)
{
  const std::shared_ptr<Leaf> leaf = this->Tetrahedralize(input);
  if (!leaf)
  {
    return false;
  }
  this->Used.push_back(leaf);
  CarvedMesh carved(leaf->Reply.Result);
  if (!this->CarveTetrahedra(carved))
  {
    return false;
  }
  const Timer timer(*this, Output);
  AddNotes(leaf->Input, leaf->Reply, carved, ports.Levels->GetFieldData());
  if (!carved.Mesh.Surface.Triangles.empty()) // else nothing in, nothing out
  {
    const CarverOutput writer(carved, input, leaf->Input.CellIds);
    const std::vector<int> steps = this->SelectLevels(carved.Profile);
    const unsigned int count = static_cast<unsigned int>(steps.size());
    ports.Levels->SetNumberOfBlocks(count);
    for (unsigned int i = 0; i < count; ++i)
    {
      vtkNew<vtkPolyData> level;
      writer.FillLevel(steps[i], level);
      ports.Levels->SetBlock(i, level);
      SetName(ports.Levels, i, "LOD " + std::to_string(i));
      if (!this->Report(Output, (i + 1.0) / (count + 1.0)))
      {
        return false;
      }
    }
    writer.FillStream(vtkUnstructuredGrid::SafeDownCast(ports.Stream));
    writer.FillProfile(vtkTable::SafeDownCast(ports.Profile));
  }
  const bool goOn = this->Report(Output, 1.0);
  ++this->LeavesDone;
  return goOn;
}

bool CarverSession::CarveTree(vtkDataObject* input, const CarverPorts& ports)
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
      SetName(parents[port], i, child.Name);
    }
  }
  return true;
}
