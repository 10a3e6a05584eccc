// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "vtkDataAssembly.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

vtkPartitionedDataSetCollection* GetCollection(vtkTopologyCarver* carver)
{
  return vtkPartitionedDataSetCollection::SafeDownCast(carver->GetOutputDataObject(0));
}

std::string GetName(vtkPartitionedDataSetCollection* collection, unsigned int index)
{
  return collection->GetMetaData(index)->Get(vtkCompositeDataSet::NAME());
}

/** The text of the path from the root to the node of a partitioned data set. */
std::string GetPath(vtkPartitionedDataSetCollection* collection, unsigned int index)
{
  vtkDataAssembly* assembly = collection->GetDataAssembly();
  for (const int node : assembly->GetChildNodes(assembly->GetRootNode()))
  {
    const auto indices = assembly->GetDataSetIndices(node);
    if (std::find(indices.begin(), indices.end(), index) != indices.end())
    {
      return assembly->GetNodePath(node);
    }
  }
  return {};
}

} // namespace

// As a partitioned data set collection, the output has the same levels, names and field data.
TEST(OutputType, CanBeACollection)
{
  const auto blocks = Carve(TwoBoxes(), 2);
  vtkNew<vtkTopologyCarver> carver;
  carver->SetOutputType(vtkTopologyCarver::PARTITIONED_COLLECTION);
  carver->SetNumberOfLevels(2);
  Carve(carver, TwoBoxes());
  EXPECT_EQ(carver->GetOutput(), nullptr);
  vtkPartitionedDataSetCollection* collection = GetCollection(carver);
  ASSERT_NE(collection, nullptr);
  ASSERT_EQ(collection->GetNumberOfPartitionedDataSets(), 2u);
  ASSERT_NE(collection->GetDataAssembly(), nullptr);
  for (const unsigned int i : { 0u, 1u })
  {
    EXPECT_EQ(GetName(collection, i), "LOD " + std::to_string(i));
    EXPECT_TRUE(Has(GetPath(collection, i), "LOD"));
    ASSERT_EQ(collection->GetPartitionedDataSet(i)->GetNumberOfPartitions(), 1u);
    ExpectEqualData(collection->GetPartition(i, 0), GetLevel(blocks, static_cast<int>(i)));
  }
  carver->SetOutputType(vtkTopologyCarver::MULTIBLOCK);
  carver->Update();
  ExpectEqualData(carver->GetOutput(), blocks->GetOutput());
}

// The notes are in the collection's field data.
TEST(OutputType, KeepsNotes)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetOutputType(vtkTopologyCarver::PARTITIONED_COLLECTION);
  Carve(carver, ToPolyData(models::Box({ 0, 0, 0 }, { 1, 1, 1 })));
  EXPECT_TRUE(Has(GetFieldText(carver->GetOutputDataObject(0), "Notes"), "nothing to carve"));
}

// The levels of a tree of objects become data sets of one collection, whose assembly is the tree.
TEST(OutputType, CanBeACollectionOfATree)
{
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, TwoBoxes());
  scene->SetBlock(1, nullptr);
  scene->SetBlock(2, ToPolyData(models::Sphere(1)));
  scene->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "boxes");
  scene->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "ball");
  vtkNew<vtkTopologyCarver> carver;
  carver->SetOutputType(vtkTopologyCarver::PARTITIONED_COLLECTION);
  carver->SetNumberOfLevels(2);
  Carve(carver, scene);
  vtkPartitionedDataSetCollection* collection = GetCollection(carver);
  ASSERT_NE(collection, nullptr);
  EXPECT_EQ(vtkCompositeDataSet::GetDataSets<vtkPolyData>(collection).size(), 3u);
  vtkDataAssembly* assembly = collection->GetDataAssembly();
  ASSERT_NE(assembly, nullptr);
  const int boxes = assembly->FindFirstNodeWithName("boxes");
  ASSERT_NE(boxes, -1);
  EXPECT_EQ(assembly->GetDataSetIndices(boxes).size(), 2u);
}

// Nothing gives an empty collection.
TEST(OutputType, IsEmptyForNothing)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetOutputType(vtkTopologyCarver::PARTITIONED_COLLECTION);
  vtkNew<vtkPolyData> nothing;
  Carve(carver, nothing);
  ASSERT_NE(GetCollection(carver), nullptr);
  EXPECT_EQ(GetCollection(carver)->GetNumberOfPartitionedDataSets(), 0u);
}
