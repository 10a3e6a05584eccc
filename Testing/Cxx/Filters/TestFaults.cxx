// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"
#include "Leftovers.h"
#include "RandomModels.h"

#include "vtkCommand.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace
{

/** Updates with another helper: an error that has `words`, and then, with the real one, levels. */
void ExpectErrorAndRecovery(const std::string& words, OtherHelper&& helper)
{
  const Leftovers leftovers;
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInputData(TwoBoxes());
  {
    const OtherHelper current(std::move(helper));
    carver->Update();
  }
  leftovers.ExpectNone();
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_NE(messages.Errors[0].find(words), std::string::npos) << messages.Errors[0];
  EXPECT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 0u);
  messages.Errors.clear();
  carver->Modified();
  carver->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_GT(carver->GetOutput()->GetNumberOfBlocks(), 1u);
}

/** The error that an input gives. */
std::string ErrorFor(vtkPolyData* input)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInputData(input);
  carver->Update();
  EXPECT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 0u);
  EXPECT_EQ(messages.Errors.size(), 1u);
  return messages.Errors.empty() ? "" : messages.Errors[0];
}

/** While it lives, aborts a filter as soon as it has reported a stage so many times. */
class Aborter
{
public:
  Aborter(vtkTopologyCarver* carver, const std::string& stage, int reports = 1)
    : Carver(carver)
    , Stage(stage)
    , Reports(reports)
    , Tag(carver->AddObserver(vtkCommand::ProgressEvent, this, &Aborter::Abort))
  {
  }
  ~Aborter()
  {
    this->Carver->RemoveObserver(this->Tag);
  }

private:
  void Abort()
  {
    const char* stage = this->Carver->GetProgressText();
    if (stage && this->Stage == stage && --this->Reports <= 0)
    {
      this->Carver->SetAbortExecute(1);
    }
  }

  vtkTopologyCarver* Carver;
  std::string Stage;
  int Reports;
  unsigned long Tag;
};

vtkSmartPointer<vtkPolyData> LargeSpheres()
{
  return ToPolyData(
    models::Joined(models::Sphere(6), models::Moved(models::Sphere(6), { 3, 0, 0 })));
}

} // namespace

// A missing helper is an error that names the variable and the path.
TEST(Faults, ReportsAMissingHelper)
{
  ExpectErrorAndRecovery("/there/is/no/such/helper", OtherHelper("/there/is/no/such/helper"));
  ExpectErrorAndRecovery("TOPOLOGYCARVING_HELPER", OtherHelper("/there/is/no/such/helper"));
}

// A file that is not a program, or is one of another machine's, is an error as well.
TEST(Faults, ReportsAHelperThatIsNoProgram)
{
  ExpectErrorAndRecovery("not an executable file", OtherHelper(__FILE__));
  ExpectErrorAndRecovery("not an executable file", OtherHelper("/"));
  OtherHelper foreign = OtherHelper::Script("");
  std::ofstream(std::getenv("TOPOLOGYCARVING_HELPER")) << "\x7f"
                                                          "ELF of nothing";
  ExpectErrorAndRecovery("carving-helper", std::move(foreign));
  OtherHelper uninterpreted = OtherHelper::Script("");
  std::ofstream(std::getenv("TOPOLOGYCARVING_HELPER")) << "#!/there/is/no/such/interpreter\n";
  ExpectErrorAndRecovery("carving-helper could not be run", std::move(uninterpreted));
}

// A helper that is killed in mid-run is an error that says so.
TEST(Faults, ReportsAKilledHelper)
{
  ExpectErrorAndRecovery("died", OtherHelper::Script("kill -KILL $$"));
}

// A helper that crashes is an error that repeats its last words and where it was.
TEST(Faults, RepeatsTheLastWordsOfACrashedHelper)
{
  ExpectErrorAndRecovery("Assertion failed: it hurts",
    OtherHelper::Script("echo 'Assertion failed: it hurts' >&2; kill -ABRT $$"));
  ExpectErrorAndRecovery(
    "resolve", OtherHelper::Script("echo '@progress 1 0.5' >&2; kill -SEGV $$"));
}

// A helper that exits with a code of its own is an error that gives the code.
TEST(Faults, ReportsAnExitCode)
{
  ExpectErrorAndRecovery("exit code 7", OtherHelper::Script("exit 7"));
}

// A helper that answers garbage, or nothing, is an error that says that its answer cannot be used.
TEST(Faults, ReportsGarbage)
{
  ExpectErrorAndRecovery("cannot be used", OtherHelper::Script("echo garbage"));
  ExpectErrorAndRecovery("cannot be used", OtherHelper::Script("exit 0"));
}

// A helper that hangs is killed as soon as the user aborts, with what it has started; that is no error.
TEST(Faults, KillsAHangingHelperOnAbort)
{
  for (const char* hang : { "exec sleep 1000", "sleep 1000 & wait", "(sleep 1000 & wait) & wait" })
  {
    const OtherHelper hanging =
      OtherHelper::Script(std::string("echo '@progress 2 0' >&2; ") + hang);
    const Leftovers leftovers;
    vtkNew<vtkTopologyCarver> carver;
    Messages messages(carver);
    const Aborter aborter(carver, "tetrahedralize", 3);
    carver->SetInputData(TwoBoxes());
    const auto start = std::chrono::steady_clock::now();
    carver->Update();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1000));
    EXPECT_TRUE(messages.Errors.empty());
    EXPECT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 0u);
    leftovers.ExpectNone();
  }
}

// An abort at any stage gives empty output, and the filter works again at once.
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
    EXPECT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 0u) << stage;
    carver->Modified();
    carver->Update();
    EXPECT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 8u) << stage;
    EXPECT_TRUE(messages.Errors.empty()) << stage;
  }
}

// An abort in the middle of an attempt, which is a process of the helper's, ends that too.
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
    carver->SetInputData(input);
    carver->Update();
    EXPECT_TRUE(carver->GetAbortExecute());
    EXPECT_TRUE(messages.Errors.empty());
    leftovers.ExpectNone();
  }
}

// A limit on memory or time that is too low is an error that says so and names the limit, whatever has to
// be met; without it the same filter works.
TEST(Faults, ReportsALimitThatIsReached)
{
  const auto input = LargeSpheres();
  for (const int conformity :
    { vtkTopologyCarver::EXACT, vtkTopologyCarver::ENCLOSING, vtkTopologyCarver::AUTO })
  {
    const Leftovers leftovers;
    vtkNew<vtkTopologyCarver> carver;
    Messages messages(carver);
    carver->SetInputData(input);
    carver->SetConformity(conformity);
    // Room for a part of the work, more of it from round to round.
    for (const int mebibytes : { 20, 40, 60 })
    {
      carver->SetMemoryLimit(mebibytes);
      carver->Update();
      ASSERT_EQ(messages.Errors.size(), 1u) << mebibytes;
      EXPECT_NE(messages.Errors[0].find("ran out of memory"), std::string::npos)
        << messages.Errors[0];
      EXPECT_NE(messages.Errors[0].find("MemoryLimit"), std::string::npos) << messages.Errors[0];
      messages.Errors.clear();
    }
    carver->SetMemoryLimit(0);
    carver->SetTimeLimit(0.01);
    carver->Update();
    ASSERT_EQ(messages.Errors.size(), 1u);
    EXPECT_NE(messages.Errors[0].find("took longer than 0.01 s"), std::string::npos)
      << messages.Errors[0];
    EXPECT_NE(messages.Errors[0].find("TimeLimit"), std::string::npos) << messages.Errors[0];
    messages.Errors.clear();
    leftovers.ExpectNone();
    carver->SetTimeLimit(0);
    carver->SetInputData(TwoBoxes());
    carver->Update();
    EXPECT_TRUE(messages.Errors.empty());
    EXPECT_GT(carver->GetOutput()->GetNumberOfBlocks(), 1u);
  }
}

// Limits beyond what the system can count are none.
TEST(Faults, TakesAnyLimit)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInputData(TwoBoxes());
  carver->SetTimeLimit(std::numeric_limits<double>::max());
  carver->SetMemoryLimit(std::numeric_limits<double>::max());
  carver->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_GT(carver->GetOutput()->GetNumberOfBlocks(), 1u);
}

// Where a job, or a reply, cannot be written, that is an error that says so.
TEST(Faults, ReportsThatThereIsNoRoom)
{
  for (const int conformity :
    { vtkTopologyCarver::EXACT, vtkTopologyCarver::ENCLOSING, vtkTopologyCarver::AUTO })
  {
    const std::pair<rlim_t, const char*> cases[] = { { 100, "not enough memory to hand the mesh" },
      { 2000, "could not be written" }, { 0, "not enough memory to hand the mesh" } };
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
      ASSERT_EQ(messages.Errors.size(), 1u);
      EXPECT_NE(messages.Errors[0].find(words), std::string::npos) << messages.Errors[0];
      messages.Errors.clear();
      leftovers.ExpectNone();
      carver->Modified();
      carver->Update();
      EXPECT_TRUE(messages.Errors.empty());
      EXPECT_GT(carver->GetOutput()->GetNumberOfBlocks(), 1u);
    }
  }
}

// Where no file can be opened, that is an error that says so, and no end of the process.
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
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_NE(messages.Errors[0].find("No file in memory could be opened"), std::string::npos);
  carver->Modified();
  carver->Update();
  EXPECT_EQ(messages.Errors.size(), 1u);
  EXPECT_GT(carver->GetOutput()->GetNumberOfBlocks(), 1u);
}

// A mesh that TetGen refuses is an error if it has to be exact, which says who gave up and what to do; the
// host lives on, and the same filter encloses the mesh if it need not be.
TEST(Faults, ReportsThatTetGenGaveUp)
{
  std::mt19937_64 random(1);
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInputData(ToPolyData(models::Soup(200, random)));
  carver->SetConformity(vtkTopologyCarver::EXACT);
  carver->SetTimeLimit(0.5); // it would take many times that, with points on the triangles
  carver->Update();
  EXPECT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 0u);
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_NE(messages.Errors[0].find("TetGen"), std::string::npos) << messages.Errors[0];
  EXPECT_NE(messages.Errors[0].find("Conformity"), std::string::npos) << messages.Errors[0];
  carver->SetTimeLimit(0.0);
  carver->SetConformity(vtkTopologyCarver::AUTO);
  carver->Update();
  EXPECT_EQ(carver->GetOutput()->GetNumberOfBlocks(), 8u);
  EXPECT_EQ(messages.Errors.size(), 1u);
}

// A coordinate that is not finite is an error that names the first such point.
TEST(Faults, NamesThePointThatIsNotFinite)
{
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    auto input = TwoBoxes();
    input->GetPoints()->SetPoint(5, 0, bad, 0);
    EXPECT_NE(ErrorFor(input).find("Point 5"), std::string::npos);
  }
}

// A point that is not finite does not matter where no polygon uses it.
TEST(Faults, IgnoresUnusedPoints)
{
  auto input = TwoBoxes();
  input->GetPoints()->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInputData(input);
  carver->Update();
  EXPECT_TRUE(messages.Errors.empty());
}

// A flat mesh is an error that says that there is no volume.
TEST(Faults, ReportsAFlatMesh)
{
  EXPECT_NE(ErrorFor(ToPolyData(models::Sheet(3))).find("plane"), std::string::npos);
}

// A mesh of degenerate triangles is an error that says that there is no area.
TEST(Faults, ReportsAMeshWithoutArea)
{
  EXPECT_NE(ErrorFor(ToPolyData({ { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } }, { { 0, 1, 2 } } }))
              .find("area"),
    std::string::npos);
}
