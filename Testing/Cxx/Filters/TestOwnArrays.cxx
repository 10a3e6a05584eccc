// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Arrays of the input that have the names of arrays that the carvers write.
 */
#include "Convert/ArrayTools.h"
#include "FilterTesting.h"
#include "RandomModels.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace
{

std::set<std::string> GetNames(vtkFieldData* data)
{
  std::set<std::string> names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    names.insert(data->GetAbstractArray(i)->GetName());
  }
  return names;
}

/** The field data of all outputs for a single mesh. */
std::vector<vtkFieldData*> GetAllFieldData(vtkTopologyCarver* carver)
{
  std::vector<vtkFieldData*> all;
  for (int port = 0; port < 3; ++port)
  {
    all.push_back(carver->GetOutputDataObject(port)->GetFieldData());
  }
  for (int i = 0; i < CountLevels(carver); ++i)
  {
    all.push_back(GetLevel(carver, i)->GetFieldData());
  }
  return all;
}

/** All names of field data that a carving can write. */
std::set<std::string> GetOwnNames()
{
  std::mt19937_64 random(1);
  vtkNew<vtkTopologyCarver> carver;
  carver->SetConformity(vtkTopologyCarver::ENCLOSING);
  carver->AppendInputOn();
  carver->ComputeErrorOn();
  Carve(carver, ToPolyData(models::Soup(60, random)));
  std::set<std::string> names = { "SnapDistance" }; // of a snapped mesh
  for (vtkFieldData* data : GetAllFieldData(carver))
  {
    names.merge(GetNames(data));
  }
  EXPECT_TRUE(names.count("KeptDistance"));
  EXPECT_TRUE(names.count("Notes"));
  EXPECT_TRUE(names.count("ProfileError"));
  return names;
}

bool HasText(vtkFieldData* data, const std::string& name, const std::string& text)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetAbstractArray(name.c_str()));
  return array && array->GetNumberOfValues() > 0 && array->GetValue(0) == text;
}

template <class ArrayType>
void AddNumbers(vtkFieldData* data, const char* name, vtkIdType count, double first)
{
  auto array = MakeArray<ArrayType>(name, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetTuple1(i, first + static_cast<double>(i));
  }
  data->AddArray(array);
}

} // namespace

// Field data of an older carving are dropped; all other field data are passed on.
TEST(OwnArrays, DropFieldDataOfAnOlderCarving)
{
  auto input = TwoBoxes();
  const std::set<std::string> own = GetOwnNames();
  for (const std::string& name : own)
  {
    AddFieldValue<vtkStringArray>(input->GetFieldData(), name.c_str(), "stale");
  }
  AddFieldValue<vtkStringArray>(input->GetFieldData(), "Unit", "mm");
  const auto carver = Carve(input);
  for (vtkFieldData* data : GetAllFieldData(carver))
  {
    for (const std::string& name : own)
    {
      EXPECT_FALSE(HasText(data, name, "stale")) << name;
    }
  }
  EXPECT_FALSE(GetLevel(carver, 0)->GetFieldData()->HasArray("KeptDistance"));
  for (int port = 0; port < 3; ++port)
  {
    EXPECT_TRUE(HasText(carver->GetOutputDataObject(port)->GetFieldData(), "Unit", "mm"));
  }
}

// Field data of an older carving are dropped for each leaf of a composite, and for the whole.
TEST(OwnArrays, DropFieldDataOfLeaves)
{
  auto leaf = TwoBoxes();
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, leaf);
  for (vtkFieldData* data : { leaf->GetFieldData(), scene->GetFieldData() })
  {
    AddFieldValue<vtkStringArray>(data, "Strategy", "stale");
    AddFieldValue<vtkStringArray>(data, "ProfileError", "stale");
    AddFieldValue<vtkStringArray>(data, "Notes", "stale");
    AddFieldValue<vtkStringArray>(data, "Unit", "mm");
  }
  const auto carver = Carve(scene);
  for (int port = 0; port < 3; ++port)
  {
    auto* whole = vtkMultiBlockDataSet::SafeDownCast(carver->GetOutputDataObject(port));
    for (vtkFieldData* data : { whole->GetFieldData(), whole->GetBlock(0)->GetFieldData() })
    {
      EXPECT_TRUE(HasText(data, "Unit", "mm"));
      for (const char* name : { "Strategy", "ProfileError", "Notes" })
      {
        EXPECT_FALSE(HasText(data, name, "stale")) << name;
      }
    }
  }
}

// A stream is readable although the input's field data had an old profile.
TEST(OwnArrays, OldProfilesDoNotSpoilTheStream)
{
  auto input = TwoBoxes();
  AddNumbers<vtkDoubleArray>(input->GetFieldData(), "ProfileError", 1234, 0.0);
  const auto carver = Carve(input);
  vtkNew<vtkExtractCarvedLOD> extract;
  Messages messages(extract);
  extract->SetInputData(carver->GetOutputDataObject(1));
  extract->Update();
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_EQ(extract->GetOutput()->GetNumberOfPolys(), 24);
}

// Cell and point arrays that have names of the outputs are renamed, and a note says so.
TEST(OwnArrays, KeepTheInputsUnderAnotherName)
{
  auto input = TwoBoxes();
  const vtkIdType cells = input->GetNumberOfCells(), points = input->GetNumberOfPoints();
  double first = 1000.0;
  const char* cellNames[] = { "Depth", "Priority", "Step", "Region", "SolidSides", "Error",
    "vtkOriginalCellIds", "InputDepth" };
  for (const char* name : cellNames)
  {
    AddNumbers<vtkDoubleArray>(input->GetCellData(), name, cells, first += 1000.0);
  }
  const char* pointNames[] = { "vtkOriginalPointIds", "SnapDistance", "Depth" };
  for (const char* name : pointNames)
  {
    AddNumbers<vtkIntArray>(input->GetPointData(), name, points, first += 1000.0);
  }
  input->GetCellData()->SetActiveScalars("Depth");
  const auto carver = Carve(input, 2);
  const std::string note = GetNotes(carver);
  const auto renamed = [&](const std::string& name) -> std::string
  {
    const std::string quoted = "\"" + name + "\" as \"";
    const std::size_t found = note.find(quoted);
    return found == std::string::npos
      ? name
      : note.substr(
          found + quoted.size(), note.find('"', found + quoted.size()) - found - quoted.size());
  };
  EXPECT_EQ(renamed("Priority"), "InputPriority");
  EXPECT_EQ(renamed("Depth"), "InputInputDepth");
  EXPECT_EQ(renamed("Error"), "Error");
  vtkPolyData* level = GetLevel(carver, 1);
  vtkDataArray* cellIds = level->GetCellData()->GetArray("vtkOriginalCellIds");
  vtkDataArray* pointIds = level->GetPointData()->GetArray("vtkOriginalPointIds");
  ASSERT_EQ(level->GetNumberOfCells(), cells);
  first = 1000.0;
  for (const char* name : cellNames)
  {
    vtkDataArray* array = level->GetCellData()->GetArray(renamed(name).c_str());
    ASSERT_NE(array, nullptr) << name;
    first += 1000.0;
    for (vtkIdType i = 0; i < cells; ++i)
    {
      EXPECT_EQ(array->GetTuple1(i), first + cellIds->GetTuple1(i)) << name;
    }
  }
  for (const char* name : pointNames)
  {
    const std::string newName = std::string(name) == "Depth" ? name : renamed(name);
    vtkDataArray* array = level->GetPointData()->GetArray(newName.c_str());
    ASSERT_NE(array, nullptr) << name;
    first += 1000.0;
    for (vtkIdType i = 0; i < level->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(array->GetTuple1(i), first + pointIds->GetTuple1(i)) << name;
    }
  }
  EXPECT_STREQ(level->GetCellData()->GetScalars()->GetName(), "InputInputDepth");
  EXPECT_TRUE(input->GetCellData()->HasArray("Priority")) << "the input is as it was";
}

// Arrays that are shorter or longer than the number of elements are left out, and a note says so.
TEST(OwnArrays, LeaveOutArraysOfAWrongLength)
{
  auto input = TwoBoxes();
  AddNumbers<vtkIntArray>(input->GetCellData(), "Short", input->GetNumberOfCells() - 1, 0.0);
  AddNumbers<vtkIntArray>(input->GetCellData(), "Right", input->GetNumberOfCells(), 0.0);
  AddNumbers<vtkDoubleArray>(input->GetPointData(), "Long", input->GetNumberOfPoints() + 1, 0.0);
  const auto carver = Carve(input);
  const std::string notes = GetNotes(carver);
  EXPECT_TRUE(Has(notes, "\"Short\" (23 for 24 cells), \"Long\" (17 for 16 points)"));
  vtkPolyData* level = GetLevel(carver, 1);
  EXPECT_FALSE(level->GetCellData()->HasArray("Short"));
  EXPECT_TRUE(level->GetCellData()->HasArray("Right"));
  EXPECT_FALSE(level->GetPointData()->HasArray("Long"));
}

// A level that is carved again keeps the arrays of its cells beside the new ones.
TEST(OwnArrays, KeepTheArraysOfALevelThatIsCarvedAgain)
{
  vtkNew<vtkTopologyCarver> first, second;
  first->SetNumberOfLevels(2);
  Carve(first, TwoBoxes());
  second->SetNumberOfLevels(1);
  Carve(second, GetLevel(first, 0));
  vtkCellData* data = GetLevel(second, 0)->GetCellData();
  for (const char* name : { "Priority", "Depth", "vtkOriginalCellIds", "InputPriority",
         "InputDepth", "InputvtkOriginalCellIds" })
  {
    EXPECT_TRUE(data->HasArray(name)) << name;
  }
}
