// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "Figures.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

using vtkSDDP = vtkStreamingDemandDrivenPipeline;

namespace
{

class LevelTimes : public testing::Test
{
protected:
  LevelTimes()
  {
    this->Carver->SetInputData(ToPolyData(models::TwoSpheres()));
    this->Extract->SetInputConnection(this->Carver->GetOutputPort(1));
  }

  int StepAt(double time)
  {
    this->Extract->UpdateTimeStep(time);
    return static_cast<int>(GetFieldValue(this->Extract->GetOutput(), "Step"));
  }

  std::vector<double> GetTimes()
  {
    this->Extract->UpdateInformation();
    vtkInformation* info = this->Extract->GetOutputInformation(0);
    const double* times = info->Get(vtkSDDP::TIME_STEPS());
    return times ? std::vector<double>(times, times + info->Length(vtkSDDP::TIME_STEPS()))
                 : std::vector<double>();
  }

  vtkNew<vtkTopologyCarver> Carver;
  vtkNew<vtkExtractCarvedLOD> Extract;
};

} // namespace

// A time that is not a number shows the first level.
TEST_F(LevelTimes, NeedNotBeNumbers)
{
  EXPECT_EQ(this->StepAt(std::numeric_limits<double>::quiet_NaN()), 0);
}

// Times are offered before the first carving, in the requested number.
TEST_F(LevelTimes, AreOfferedFromTheStart)
{
  this->Extract->SetNumberOfTimeSteps(4);
  EXPECT_EQ(this->GetTimes(), (std::vector<double>{ 0, 1, 2, 3 }));
  this->Extract->FollowTimeOff();
  EXPECT_TRUE(this->GetTimes().empty());
}

// The times stand for the levels that the carver spreads, from C0 to M.
TEST_F(LevelTimes, GoThroughTheLevelsOfTheCarver)
{
  constexpr int count = 7;
  this->Carver->SetNumberOfLevels(count);
  this->Extract->SetNumberOfTimeSteps(count);
  this->Carver->Update();
  for (int time = 0; time < count; ++time)
  {
    EXPECT_EQ(this->StepAt(time), GetLevelStep(this->Carver, time));
  }
  EXPECT_EQ(this->StepAt(-5.0), 0);
  EXPECT_EQ(this->StepAt(100.0), GetLevelStep(this->Carver, count - 1));
}

// If there are fewer levels than times, levels show more than once, in order.
TEST_F(LevelTimes, MayOutnumberTheLevels)
{
  this->Carver->SetInputData(TwoBoxes());
  int last = 0;
  for (const double time : this->GetTimes())
  {
    const int step = this->StepAt(time);
    EXPECT_GE(step, last);
    last = step;
  }
  this->Carver->SetNumberOfLevels(1);
  this->Carver->Update();
  EXPECT_EQ(last, GetLevelStep(this->Carver, 0));
}

// Without a requested time, the target picks the level.
TEST_F(LevelTimes, LeaveTheTargetAloneIfNobodyAsksForATime)
{
  this->Extract->SetLevelTargetType(vtkExtractCarvedLOD::STEP);
  this->Extract->SetLevelTarget(3);
  this->Extract->Update();
  EXPECT_EQ(GetFieldValue(this->Extract->GetOutput(), "Step"), 3);
}

// An input with time steps of its own keeps them.
TEST_F(LevelTimes, GiveWayToThoseOfTheInput)
{
  vtkNew<vtkTrivialProducer> moving;
  moving->SetOutput(ToPolyData(models::TwoSpheres()));
  const double times[] = { 0.5, 0.75 };
  moving->UpdateInformation();
  moving->GetOutputInformation(0)->Set(vtkSDDP::TIME_STEPS(), times, 2);
  this->Carver->SetInputConnection(moving->GetOutputPort());
  this->Extract->SetLevelTargetType(vtkExtractCarvedLOD::STEP);
  this->Extract->SetLevelTarget(3);
  EXPECT_EQ(this->GetTimes(), (std::vector<double>{ 0.5, 0.75 }));
  EXPECT_EQ(this->StepAt(0.75), 3);
}

// All objects of a composite follow the same time, and the tree stays.
TEST_F(LevelTimes, MoveAllObjectsOfAComposite)
{
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, ToPolyData(models::TwoSpheres()));
  scene->SetBlock(2, TwoBoxes());
  this->Carver->SetInputData(scene);
  const double last = this->GetTimes().back();
  this->Extract->UpdateTimeStep(last);
  auto* levels = vtkMultiBlockDataSet::SafeDownCast(this->Extract->GetOutputDataObject(0));
  ASSERT_TRUE(levels);
  ASSERT_EQ(levels->GetNumberOfBlocks(), 3u);
  EXPECT_EQ(levels->GetBlock(1), nullptr);
  for (const int block : { 0, 2 })
  {
    auto* level = vtkPolyData::SafeDownCast(levels->GetBlock(block));
    ASSERT_TRUE(level);
    EXPECT_EQ(GetTriangles(level), GetTriangles(vtkPolyData::SafeDownCast(scene->GetBlock(block))));
  }
}

// There is no range of a type that does not exist.
TEST_F(LevelTimes, HaveNoRangeOfOtherTypes)
{
  this->Carver->Update();
  for (const int type : { vtkExtractCarvedLOD::VERTICES - 1, vtkExtractCarvedLOD::STEP + 1 })
  {
    double range[2];
    EXPECT_FALSE(this->Extract->GetLevelTargetRange(type, range));
  }
}

// The range of targets is known once there is a stream, and covers all streams.
TEST_F(LevelTimes, ComeWithTheRangeOfTheTargets)
{
  const auto vertices = static_cast<double>(models::TwoSpheres().Points.size());
  double range[2];
  EXPECT_FALSE(this->Extract->GetLevelTargetRange(vtkExtractCarvedLOD::VERTICES, range));
  this->Carver->Update();
  EXPECT_TRUE(this->Extract->GetLevelTargetRange(vtkExtractCarvedLOD::VERTICES, range));
  EXPECT_EQ(range[0], GetLevel(this->Carver, 0)->GetNumberOfPoints());
  EXPECT_EQ(range[1], vertices);
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, ToPolyData(models::TwoSpheres()));
  scene->SetBlock(1, TwoBoxes());
  this->Carver->SetInputData(scene);
  this->Carver->Update();
  EXPECT_TRUE(this->Extract->GetLevelTargetRange(vtkExtractCarvedLOD::VERTICES, range));
  EXPECT_EQ(range[0], 16); // all points of two boxes lie on their hull
  EXPECT_EQ(range[1], vertices);
}
