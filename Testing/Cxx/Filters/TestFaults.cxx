// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"
#include "Leftovers.h"
#include "RandomModels.h"

#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>

namespace
{

/** Expects that a carver gives several levels without an error. */
void ExpectLevels(vtkTopologyCarver* carver)
{
  Messages messages(carver);
  carver->Modified();
  carver->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_GT(CountLevels(carver), 1);
}

/** Expects an error with `words` from another helper program, and then levels from the real one. */
void ExpectErrorAndRecovery(const std::string& words, std::unique_ptr<OtherHelper> helper)
{
  const Leftovers leftovers;
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInputData(TwoBoxes());
  carver->Update();
  helper.reset();
  leftovers.ExpectNone();
  EXPECT_TRUE(Has(messages.TakeError(), words));
  EXPECT_EQ(CountLevels(carver), 0);
  ExpectLevels(carver);
}

/** The error for an input. */
std::string ErrorFor(vtkPolyData* input)
{
  vtkNew<vtkTopologyCarver> carver;
  return CarveWithError(carver, input);
}

vtkSmartPointer<vtkPolyData> LargeSpheres()
{
  return ToPolyData(
    models::Joined(models::Sphere(6), models::Moved(models::Sphere(6), { 3, 0, 0 })));
}

} // namespace

// A missing helper program is an error that names the environment variable and the path.
TEST(Faults, ReportsAMissingHelper)
{
  ExpectErrorAndRecovery(
    "/there/is/no/such/helper", std::make_unique<OtherHelper>("/there/is/no/such/helper"));
  ExpectErrorAndRecovery(
    "TOPOLOGYCARVING_HELPER", std::make_unique<OtherHelper>("/there/is/no/such/helper"));
}

// A helper that is no program, or one for another machine, is an error.
TEST(Faults, ReportsAHelperThatIsNoProgram)
{
  ExpectErrorAndRecovery("not an executable file", std::make_unique<OtherHelper>(__FILE__));
  ExpectErrorAndRecovery("not an executable file", std::make_unique<OtherHelper>("/"));
  auto foreign = OtherHelper::Script("");
  std::ofstream(std::getenv("TOPOLOGYCARVING_HELPER")) << "\x7f"
                                                          "ELF of nothing";
  ExpectErrorAndRecovery("carving-helper", std::move(foreign));
  auto uninterpreted = OtherHelper::Script("");
  std::ofstream(std::getenv("TOPOLOGYCARVING_HELPER")) << "#!/there/is/no/such/interpreter\n";
  ExpectErrorAndRecovery("carving-helper could not be run", std::move(uninterpreted));
}

// A helper program that is killed is an error that says so.
TEST(Faults, ReportsAKilledHelper)
{
  ExpectErrorAndRecovery("died", OtherHelper::Script("kill -KILL $$"));
}

// A helper program that crashes is an error with its last output and the stage of its work.
TEST(Faults, RepeatsTheLastWordsOfACrashedHelper)
{
  ExpectErrorAndRecovery("Assertion failed: it hurts",
    OtherHelper::Script("echo 'Assertion failed: it hurts' >&2; kill -ABRT $$"));
  ExpectErrorAndRecovery(
    "resolve", OtherHelper::Script("echo '@progress 1 5000' >&2; kill -SEGV $$"));
}

// A helper program that exits with another code than 0 is an error with the code.
TEST(Faults, ReportsAnExitCode)
{
  ExpectErrorAndRecovery("exit code 7", OtherHelper::Script("exit 7"));
}

// An invalid or empty reply is an error that says that the answer cannot be used.
TEST(Faults, ReportsGarbage)
{
  ExpectErrorAndRecovery("cannot be used", OtherHelper::Script("echo garbage"));
  ExpectErrorAndRecovery("cannot be used", OtherHelper::Script("exit 0"));
}

// An abort kills a hanging helper program and its child processes, without an error.
TEST(Faults, KillsAHangingHelperOnAbort)
{
  for (const char* hang : { "exec sleep 1000", "sleep 1000 & wait", "(sleep 1000 & wait) & wait" })
  {
    const auto hanging = OtherHelper::Script(std::string("echo '@progress 3 0' >&2; ") + hang);
    const Leftovers leftovers;
    vtkNew<vtkTopologyCarver> carver;
    Messages messages(carver);
    const Aborter aborter(carver, "tetrahedralize", 3);
    carver->SetInputData(TwoBoxes());
    const auto start = std::chrono::steady_clock::now();
    carver->Update();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1000));
    EXPECT_TRUE(messages.Errors.empty());
    EXPECT_EQ(CountLevels(carver), 0);
    leftovers.ExpectNone();
  }
}

// An abort at any stage gives empty output, and the next update works.
TEST(Faults, CanBeAbortedAtEveryStage)
{
  auto input = ReadReal("bones.off");
  for (const char* stage : { "clean", "resolve", "tetrahedralize", "classify", "carve", "output" })
  {
    const Leftovers leftovers;
    vtkNew<vtkTopologyCarver> carver;
    Messages messages(carver);
    carver->SetInputData(input);
    {
      const Aborter aborter(carver, stage);
      carver->Update();
    }
    leftovers.ExpectNone();
    EXPECT_EQ(CountLevels(carver), 0) << stage;
    carver->Modified();
    carver->Update();
    EXPECT_EQ(CountLevels(carver), 8) << stage;
    EXPECT_TRUE(messages.Errors.empty()) << stage;
  }
}

// An abort also ends the child process that makes an attempt.
TEST(Faults, CanBeAbortedWithinAnAttempt)
{
  const auto input = LargeSpheres();
  for (const int conformity : { vtkTopologyCarver::EXACT, vtkTopologyCarver::ENCLOSING })
  {
    const Leftovers leftovers;
    vtkNew<vtkTopologyCarver> carver;
    Messages messages(carver);
    const Aborter aborter(carver, "tetrahedralize", 4);
    carver->SetConformity(conformity);
    Carve(carver, input);
    EXPECT_TRUE(carver->GetAbortExecute());
    EXPECT_TRUE(messages.Errors.empty());
    leftovers.ExpectNone();
  }
}

// If a limit ended an attempt, a note says that the result depends on it.
TEST(Faults, NotesThatTheResultDependsOnALimit)
{
  // TetGen needs points on the triangles of the soup, which take more processor time than there is
  // for an attempt. The sphere lowers the number of crossings per triangle, so that TetGen is
  // tried.
  std::mt19937_64 random(1);
  const auto mesh =
    models::Joined(models::Soup(328, random), models::Moved(models::Sphere(5), { 10, 0, 0 }));
  vtkNew<vtkTopologyCarver> carver;
  carver->SetEnclosingTolerance(0.0);
  Carve(carver, ToPolyData(mesh));
  EXPECT_TRUE(Has(GetNotes(carver), "The result depends on a limit: "));
}

#ifndef TOPOLOGYCARVING_PORTABLE // memory is limited on Linux alone
// A limit on memory that is too low is an error that names the limit, in every mode; without the
// limit the filter works.
TEST(Faults, ReportsThatTheMemoryLimitIsReached)
{
  const auto input = LargeSpheres();
  for (const int conformity :
    { vtkTopologyCarver::EXACT, vtkTopologyCarver::ENCLOSING, vtkTopologyCarver::AUTO })
  {
    const Leftovers leftovers;
    vtkNew<vtkTopologyCarver> carver;
    carver->SetConformity(conformity);
    // Memory for a part of the work, more in each round.
    for (const int mebibytes : { 20, 40, 60 })
    {
      carver->SetMemoryLimit(mebibytes);
      const std::string error = CarveWithError(carver, input);
      EXPECT_TRUE(Has(error, "ran out of memory"));
      EXPECT_TRUE(Has(error, "MemoryLimit"));
    }
    leftovers.ExpectNone();
    carver->SetMemoryLimit(0);
    carver->SetInputData(TwoBoxes());
    ExpectLevels(carver);
  }
}
#endif

// A limit on time that is too low is an error that names the limit, in every mode; without the
// limit the filter works.
TEST(Faults, ReportsThatTheTimeLimitIsReached)
{
  const auto input = LargeSpheres();
  for (const int conformity :
    { vtkTopologyCarver::EXACT, vtkTopologyCarver::ENCLOSING, vtkTopologyCarver::AUTO })
  {
    const Leftovers leftovers;
    vtkNew<vtkTopologyCarver> carver;
    carver->SetConformity(conformity);
    carver->SetTimeLimit(0.01);
    const std::string error = CarveWithError(carver, input);
    EXPECT_TRUE(Has(error, "took longer than 0.01 s"));
    EXPECT_TRUE(Has(error, "TimeLimit"));
    leftovers.ExpectNone();
    carver->SetTimeLimit(0);
    carver->SetInputData(TwoBoxes());
    ExpectLevels(carver);
  }
}

// Limits beyond the range of the system are no limits.
TEST(Faults, TakesAnyLimit)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(TwoBoxes());
  carver->SetTimeLimit(std::numeric_limits<double>::max());
  carver->SetMemoryLimit(std::numeric_limits<double>::max());
  ExpectLevels(carver);
}

// A job or a reply that cannot be written is an error that says so.
TEST(Faults, ReportsThatThereIsNoRoom)
{
  for (const int conformity :
    { vtkTopologyCarver::EXACT, vtkTopologyCarver::ENCLOSING, vtkTopologyCarver::AUTO })
  {
    const char* noRoom = "to hand the mesh to the helper program";
    const std::pair<rlim_t, const char*> cases[] = { { 100, noRoom },
      { 2000, "could not be written" }, { 0, noRoom } };
    for (const auto& [bytes, words] : cases)
    {
      const Leftovers leftovers;
      vtkNew<vtkTopologyCarver> carver;
      Messages messages(carver);
      carver->SetConformity(conformity);
      carver->SetInputData(TwoBoxes());
      {
        const ResourceLimit fileSize(RLIMIT_FSIZE, bytes); // as on a full disk
        carver->Update();
      }
      EXPECT_TRUE(Has(messages.TakeError(), words));
      leftovers.ExpectNone();
      ExpectLevels(carver);
    }
  }
}

// If no file can be opened, that is an error that says so, and the process goes on.
TEST(Faults, ReportsThatNoFileCanBeOpened)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInputData(TwoBoxes());
  const int next = dup(0);
  close(next);
  {
    const ResourceLimit files(RLIMIT_NOFILE, static_cast<rlim_t>(next));
    carver->Update();
  }
  EXPECT_TRUE(Has(messages.TakeError(), "No file could be opened"));
  ExpectLevels(carver);
}

// In EXACT mode, a mesh that TetGen refuses is an error with advice; in AUTO mode, the same filter
// encloses the mesh.
TEST(Faults, ReportsThatTetGenGaveUp)
{
  std::mt19937_64 random(1);
  vtkNew<vtkTopologyCarver> carver;
  carver->SetConformity(vtkTopologyCarver::EXACT);
  carver->SetTimeLimit(0.5); // points on the triangles would take many times as long
  const std::string error = CarveWithError(carver, ToPolyData(models::Soup(200, random)));
  EXPECT_TRUE(Has(error, "TetGen"));
  EXPECT_TRUE(Has(error, "Conformity"));
  carver->SetTimeLimit(0.0);
  carver->SetConformity(vtkTopologyCarver::AUTO);
  ExpectLevels(carver);
  EXPECT_EQ(CountLevels(carver), 8);
}

// A coordinate that is not finite is an error that names the first such point.
TEST(Faults, NamesThePointThatIsNotFinite)
{
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    auto input = TwoBoxes();
    input->GetPoints()->SetPoint(5, 0, bad, 0);
    EXPECT_TRUE(Has(ErrorFor(input), "Point 5"));
  }
}

// A point that is not finite is ignored if no polygon uses it.
TEST(Faults, IgnoresUnusedPoints)
{
  auto input = TwoBoxes();
  input->GetPoints()->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  Carve(input);
}

// A flat mesh is an error that says that there is no volume.
TEST(Faults, ReportsAFlatMesh)
{
  EXPECT_TRUE(Has(ErrorFor(ToPolyData(models::Sheet(3))), "plane"));
}

// A mesh of degenerate triangles is an error that says that there is no area.
TEST(Faults, ReportsAMeshWithoutArea)
{
  EXPECT_TRUE(Has(
    ErrorFor(ToPolyData({ { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } }, { { 0, 1, 2 } } })), "area"));
}
