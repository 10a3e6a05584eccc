// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "Process/HelperProcess.h"
#include "RealMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace
{

constexpr const char* HelperVariable = "TOPOLOGYCARVING_HELPER";

void Log(const std::string& message)
{
  const char* folder = std::getenv("TOPOLOGYCARVING_MESSAGE_LOGS");
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  if (folder && test)
  {
    // Tests count open files, so none stays open.
    static std::ios::openmode mode = std::ios::trunc;
    std::ofstream(std::string(folder) + "/" + test->test_suite_name() + "." + test->name(),
      std::ios::out | mode)
      << message << '\0';
    mode = std::ios::app;
  }
}

void ExpectEqualArrays(vtkAbstractArray* a, vtkAbstractArray* b)
{
  ASSERT_EQ(a->GetDataType(), b->GetDataType());
  ASSERT_EQ(a->GetNumberOfComponents(), b->GetNumberOfComponents());
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
  if (auto* strings = vtkStringArray::SafeDownCast(a))
  {
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
    {
      ASSERT_EQ(strings->GetValue(i), vtkStringArray::SafeDownCast(b)->GetValue(i));
    }
    return;
  }
  ASSERT_TRUE(vtkDataArray::SafeDownCast(a));
  const auto* bytes = static_cast<const char*>(a->GetVoidPointer(0));
  EXPECT_TRUE(std::equal(bytes, bytes + a->GetNumberOfValues() * a->GetDataTypeSize(),
    static_cast<const char*>(b->GetVoidPointer(0))));
}

void ExpectEqualArrays(vtkFieldData* a, vtkFieldData* b)
{
  ASSERT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays());
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    const char* name = a->GetArrayName(i);
    SCOPED_TRACE(name);
    ASSERT_TRUE(b->GetAbstractArray(name));
    ExpectEqualArrays(a->GetAbstractArray(i), b->GetAbstractArray(name));
  }
}

void ExpectEqualCells(vtkCellArray* a, vtkCellArray* b)
{
  ExpectEqualArrays(a->GetOffsetsArray(), b->GetOffsetsArray());
  ExpectEqualArrays(a->GetConnectivityArray(), b->GetConnectivityArray());
}

void ExpectEqualPoints(vtkPointSet* a, vtkPointSet* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  if (a->GetNumberOfPoints() > 0)
  {
    ExpectEqualArrays(a->GetPoints()->GetData(), b->GetPoints()->GetData());
  }
  ExpectEqualArrays(a->GetPointData(), b->GetPointData());
  ExpectEqualArrays(a->GetCellData(), b->GetCellData());
}

void ExpectEqualBlocks(vtkMultiBlockDataSet* a, vtkMultiBlockDataSet* b)
{
  ASSERT_EQ(a->GetNumberOfBlocks(), b->GetNumberOfBlocks());
  for (unsigned int i = 0; i < a->GetNumberOfBlocks(); ++i)
  {
    SCOPED_TRACE("block " + std::to_string(i));
    ASSERT_EQ(a->HasMetaData(i), b->HasMetaData(i));
    if (a->HasMetaData(i))
    {
      EXPECT_STREQ(a->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()),
        b->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()));
    }
    ASSERT_EQ(!a->GetBlock(i), !b->GetBlock(i));
    if (a->GetBlock(i))
    {
      ExpectEqualData(a->GetBlock(i), b->GetBlock(i));
    }
  }
}

} // namespace

void ExpectEqualData(vtkDataObject* a, vtkDataObject* b)
{
  ASSERT_STREQ(a->GetClassName(), b->GetClassName());
  ExpectEqualArrays(a->GetFieldData(), b->GetFieldData());
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(a))
  {
    ExpectEqualBlocks(blocks, vtkMultiBlockDataSet::SafeDownCast(b));
  }
  else if (auto* table = vtkTable::SafeDownCast(a))
  {
    ExpectEqualArrays(table->GetRowData(), vtkTable::SafeDownCast(b)->GetRowData());
  }
  else if (auto* surface = vtkPolyData::SafeDownCast(a))
  {
    auto* other = vtkPolyData::SafeDownCast(b);
    ExpectEqualPoints(surface, other);
    ExpectEqualCells(surface->GetVerts(), other->GetVerts());
    ExpectEqualCells(surface->GetLines(), other->GetLines());
    ExpectEqualCells(surface->GetPolys(), other->GetPolys());
    ExpectEqualCells(surface->GetStrips(), other->GetStrips());
  }
  else
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(a);
    auto* other = vtkUnstructuredGrid::SafeDownCast(b);
    ASSERT_TRUE(grid);
    ExpectEqualPoints(grid, other);
    ExpectEqualCells(grid->GetCells(), other->GetCells());
    ExpectEqualArrays(grid->GetCellTypesArray(), other->GetCellTypesArray());
  }
}

std::multiset<std::array<std::array<double, 3>, 3>> GetTriangles(vtkPolyData* mesh)
{
  std::multiset<std::array<std::array<double, 3>, 3>> result;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCellPoints(i, corners);
    std::array<std::array<double, 3>, 3> triangle;
    for (int k = 0; k < 3; ++k)
    {
      mesh->GetPoint(corners->GetId(k), triangle[k].data());
    }
    std::rotate(
      triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    result.insert(triangle);
  }
  return result;
}

void SetGhosts(vtkPolyData* mesh, const std::function<int(vtkIdType)>& typeOf)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(typeOf(i)));
  }
  mesh->GetCellData()->AddArray(ghosts);
}

vtkSmartPointer<vtkPolyData> ReadReal(const std::string& name)
{
  return ToPolyData(ReadRealMesh(name));
}

vtkSmartPointer<vtkPolyData> TwoBoxes()
{
  return ToPolyData(
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 2, 0, 0 }, { 3, 1, 1 })));
}

void Carve(vtkCarverAlgorithm* carver, vtkDataObject* input)
{
  carver->SetInputDataObject(input);
  carver->Update();
}

void CarveTo(vtkCarverAlgorithm* carver, int type, double target)
{
  carver->SetLevelTargetType(type);
  carver->ClearLevelTargets();
  carver->AddLevelTarget(target);
  carver->Update();
}

std::string CarveWithError(vtkCarverAlgorithm* carver, vtkDataObject* input)
{
  Messages messages(carver);
  Carve(carver, input);
  EXPECT_EQ(CountLevels(carver), 0);
  return messages.TakeError();
}

int CountLevels(vtkCarverAlgorithm* carver)
{
  return static_cast<int>(carver->GetOutput()->GetNumberOfBlocks());
}

vtkPolyData* GetLevel(vtkCarverAlgorithm* carver, int level)
{
  return vtkPolyData::SafeDownCast(carver->GetOutput()->GetBlock(static_cast<unsigned int>(level)));
}

vtkPolyData* LastLevel(vtkCarverAlgorithm* carver)
{
  return GetLevel(carver, CountLevels(carver) - 1);
}

vtkUnstructuredGrid* GetStream(vtkCarverAlgorithm* carver)
{
  return vtkUnstructuredGrid::SafeDownCast(carver->GetOutputDataObject(1));
}

double GetFieldValue(vtkDataObject* data, const char* name)
{
  return data->GetFieldData()->GetArray(name)->GetTuple1(0);
}

std::string GetFieldText(vtkDataObject* data, const char* name)
{
  return vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name))->GetValue(0);
}

int GetLevelStep(vtkCarverAlgorithm* carver, int level)
{
  return static_cast<int>(GetFieldValue(GetLevel(carver, level), "Step"));
}

vtkTable* GetProfile(vtkCarverAlgorithm* carver)
{
  return vtkTable::SafeDownCast(carver->GetOutputDataObject(2));
}

double GetProfileValue(vtkCarverAlgorithm* carver, vtkIdType step, const char* name)
{
  return GetProfile(carver)->GetValueByName(step, name).ToDouble();
}

testing::AssertionResult Has(const std::string& text, const std::string& words)
{
  const bool has = text.find(words) != std::string::npos;
  return (has ? testing::AssertionSuccess() : testing::AssertionFailure())
    << "\"" << words << "\" in: " << text;
}

void ExpectSameLevelsFromStream(vtkCarverAlgorithm* carver)
{
  vtkNew<vtkExtractCarvedLOD> extract;
  vtkNew<vtkUnstructuredGrid> stream; // as from a file, without its filter
  stream->DeepCopy(GetStream(carver));
  extract->SetInputData(stream);
  extract->SetLevelTargetType(vtkExtractCarvedLOD::STEP);
  extract->SetManifoldOutput(carver->GetManifoldOutput());
  for (int i = 0; i < CountLevels(carver); ++i)
  {
    vtkPolyData* level = GetLevel(carver, i);
    if (GetFieldText(level, "Kind") == "carved")
    {
      extract->SetLevelTarget(GetLevelStep(carver, i));
      extract->Update();
      ExpectEqualData(extract->GetOutput(), level);
    }
  }
}

std::string GetNotes(vtkCarverAlgorithm* carver)
{
  auto* notes =
    vtkStringArray::SafeDownCast(carver->GetOutput()->GetFieldData()->GetAbstractArray("Notes"));
  std::string text;
  for (vtkIdType i = 0; notes && i < notes->GetNumberOfValues(); ++i)
  {
    Log(notes->GetValue(i));
    text += notes->GetValue(i) + "\n";
  }
  return text;
}

Messages::Messages(vtkAlgorithm* filter)
  : Filter(filter)
  , Tags{ filter->AddObserver(vtkCommand::ErrorEvent, this, &Messages::AddError),
    filter->AddObserver(vtkCommand::WarningEvent, this, &Messages::AddWarning),
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &Messages::Ignore) }
{
}

Messages::~Messages()
{
  // Opened early, since a test may leave no file to open later.
  std::for_each(this->All.begin(), this->All.end(), Log);
  this->Filter->RemoveObserver(this->Tags[0]);
  this->Filter->RemoveObserver(this->Tags[1]);
  this->Filter->GetExecutive()->RemoveObserver(this->Tags[2]);
}

std::string Messages::TakeError()
{
  EXPECT_EQ(this->Errors.size(), 1u);
  const std::string error = this->Errors.empty() ? "" : this->Errors[0];
  this->Errors.clear();
  return error;
}

void Messages::AddError(vtkObject*, unsigned long, void* text)
{
  this->Errors.emplace_back(static_cast<const char*>(text));
  this->All.push_back(this->Errors.back());
}

void Messages::AddWarning(vtkObject*, unsigned long, void* text)
{
  this->Warnings.emplace_back(static_cast<const char*>(text));
  this->All.push_back(this->Warnings.back());
}

OtherHelper::OtherHelper(const std::string& path)
{
  setenv(HelperVariable, path.c_str(), 1);
}

OtherHelper::~OtherHelper()
{
  unsetenv(HelperVariable);
  if (!this->ScriptPath.empty())
  {
    std::remove(this->ScriptPath.c_str());
  }
}

std::unique_ptr<OtherHelper> OtherHelper::Script(const std::string& commands)
{
  const std::string path = testing::TempDir() + "other-helper-" + std::to_string(getpid()) + ".sh";
  std::ofstream(path) << "#!/bin/sh\n" << commands << "\n";
  chmod(path.c_str(), 0700);
  auto helper = std::make_unique<OtherHelper>(path);
  helper->ScriptPath = path;
  return helper;
}

std::unique_ptr<OtherHelper> OtherHelper::Preceded(const std::string& commands)
{
  return Script(commands + "\nexec '" CARVING_HELPER "' \"$@\"");
}

std::vector<double> ErrorsOfOneRun(
  const carving::TriangleMesh& mesh, const std::vector<double>& numbers, bool nested)
{
  carving::Job job;
  job.Kind = carving::JobKind::Decimate;
  job.Mesh = mesh;
  job.Decimation.Targets = numbers;
  job.Decimation.Nested = nested;
  carving::Reply reply;
  std::string error;
  HelperProcess::Run(
    job, reply, [](const carving::WorkProgress&) { return true; }, error);
  EXPECT_EQ(error + reply.Error, "");
  std::vector<double> errors;
  for (const carving::DecimatedSurface& surface : reply.Decimation.Surfaces)
  {
    errors.push_back(surface.Error);
  }
  return errors;
}
