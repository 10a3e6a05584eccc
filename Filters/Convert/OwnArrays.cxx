// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/OwnArrays.h"

#include "Convert/ArrayNames.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cstddef>

namespace
{

constexpr const char* CellNames[] = { StreamArrays::Priority, StreamArrays::Depth,
  StreamArrays::Step, StreamArrays::Region, StreamArrays::SolidSides, StreamArrays::OriginalCells,
  StreamArrays::MetShare };

constexpr const char* PointNames[] = { StreamArrays::OriginalPoints, StreamArrays::SnapDistance };

/** Field data of levels, streams and the whole of port 0. */
constexpr const char* FieldNames[] = { StreamArrays::Step, LevelArrays::Vertices,
  LevelArrays::NewVertices, LevelArrays::Triangles, LevelArrays::Kind, StreamArrays::Strategy,
  StreamArrays::KeptDistance, StreamArrays::KeptDistance99, StreamArrays::KeptDistanceMean,
  StreamArrays::MetShare, StreamArrays::SnapDistance, LevelArrays::FeatureSize, LevelArrays::Error,
  LevelArrays::Components, LevelArrays::Tunnels, LevelArrays::Voids, LevelArrays::SurfaceComponents,
  LevelArrays::SurfaceGenus, StreamArrays::Measure, StreamArrays::BothFoldSides,
  StreamArrays::ProfileVertices, StreamArrays::ProfileTriangles, StreamArrays::ProfileError,
  StreamArrays::ProfileVolume, StreamArrays::ProfileComponents, StreamArrays::ProfileTunnels,
  StreamArrays::ProfileVoids, StreamArrays::ProfilePriority, StreamArrays::TargetRanges,
  StreamArrays::SimplifiedType, StreamArrays::SimplifiedSteps, StreamArrays::SimplifiedPoints,
  StreamArrays::SimplifiedFaces, StreamArrays::SimplifiedLevels, NotesArray };

/** Renames arrays, each by a copy, and adds "old" as "new" to the list. */
template <std::size_t N>
void Rename(
  vtkDataSetAttributes* attributes, const char* const (&names)[N], std::vector<std::string>& list)
{
  for (const char* name : names)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(name);
    if (!array)
    {
      continue;
    }
    std::string newName = std::string("Input") + name;
    while (attributes->HasArray(newName.c_str()))
    {
      newName = "Input" + newName;
    }
    vtkSmartPointer<vtkAbstractArray> copy;
    copy.TakeReference(array->NewInstance());
    copy->DeepCopy(array);
    copy->SetName(newName.c_str());
    int index = 0;
    attributes->GetAbstractArray(name, index);
    const int role = attributes->IsArrayAnAttribute(index); // scalars, normals and so on, or -1
    attributes->RemoveArray(name);
    attributes->AddArray(copy);
    if (role >= 0)
    {
      attributes->SetActiveAttribute(newName.c_str(), role);
    }
    list.push_back(std::string("\"") + name + "\" as \"" + newName + "\"");
  }
}

/** Removes arrays that do not have `count` values, and adds their names and numbers to the list. */
void RemoveMismatched(vtkDataSetAttributes* attributes, vtkIdType count, const char* elements,
  std::vector<std::string>& list)
{
  for (int i = attributes->GetNumberOfArrays(); i-- > 0;)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    const vtkIdType values = array->GetNumberOfTuples();
    if (values != count)
    {
      const char* name = array->GetName();
      list.push_back("\"" + std::string(name ? name : "") + "\" (" + std::to_string(values) +
        " for " + std::to_string(count) + " " + elements + ")");
      attributes->RemoveArray(i);
    }
  }
}

void AddNote(const std::string& beginning, const std::vector<std::string>& list,
  std::vector<std::string>& notes)
{
  std::string note = beginning;
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    note += (i > 0 ? ", " : " ") + list[i];
  }
  if (!list.empty())
  {
    notes.push_back(note + ".");
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> WithUsableArrays(vtkPolyData* input, std::vector<std::string>& notes)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(input);
  std::vector<std::string> mismatched, renamed;
  RemoveMismatched(copy->GetCellData(), input->GetNumberOfCells(), "cells", mismatched);
  RemoveMismatched(copy->GetPointData(), input->GetNumberOfPoints(), "points", mismatched);
  Rename(copy->GetCellData(), CellNames, renamed);
  Rename(copy->GetPointData(), PointNames, renamed);
  AddNote(
    "Arrays of the input without one value for each element were left out:", mismatched, notes);
  AddNote(
    "Arrays of the input that have names of the carver's arrays were renamed:", renamed, notes);
  return mismatched.empty() && renamed.empty() ? vtkSmartPointer<vtkPolyData>(input) : copy;
}

void RemoveOwnFieldData(vtkFieldData* fieldData, vtkFieldData* settings)
{
  for (const char* name : FieldNames)
  {
    fieldData->RemoveArray(name);
  }
  for (int i = 0; i < settings->GetNumberOfArrays(); ++i)
  {
    fieldData->RemoveArray(settings->GetArrayName(i));
  }
}
