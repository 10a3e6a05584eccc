// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTopologyCarver.h"

#include "CarverInput.h"
#include "CarverOutput.h"
#include "CompositeTree.h"
#include "HelperProcess.h"
#include "LevelSelection.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTypes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>

vtkStandardNewMacro(vtkTopologyCarver);

namespace
{

/** The stages of an update; the helper program's, carving::Stage, come first. */
enum UpdateStage
{
  Transfer = carving::NumberOfStages,
  Classify,
  Carve,
  Output,
  NumberOfUpdateStages
};

constexpr const char* OwnStageNames[] = { "transfer", "classify", "carve", "output" };

/** At which fraction of an update each stage begins; typical for a mesh of medium size. */
constexpr double StageBegins[NumberOfUpdateStages + 1] = { 0.0, 0.02, 0.2, 0.8, 0.84, 0.86, 0.93,
  1.0 };

/** What is kept of a leaf of the input between updates. */
struct CachedLeaf
{
  vtkMTimeType Time = 0; ///< of the leaf; unique, so that it identifies the leaf as well
  CarverInput Input;
  carving::Reply Reply;
};

/** Where the results for a polydata or a composite of them go. */
struct Outputs
{
  vtkMultiBlockDataSet* Levels;
  vtkDataObject* Stream;
  vtkDataObject* Profile;
};

} // namespace

class vtkTopologyCarver::vtkInternals
{
public:
  explicit vtkInternals(vtkTopologyCarver* self)
    : Self(self)
  {
  }

  void Begin(int numberOfLeaves);
  bool CarveLeaf(vtkPolyData* input, const Outputs& outputs);
  bool CarveTree(vtkDataObject* input, const Outputs& outputs);
  /** Forgets the leaves that the last update did not use. */
  void End();

  std::array<double, NumberOfUpdateStages> StageSeconds = {};

private:
  std::shared_ptr<CachedLeaf> Tetrahedralize(vtkPolyData* input);
  std::vector<int> SelectLevels(const carving::Profile& profile);
  bool Report(int stage, double fraction);
  void AddNotes(const CachedLeaf& leaf, const CarvedMesh& carved, vtkFieldData* fieldData);

  /** Adds to the seconds of a stage while it lives. */
  class Timer
  {
  public:
    Timer(vtkInternals& internals, UpdateStage stage)
      : Seconds(internals.StageSeconds[stage])
    {
    }
    ~Timer()
    {
      this->Seconds += this->GetElapsed();
    }
    double GetElapsed() const
    {
      return std::chrono::duration<double>(Clock::now() - this->Start).count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    double& Seconds;
    Clock::time_point Start = Clock::now();
  };

  vtkTopologyCarver* Self;
  std::vector<std::shared_ptr<CachedLeaf>> Cache;
  std::vector<std::shared_ptr<CachedLeaf>> Used;
  int NumberOfLeaves = 1;
  int LeavesDone = 0;
};

//------------------------------------------------------------------------------
void vtkTopologyCarver::vtkInternals::Begin(int numberOfLeaves)
{
  this->StageSeconds.fill(0.0);
  this->Used.clear();
  this->NumberOfLeaves = std::max(1, numberOfLeaves);
  this->LeavesDone = 0;
}

//------------------------------------------------------------------------------
void vtkTopologyCarver::vtkInternals::End()
{
  // What an abort did not get to may still be wanted.
  if (!this->Self->GetAbortExecute())
  {
    this->Cache = std::move(this->Used);
  }
  this->Used.clear();
}

//------------------------------------------------------------------------------
bool vtkTopologyCarver::vtkInternals::Report(int stage, double fraction)
{
  const double begin = StageBegins[stage];
  const double ofLeaf = begin + fraction * (StageBegins[stage + 1] - begin);
  const double ofAll = (this->LeavesDone + ofLeaf) / this->NumberOfLeaves;
  this->Self->SetProgressText(this->Self->GetStageName(stage));
  // Rounds of resolving start over; progress does not.
  this->Self->UpdateProgress(std::max(ofAll, this->Self->GetProgress()));
  return !this->Self->GetAbortExecute();
}

//------------------------------------------------------------------------------
std::shared_ptr<CachedLeaf> vtkTopologyCarver::vtkInternals::Tetrahedralize(vtkPolyData* input)
{
  for (const std::shared_ptr<CachedLeaf>& leaf : this->Cache)
  {
    if (leaf->Time == input->GetMTime())
    {
      return leaf;
    }
  }
  const auto leaf = std::make_shared<CachedLeaf>();
  leaf->Time = input->GetMTime();
  std::string error = leaf->Input.Gather(input);
  if (error.empty() && !leaf->Input.Mesh.Triangles.empty())
  {
    const Timer timer(*this, Transfer);
    carving::Job job;
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
    vtkErrorWithObjectMacro(this->Self, << error);
    return nullptr;
  }
  this->Cache.push_back(leaf);
  return leaf;
}

//------------------------------------------------------------------------------
std::vector<int> vtkTopologyCarver::vtkInternals::SelectLevels(const carving::Profile& profile)
{
  if (this->Self->Targets.empty())
  {
    return carving::SpreadLevels(profile, this->Self->NumberOfLevels);
  }
  const bool byVertices = this->Self->LevelTargetType == VERTICES;
  const std::vector<int>& counts = byVertices ? profile.Vertices : profile.Triangles;
  std::vector<int> steps;
  for (const double target : this->Self->Targets)
  {
    const int step = carving::LastStepWithin(counts, target);
    if (step < 0)
    {
      vtkWarningWithObjectMacro(this->Self, << "The target of " << target << " "
                                            << (byVertices ? "vertices" : "triangles")
                                            << " is below the " << counts.front()
                                            << " of the initial approximation, which is given "
                                               "instead.");
    }
    steps.push_back(std::max(0, step));
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

//------------------------------------------------------------------------------
void vtkTopologyCarver::vtkInternals::AddNotes(
  const CachedLeaf& leaf, const CarvedMesh& carved, vtkFieldData* fieldData)
{
  std::vector<std::string> texts = leaf.Input.Notes;
  if (leaf.Reply.IntersectingPairs > 0)
  {
    texts.push_back(std::to_string(leaf.Reply.IntersectingPairs) +
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
  if (carved.Stream.LastStep() == 0 && !leaf.Reply.Result.Surface.Triangles.empty())
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

//------------------------------------------------------------------------------
bool vtkTopologyCarver::vtkInternals::CarveLeaf(vtkPolyData* input, const Outputs& outputs)
{
  const std::shared_ptr<CachedLeaf> leaf = this->Tetrahedralize(input);
  if (!leaf)
  {
    return false;
  }
  this->Used.push_back(leaf);
  CarvedMesh carved(leaf->Reply.Result);
  {
    const Timer timer(*this, Classify);
    carved.Regions = carving::Classify(carved.Mesh);
  }
  if (!this->Report(Classify, 1.0))
  {
    return false;
  }
  {
    const Timer timer(*this, Carve);
    carving::CarveOptions options;
    options.CarveExposed = this->Self->CarveExposed;
    if (!carving::Carve(carved.Mesh, carved.Regions, options, carved.Stream,
          [this](double fraction) { return this->Report(Carve, fraction); }))
    {
      return false;
    }
    carved.Profile = carving::ComputeProfile(carved.Mesh, carved.Stream);
    double smallest = std::numeric_limits<double>::infinity();
    for (const double priority : carved.Stream.StepPriority)
    {
      smallest = std::fmin(smallest, priority);
      carved.FeatureSizes.push_back(smallest);
    }
  }
  const Timer timer(*this, Output);
  this->AddNotes(*leaf, carved, outputs.Levels->GetFieldData());
  if (carved.Mesh.Surface.Triangles.empty())
  {
    ++this->LeavesDone;
    return true; // nothing in, nothing out
  }
  const CarverOutput writer(carved, input, leaf->Input.CellIds);
  const std::vector<int> steps = this->SelectLevels(carved.Profile);
  outputs.Levels->SetNumberOfBlocks(static_cast<unsigned int>(steps.size()));
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    vtkNew<vtkPolyData> level;
    writer.FillLevel(steps[i], level);
    const unsigned int block = static_cast<unsigned int>(i);
    outputs.Levels->SetBlock(block, level);
    outputs.Levels->GetMetaData(block)->Set(
      vtkCompositeDataSet::NAME(), "LOD " + std::to_string(i));
    if (!this->Report(Output, (i + 1.0) / (steps.size() + 1.0)))
    {
      return false;
    }
  }
  writer.FillStream(vtkUnstructuredGrid::SafeDownCast(outputs.Stream));
  writer.FillProfile(vtkTable::SafeDownCast(outputs.Profile));
  const bool goOn = this->Report(Output, 1.0);
  ++this->LeavesDone;
  return goOn;
}

//------------------------------------------------------------------------------
bool vtkTopologyCarver::vtkInternals::CarveTree(vtkDataObject* input, const Outputs& outputs)
{
  std::vector<CompositeChild> children;
  if (!GetChildren(input, children))
  {
    vtkErrorWithObjectMacro(this->Self,
      << "A " << input->GetClassName()
      << " cannot be carved. Apply Extract Surface, or merge it into polygonal data first.");
    return false;
  }
  vtkMultiBlockDataSet* parents[] = { outputs.Levels,
    vtkMultiBlockDataSet::SafeDownCast(outputs.Stream),
    vtkMultiBlockDataSet::SafeDownCast(outputs.Profile) };
  for (vtkMultiBlockDataSet* parent : parents)
  {
    parent->SetNumberOfBlocks(static_cast<unsigned int>(children.size()));
  }
  for (std::size_t i = 0; i < children.size(); ++i)
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
      vtkErrorWithObjectMacro(this->Self,
        << "Block " << i << " \"" << child.Name << "\" is a " << child.Data->GetClassName()
        << ": only polygonal data can be carved. Apply Extract Surface first.");
    }
    if (this->Self->GetAbortExecute())
    {
      return false;
    }
    vtkDataObject* results[] = { stream ? levels.Get() : nullptr, stream, profile };
    const unsigned int block = static_cast<unsigned int>(i);
    for (int port = 0; port < 3; ++port)
    {
      parents[port]->SetBlock(block, results[port]);
      if (!child.Name.empty())
      {
        parents[port]->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), child.Name);
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkTopologyCarver::vtkTopologyCarver()
  : Internals(new vtkInternals(this))
{
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkTopologyCarver::~vtkTopologyCarver() = default;

//------------------------------------------------------------------------------
void vtkTopologyCarver::AddLevelTarget(double target)
{
  this->Targets.push_back(target);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTopologyCarver::ClearLevelTargets()
{
  if (!this->Targets.empty())
  {
    this->Targets.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::GetNumberOfLevelTargets()
{
  return static_cast<int>(this->Targets.size());
}

//------------------------------------------------------------------------------
double vtkTopologyCarver::GetLevelTarget(int index)
{
  return index >= 0 && index < this->GetNumberOfLevelTargets() ? this->Targets[index] : 0.0;
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::GetNumberOfStages()
{
  return NumberOfUpdateStages;
}

//------------------------------------------------------------------------------
const char* vtkTopologyCarver::GetStageName(int stage)
{
  if (stage < 0 || stage >= NumberOfUpdateStages)
  {
    return nullptr;
  }
  return stage < carving::NumberOfStages ? carving::StageName(static_cast<carving::Stage>(stage))
                                         : OwnStageNames[stage - carving::NumberOfStages];
}

//------------------------------------------------------------------------------
double vtkTopologyCarver::GetStageSeconds(int stage)
{
  return stage < 0 || stage >= NumberOfUpdateStages ? 0.0 : this->Internals->StageSeconds[stage];
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  // Declared too, or the pipeline would feed the leaves one by one and keep the last result only.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::FillOutputPortInformation(int port, vtkInformation* info)
{
  // The types of ports 1 and 2 follow the input's.
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkMultiBlockDataSet" : "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::RequestDataObject(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  const bool composite = vtkCompositeDataSet::GetData(in[0]) != nullptr;
  const char* types[] = { "vtkMultiBlockDataSet",
    composite ? "vtkMultiBlockDataSet" : "vtkUnstructuredGrid",
    composite ? "vtkMultiBlockDataSet" : "vtkTable" };
  for (int port = 0; port < 3; ++port)
  {
    vtkDataObject* current = vtkDataObject::GetData(out, port);
    if (!current || !current->IsA(types[port]))
    {
      vtkSmartPointer<vtkDataObject> output;
      output.TakeReference(vtkDataObjectTypes::NewDataObject(types[port]));
      out->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(), output);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  vtkDataObject* input = vtkDataObject::GetData(in[0], 0);
  const Outputs outputs = { vtkMultiBlockDataSet::GetData(out, 0), vtkDataObject::GetData(out, 1),
    vtkDataObject::GetData(out, 2) };
  auto* polyData = vtkPolyData::SafeDownCast(input);
  this->Internals->Begin(
    polyData ? 1 : static_cast<int>(vtkCompositeDataSet::GetDataSets<vtkPolyData>(input).size()));
  const bool good = polyData ? this->Internals->CarveLeaf(polyData, outputs)
                             : this->Internals->CarveTree(input, outputs);
  this->Internals->End();
  if (!good)
  {
    for (vtkDataObject* output :
      std::initializer_list<vtkDataObject*>{ outputs.Levels, outputs.Stream, outputs.Profile })
    {
      output->Initialize();
    }
  }
  return good || this->GetAbortExecute();
}

//------------------------------------------------------------------------------
void vtkTopologyCarver::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CarveExposed: " << (this->CarveExposed ? "On" : "Off") << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent
     << "LevelTargetType: " << (this->LevelTargetType == VERTICES ? "VERTICES" : "TRIANGLES")
     << "\n";
  os << indent << "LevelTargets:";
  for (const double target : this->Targets)
  {
    os << " " << target;
  }
  os << "\n";
}
