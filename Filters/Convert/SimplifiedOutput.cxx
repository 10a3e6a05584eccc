// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/SimplifiedOutput.h"

#include "Convert/ArrayNames.h"
#include "Convert/ArrayReader.h"
#include "Convert/ArrayTools.h"
#include "Core/Surface/SurfaceTopology.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace
{

constexpr int StepNumbers = 6;  ///< step, vertices, triangles, collapses, points, faces
constexpr int FaceNumbers = 6;  ///< three corners, cell, birth, death
constexpr int LevelNumbers = 5; ///< index, collapses, error, last step, target

template <class ArrayType, class Value>
void AddTuples(vtkFieldData* fieldData, const char* name, const std::vector<Value>& values,
  const std::vector<const char*>& components)
{
  const int count = static_cast<int>(components.size());
  auto array = MakeArray<ArrayType>(name, static_cast<vtkIdType>(values.size() / count), count);
  for (int i = 0; i < count; ++i)
  {
    array->SetComponentName(i, components[i]);
  }
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  fieldData->AddArray(array);
}

/** The number of tuples of an array that need not be there. */
vtkIdType CountTuples(vtkFieldData* fieldData, const char* name)
{
  vtkAbstractArray* array = fieldData->GetAbstractArray(name);
  return array ? array->GetNumberOfTuples() : 0;
}

/** The values of all decimated steps, one after the other. */
struct Arrays
{
  std::vector<int> Steps;
  std::vector<int> Points;
  std::vector<int> Faces;
  std::vector<double> Levels;
};

Arrays ReadArrays(vtkUnstructuredGrid* grid, const carving::Profile& profile, ArrayReader& reader)
{
  Arrays arrays;
  vtkFieldData* fieldData = grid->GetFieldData();
  const auto count = [&](const char* name) { return CountTuples(fieldData, name); };
  reader.Read(fieldData, StreamArrays::SimplifiedSteps, count(StreamArrays::SimplifiedSteps),
    IntegersFrom(0), arrays.Steps, StepNumbers);
  vtkIdType points = 0, faces = 0;
  for (std::size_t i = 0; i < arrays.Steps.size(); i += StepNumbers)
  {
    if (arrays.Steps[i] > profile.LastStep())
    {
      reader.Refuse(StreamArrays::SimplifiedSteps, "has a step beyond the profile");
    }
    points += arrays.Steps[i + 4];
    faces += arrays.Steps[i + 5];
  }
  reader.Read(fieldData, StreamArrays::SimplifiedPoints, points,
    IntegersFrom(0, static_cast<int>(grid->GetNumberOfPoints()) - 1), arrays.Points);
  reader.Read(
    fieldData, StreamArrays::SimplifiedFaces, faces, IntegersFrom(0), arrays.Faces, FaceNumbers);
  reader.Read(fieldData, StreamArrays::SimplifiedLevels, count(StreamArrays::SimplifiedLevels),
    FiniteMeasures(), arrays.Levels, LevelNumbers);
  return arrays;
}

/** Makes the decimated steps from valid numbers, and checks how they fit together. */
void MakeSteps(const Arrays& arrays, vtkIdType cells, ArrayReader& reader,
  std::vector<carving::DecimatedStep>& steps)
{
  auto point = arrays.Points.begin();
  auto face = arrays.Faces.begin();
  for (auto numbers = arrays.Steps.begin(); numbers != arrays.Steps.end(); numbers += StepNumbers)
  {
    carving::DecimatedStep& step = steps.emplace_back();
    step.Step = numbers[0];
    step.Chain.Vertices = numbers[1];
    step.Chain.Triangles = numbers[2];
    step.Chain.Collapses = numbers[3];
    step.Points.assign(point, point + numbers[4]);
    point += numbers[4];
    for (int i = 0; i < numbers[5]; ++i, face += FaceNumbers)
    {
      step.Chain.Faces.push_back({ { face[0], face[1], face[2] }, face[3], face[4], face[5] });
      if (face[3] >= cells)
      {
        reader.Refuse(StreamArrays::SimplifiedFaces, "has a cell that does not exist");
      }
    }
    const std::string mistake = carving::FindMistake(step.Chain, step.Points.size());
    if (!mistake.empty())
    {
      reader.Refuse(StreamArrays::SimplifiedFaces, "contradicts the decimated steps: " + mistake);
      return;
    }
    const carving::CollapsedSurface surface = carving::ExtractSurface(step.Chain, 0);
    const carving::SurfaceTopology topology =
      carving::MeasureSurface({ surface.Triangles, surface.Points });
    step.SurfaceComponents = topology.Components;
    step.SurfaceGenus = topology.Genus;
  }
}

void MakeLevels(const std::vector<double>& numbers, const carving::Profile& profile,
  ArrayReader& reader, carving::SimplifiedStream& stream)
{
  for (auto level = numbers.begin(); level != numbers.end(); level += LevelNumbers)
  {
    for (const int whole : { 0, 1, 3 })
    {
      if (level[whole] != std::floor(level[whole]))
      {
        reader.Refuse(StreamArrays::SimplifiedLevels, "has a fraction in place of an index");
        return;
      }
    }
    if (level[0] >= static_cast<double>(stream.Steps.size()) ||
      level[1] > stream.Steps[static_cast<std::size_t>(level[0])].Chain.Collapses ||
      level[3] > profile.LastStep())
    {
      reader.Refuse(StreamArrays::SimplifiedLevels, "has a number out of range");
      return;
    }
    stream.Levels.push_back({ static_cast<int>(level[0]), static_cast<int>(level[1]), level[2],
      static_cast<int>(level[3]), level[4] });
  }
}

} // namespace

void FillSimplifiedStream(const carving::SimplifiedStream& stream, vtkFieldData* fieldData)
{
  if (stream.Levels.empty())
  {
    return;
  }
  Arrays arrays;
  for (const carving::DecimatedStep& step : stream.Steps)
  {
    const carving::CollapseChain& chain = step.Chain;
    arrays.Steps.insert(arrays.Steps.end(),
      { step.Step, chain.Vertices, chain.Triangles, chain.Collapses,
        static_cast<int>(step.Points.size()), static_cast<int>(chain.Faces.size()) });
    arrays.Points.insert(arrays.Points.end(), step.Points.begin(), step.Points.end());
    for (const auto& [corners, cell, birth, death] : chain.Faces)
    {
      arrays.Faces.insert(
        arrays.Faces.end(), { corners[0], corners[1], corners[2], cell, birth, death });
    }
  }
  for (const auto& [chain, collapses, error, lastStep, target] : stream.Levels)
  {
    arrays.Levels.insert(arrays.Levels.end(),
      { static_cast<double>(chain), static_cast<double>(collapses), error,
        static_cast<double>(lastStep), target });
  }
  AddFieldValue<vtkIntArray>(
    fieldData, StreamArrays::SimplifiedType, static_cast<int>(stream.Type));
  AddTuples<vtkIntArray>(fieldData, StreamArrays::SimplifiedSteps, arrays.Steps,
    { "Step", "Vertices", "Triangles", "Collapses", "Points", "Faces" });
  AddTuples<vtkIntArray>(fieldData, StreamArrays::SimplifiedPoints, arrays.Points, { "Point" });
  AddTuples<vtkIntArray>(fieldData, StreamArrays::SimplifiedFaces, arrays.Faces,
    { "A", "B", "C", "Cell", "Birth", "Death" });
  AddTuples<vtkDoubleArray>(fieldData, StreamArrays::SimplifiedLevels, arrays.Levels,
    { "Index", "Collapses", "Error", "LastStep", "Target" });
}

void ReadSimplifiedStream(vtkUnstructuredGrid* grid, const carving::Profile& profile,
  ArrayReader& reader, carving::SimplifiedStream& stream)
{
  if (!grid->GetFieldData()->HasArray(StreamArrays::SimplifiedType))
  {
    return;
  }
  std::vector<int> type;
  reader.Read(grid->GetFieldData(), StreamArrays::SimplifiedType, 1,
    { "the number of vertices (0), triangles (1) or an error bound (5)",
      [](double value, vtkIdType) { return value == 0.0 || value == 1.0 || value == 5.0; } },
    type);
  const Arrays arrays = ReadArrays(grid, profile, reader);
  if (!reader.GetMistake().empty())
  {
    return;
  }
  stream.Type = static_cast<carving::LevelTarget>(type[0]);
  MakeSteps(arrays, grid->GetNumberOfCells(), reader, stream.Steps);
  if (reader.GetMistake().empty())
  {
    MakeLevels(arrays.Levels, profile, reader, stream);
  }
}
