// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Functions and classes that the tests of the filters share.
 */
#ifndef FilterTesting_h
#define FilterTesting_h

#include "PolyData.h"
#include "Shapes.h"

#include "vtkCommand.h"
#include "vtkTopologyCarver.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

class vtkTable;
class vtkUnstructuredGrid;

/** A mesh that the test FetchMeshes has fetched. */
vtkSmartPointer<vtkPolyData> ReadReal(const std::string& name);
/** Two boxes with a gap between them: the simplest mesh with tetrahedra to carve. */
vtkSmartPointer<vtkPolyData> TwoBoxes();

/** Carves by the properties of the carver. */
void Carve(vtkCarverAlgorithm* carver, vtkDataObject* input);

/** Carves into the level for one target. */
void CarveTo(vtkCarverAlgorithm* carver, int type, double target);
/** Carves, and expects a single error and no level. Returns the error. */
std::string CarveWithError(vtkCarverAlgorithm* carver, vtkDataObject* input);

int CountLevels(vtkCarverAlgorithm* carver);
vtkPolyData* GetLevel(vtkCarverAlgorithm* carver, int level);
vtkPolyData* LastLevel(vtkCarverAlgorithm* carver);
vtkUnstructuredGrid* GetStream(vtkCarverAlgorithm* carver);
/** The first value of an array of the field data. */
double GetFieldValue(vtkDataObject* data, const char* name);
std::string GetFieldText(vtkDataObject* data, const char* name);
int GetLevelStep(vtkCarverAlgorithm* carver, int level);
vtkTable* GetProfile(vtkCarverAlgorithm* carver);
double GetProfileValue(vtkCarverAlgorithm* carver, vtkIdType step, const char* name);
/** The notes in the field data of port 0, one per line. */
std::string GetNotes(vtkCarverAlgorithm* carver);
/** Whether a text contains these words. */
testing::AssertionResult Has(const std::string& text, const std::string& words);

/**
 * Expects the same tree, names, points, cells and arrays, bit for bit, in any order of the arrays.
 */
void ExpectEqualData(vtkDataObject* a, vtkDataObject* b);
/** Expects that the extractor gives the same carved levels from the stream as the carver. */
void ExpectSameLevelsFromStream(vtkCarverAlgorithm* carver);

/**
 * Collects the errors and warnings of a filter instead of printing them. Errors, warnings and notes
 * are also written to a file of the first test that runs, in the folder that
 * TOPOLOGYCARVING_MESSAGE_LOGS names, for the test that compares them with the README.
 */
class Messages
{
public:
  explicit Messages(vtkAlgorithm* filter);
  ~Messages();
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  /** Expects a single error since the last call, and forgets it. */
  std::string TakeError();

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

private:
  void AddError(vtkObject*, unsigned long, void* text);
  void AddWarning(vtkObject*, unsigned long, void* text);
  /** The executive only repeats the errors of the filter. */
  void Ignore()
  {
  }

  vtkAlgorithm* Filter;
  unsigned long Tags[3];
  std::vector<std::string> All; ///< including those that a test has cleared
};

/** Carves into a number of levels, and expects no error. */
template <class Carver = vtkTopologyCarver>
vtkSmartPointer<Carver> Carve(vtkDataObject* input, int levels = 8)
{
  auto carver = vtkSmartPointer<Carver>::New();
  Messages messages(carver);
  carver->SetNumberOfLevels(levels);
  Carve(carver, input);
  EXPECT_TRUE(messages.Errors.empty()) << messages.Errors.front();
  return carver;
}

/** Sets the ghost type of every cell. */
void SetGhosts(vtkPolyData* mesh, const std::function<int(vtkIdType)>& typeOf);

/** The triangles of a mesh by coordinates, rotated so that the smallest corner comes first. */
std::multiset<std::array<std::array<double, 3>, 3>> GetTriangles(vtkPolyData* mesh);

/** During its lifetime, aborts a filter once it has reported a stage a number of times. */
class Aborter
{
public:
  Aborter(vtkAlgorithm* filter, const std::string& stage = "", int reports = 1)
    : Filter(filter)
    , Stage(stage)
    , Reports(reports)
    , Tag(filter->AddObserver(vtkCommand::ProgressEvent, this, &Aborter::Abort))
  {
  }
  ~Aborter()
  {
    this->Filter->RemoveObserver(this->Tag);
  }

  /** Negative if the filter went on after the abort. */
  int GetReportsLeft() const
  {
    return this->Reports;
  }

private:
  void Abort()
  {
    if (this->Filter->GetProgress() == 1.0)
    {
      return; // from the pipeline, which reports the end of an aborted update, too, since VTK 9.3
    }
    const char* stage = this->Filter->GetProgressText();
    if ((this->Stage.empty() || (stage && std::string(stage).find(this->Stage) == 0)) &&
      --this->Reports <= 0)
    {
      this->Filter->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Filter;
  std::string Stage;
  int Reports;
  unsigned long Tag;
};

/** During its lifetime, the filters run another program instead of the helper program. */
class OtherHelper
{
public:
  explicit OtherHelper(const std::string& path);
  ~OtherHelper();

  /** Makes a shell script the helper program; the file is removed with this object. */
  static std::unique_ptr<OtherHelper> Script(const std::string& commands);

  /** Makes a shell script the helper program that runs the true one after other commands. */
  static std::unique_ptr<OtherHelper> Preceded(const std::string& commands);

  OtherHelper(const OtherHelper&) = delete;
  void operator=(const OtherHelper&) = delete;

private:
  std::string ScriptPath;
};

/** The errors of a mesh that is decimated to numbers of vertices once, without bounds. */
std::vector<double> ErrorsOfOneRun(
  const carving::TriangleMesh& mesh, const std::vector<double>& numbers, bool nested = false);

#endif
