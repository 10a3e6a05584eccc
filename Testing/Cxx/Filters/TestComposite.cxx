// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"
#include "Leftovers.h"

#include "vtkExtractCarvedLOD.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOverlappingAMR.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkUnstructuredGrid.h"
#include "vtksys/SystemTools.hxx"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace
{

vtkMultiBlockDataSet* GetTree(vtkTopologyCarver* carver, int port)
{
  return vtkMultiBlockDataSet::SafeDownCast(carver->GetOutputDataObject(port));
}

/** Tori of different sizes, side by side. */
vtkSmartPointer<vtkMultiBlockDataSet> Tori(int number)
{
  auto scene = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (int i = 0; i < number; ++i)
  {
    scene->SetBlock(
      i, ToPolyData(models::Moved(models::Torus(1.0, 0.3, 8 + 4 * (i % 3), 6), { 3.0 * i, 0, 0 })));
  }
  return scene;
}

} // namespace

// Each leaf of a multiblock is carved by itself; all ports keep the tree, the names and null
// leaves.
TEST(Composite, CarvesEachLeafOfATree)
{
  vtkNew<vtkMultiBlockDataSet> scene, group;
  scene->SetBlock(0, ToPolyData(models::Sphere(1)));
  scene->SetBlock(1, nullptr);
  scene->SetBlock(2, group);
  group->SetBlock(0, TwoBoxes());
  scene->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "ball");
  scene->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "group");
  group->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "boxes");
  const auto carver = Carve(scene, 2);
  for (int port = 0; port < 3; ++port)
  {
    vtkMultiBlockDataSet* tree = GetTree(carver, port);
    ASSERT_NE(tree, nullptr);
    ASSERT_EQ(tree->GetNumberOfBlocks(), 3u);
    EXPECT_EQ(tree->GetBlock(1), nullptr);
    EXPECT_STREQ(tree->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME()), "ball");
    EXPECT_STREQ(tree->GetMetaData(2u)->Get(vtkCompositeDataSet::NAME()), "group");
    auto* inner = vtkMultiBlockDataSet::SafeDownCast(tree->GetBlock(2));
    ASSERT_NE(inner, nullptr);
    EXPECT_STREQ(inner->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME()), "boxes");
    const char* types[] = { "vtkMultiBlockDataSet", "vtkUnstructuredGrid", "vtkTable" };
    EXPECT_TRUE(inner->GetBlock(0)->IsA(types[port]));
  }
  auto* ball = vtkMultiBlockDataSet::SafeDownCast(GetTree(carver, 0)->GetBlock(0));
  auto* boxes = vtkMultiBlockDataSet::SafeDownCast(
    vtkMultiBlockDataSet::SafeDownCast(GetTree(carver, 0)->GetBlock(2))->GetBlock(0));
  EXPECT_EQ(ball->GetNumberOfBlocks(), 1u);
  ASSERT_EQ(boxes->GetNumberOfBlocks(), 2u);
  EXPECT_EQ(vtkPolyData::SafeDownCast(boxes->GetBlock(1))->GetNumberOfPolys(), 24);
}

// Partitioned data sets become blocks.
TEST(Composite, CarvesPartitions)
{
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, TwoBoxes());
  partitions->SetPartition(1, ToPolyData(models::Sphere(1)));
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, partitions);
  const auto carver = Carve(collection);
  auto* inner = vtkMultiBlockDataSet::SafeDownCast(GetTree(carver, 0)->GetBlock(0));
  ASSERT_NE(inner, nullptr);
  EXPECT_EQ(inner->GetNumberOfBlocks(), 2u);
  EXPECT_EQ(vtkMultiBlockDataSet::SafeDownCast(inner->GetBlock(1))->GetNumberOfBlocks(), 1u);
}

// A leaf that cannot be carved is reported, and the other leaves are carved.
TEST(Composite, GoesOnAfterABadLeaf)
{
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, ToPolyData(models::Sheet(2)));
  scene->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "sheet");
  vtkNew<vtkUnstructuredGrid> grid;
  scene->SetBlock(1, grid);
  scene->SetBlock(2, TwoBoxes());
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  Carve(carver, scene);
  ASSERT_EQ(messages.Errors.size(), 2u);
  EXPECT_TRUE(Has(messages.Errors[0], "Block sheet: All points lie in one plane"));
  EXPECT_TRUE(Has(messages.Errors[1], "Block 1: A vtkUnstructuredGrid is given"));
  EXPECT_GT(
    vtkMultiBlockDataSet::SafeDownCast(GetTree(carver, 0)->GetBlock(2))->GetNumberOfBlocks(), 1u);
}

// An error in a nested scene names the way to the block, by names where blocks have them.
TEST(Composite, NamesTheWayToABadLeaf)
{
  vtkNew<vtkMultiBlockDataSet> inner, scene;
  inner->SetBlock(0, TwoBoxes());
  inner->SetBlock(1, ToPolyData(models::Sheet(2)));
  scene->SetBlock(0, inner);
  scene->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "room");
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  Carve(carver, scene);
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(Has(messages.Errors[0], "Block room: Block 1: All points lie")) << messages.Errors[0];
}

// A change of a level property runs the helper program for no leaf.
TEST(Composite, KeepsTheTetrahedraOfAllLeaves)
{
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, TwoBoxes());
  scene->SetBlock(1, ToPolyData(models::Torus(1.0, 0.3, 8, 5)));
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  Carve(carver, scene);
  const OtherHelper missing("/there/is/no/such/helper");
  carver->SetNumberOfLevels(2);
  carver->Update();
  EXPECT_TRUE(messages.Errors.empty());
}

// As many helper programs run at a time as the filter may have threads, but no more.
TEST(Composite, DecomposesLeavesAtTheSameTime)
{
  for (const int threads : { 1, 3 })
  {
    const std::string folder =
      testing::TempDir() + "/running-" + std::to_string(getpid()) + "-" + std::to_string(threads);
    ASSERT_TRUE(vtksys::SystemTools::MakeDirectory(folder));
    // Each program exits with the number of those that run at the time, itself included. None
    // counts before so many have started, and none ends before so many have counted.
    const std::string meeting = "for i in $(seq 600); do [ $(ls $1.* | wc -l) -ge " +
      std::to_string(threads) + " ] && break; sleep 0.1; done";
    const auto counting =
      OtherHelper::Script("cd " + folder + "\nmeet() { touch $1.$$; " + meeting +
        "; }\n"
        "meet start; n=$(($(ls start.* | wc -l) - $(ls end.* 2>/dev/null | wc -l)))\n"
        "meet counted; touch end.$$; exit $n");
    vtkNew<vtkTopologyCarver> carver;
    Messages messages(carver);
    carver->SetNumberOfThreads(threads);
    const int leaves = 5;
    Carve(carver, Tori(leaves));
    vtksys::SystemTools::RemoveADirectory(folder);
    ASSERT_EQ(messages.Errors.size(), static_cast<std::size_t>(leaves));
    int most = 0;
    for (const std::string& error : messages.Errors)
    {
      const std::string words = "exit code ";
      ASSERT_TRUE(Has(error, words)) << error;
      most = std::max(most, std::stoi(error.substr(error.find(words) + words.size())));
    }
    EXPECT_EQ(most, threads);
  }
}

// A leaf that is in the tree twice is decomposed once.
TEST(Composite, DecomposesACopyOnce)
{
  const std::string log = testing::TempDir() + "/runs-" + std::to_string(getpid());
  const auto counting = OtherHelper::Preceded("echo run >> " + log);
  vtkNew<vtkTopologyCarver> carver;
  carver->SetNumberOfThreads(3);
  auto scene = Tori(1);
  scene->SetBlock(1, scene->GetBlock(0));
  Carve(carver, scene);
  EXPECT_EQ(GetTree(carver, 0)->GetNumberOfBlocks(), 2u);
  std::ifstream file(log);
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>(file), {}, '\n'), 1);
  vtksys::SystemTools::RemoveFile(log);
}

// The levels do not depend on the number of threads.
TEST(Composite, GivesTheSameForAnyNumberOfThreads)
{
  const auto levelsOf = [](int threads)
  {
    vtkNew<vtkTopologyCarver> carver;
    carver->SetNumberOfThreads(threads);
    Carve(carver, Tori(7));
    std::vector<std::multiset<std::array<std::array<double, 3>, 3>>> levels;
    for (vtkPolyData* level :
      vtkCompositeDataSet::GetDataSets<vtkPolyData>(carver->GetOutputDataObject(0)))
    {
      levels.push_back(GetTriangles(level));
    }
    return levels;
  };
  const auto one = levelsOf(1);
  EXPECT_GT(one.size(), 7u);
  EXPECT_EQ(levelsOf(2), one);
  EXPECT_EQ(levelsOf(16), one);
}

// An abort ends all helper programs that run at the time.
TEST(Composite, EndsAllHelpersOnAbort)
{
  const auto hanging = OtherHelper::Script("echo '@progress 0 0' >&2; exec sleep 1000");
  const Leftovers leftovers;
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetNumberOfThreads(4);
  {
    const Aborter aborter(carver, "clean", 3);
    Carve(carver, Tori(6));
  }
  EXPECT_TRUE(messages.Errors.empty());
  leftovers.ExpectNone();
}

// The extractor names a leaf that is not a stream, and gives the levels of the other leaves.
TEST(Composite, GivesTheLevelsOfStreamsAlone)
{
  const auto carver = Carve(TwoBoxes());
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, TwoBoxes());
  scene->SetBlock(1, carver->GetOutputDataObject(1));
  vtkNew<vtkExtractCarvedLOD> extract;
  Messages messages(extract);
  extract->SetInputDataObject(0, scene);
  extract->SetLevelTarget(1e9);
  extract->Update();
  EXPECT_TRUE(Has(messages.TakeError(), "Block 0: A vtkPolyData is not the stream"));
  auto* levels = vtkMultiBlockDataSet::SafeDownCast(extract->GetOutputDataObject(0));
  ASSERT_EQ(levels->GetNumberOfBlocks(), 2u);
  EXPECT_EQ(levels->GetBlock(0), nullptr);
  EXPECT_EQ(GetTriangles(vtkPolyData::SafeDownCast(levels->GetBlock(1))), GetTriangles(TwoBoxes()));
  // A composite of another kind is no tree of streams, either.
  vtkNew<vtkOverlappingAMR> grids;
  const int blocksPerLevel[] = { 1 };
  grids->Initialize(1, blocksPerLevel);
  extract->SetInputDataObject(0, grids);
  extract->Update();
  EXPECT_TRUE(Has(messages.TakeError(), "A vtkOverlappingAMR is not the stream"));
}

// The same filter takes a single mesh after a composite, and a composite after a mesh.
TEST(Composite, FollowsTheTypeOfTheInput)
{
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, TwoBoxes());
  vtkNew<vtkTopologyCarver> carver;
  for (int i = 0; i < 2; ++i)
  {
    Carve(carver, scene);
    EXPECT_TRUE(carver->GetOutputDataObject(1)->IsA("vtkMultiBlockDataSet"));
    Carve(carver, TwoBoxes());
    EXPECT_TRUE(carver->GetOutputDataObject(1)->IsA("vtkUnstructuredGrid"));
    EXPECT_TRUE(carver->GetOutputDataObject(2)->IsA("vtkTable"));
  }
}

// The same extractor takes a single stream after a composite, and a composite after a stream.
TEST(Composite, LetsTheExtractorFollowTheTypeOfTheInput)
{
  const auto carver = Carve(TwoBoxes());
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, GetStream(carver));
  vtkNew<vtkExtractCarvedLOD> extract;
  Messages messages(extract);
  extract->SetLevelTarget(1e9);
  for (int i = 0; i < 2; ++i)
  {
    extract->SetInputDataObject(scene);
    extract->Update();
    auto* levels = vtkMultiBlockDataSet::SafeDownCast(extract->GetOutputDataObject(0));
    ASSERT_TRUE(levels);
    ExpectEqualData(levels->GetBlock(0), LastLevel(carver));
    extract->SetInputDataObject(GetStream(carver));
    extract->Update();
    ASSERT_TRUE(extract->GetOutput());
    ExpectEqualData(extract->GetOutput(), LastLevel(carver));
  }
  EXPECT_TRUE(messages.Errors.empty());
}
