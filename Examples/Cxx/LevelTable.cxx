// SPDX-License-Identifier: BSD-3-Clause
#include "LevelTable.h"

#include "Objects.h"
#include "Options.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace
{

/** A number in the field data of a level; a dash if the number is unknown. */
std::string GetNumber(vtkPolyData* level, const char* name)
{
  const double number = level->GetFieldData()->GetArray(name)->GetTuple1(0);
  return number < 0.0 ? "-" : std::to_string(static_cast<long long>(number));
}

/** Steps, sizes and topology of levels. */
void PrintLevels(vtkMultiBlockDataSet* levels, bool contours)
{
  std::printf("%5s %9s %10s %10s %10s %7s %6s\n", "level", "step", "vertices",
    contours ? "edges" : "triangles", "components", contours ? "holes" : "tunnels", "voids");
  for (unsigned int i = 0; i < levels->GetNumberOfBlocks(); ++i)
  {
    auto* level = vtkPolyData::SafeDownCast(levels->GetBlock(i));
    std::printf("%5u %9s %10s %10s %10s %7s %6s\n", i, GetNumber(level, "Step").c_str(),
      GetNumber(level, "Vertices").c_str(), GetNumber(level, "Triangles").c_str(),
      GetNumber(level, "Components").c_str(), GetNumber(level, "Tunnels").c_str(),
      GetNumber(level, "Voids").c_str());
  }
}

/** Sizes and errors of decimated surfaces. */
void PrintSurfaces(vtkMultiBlockDataSet* surfaces)
{
  std::printf("%5s %10s %10s %12s\n", "level", "vertices", "triangles", "error");
  for (unsigned int i = 0; i < surfaces->GetNumberOfBlocks(); ++i)
  {
    auto* surface = vtkPolyData::SafeDownCast(surfaces->GetBlock(i));
    std::printf("%5u %10s %10s %12g\n", i, GetNumber(surface, "Vertices").c_str(),
      GetNumber(surface, "Triangles").c_str(),
      surface->GetFieldData()->GetArray("Error")->GetTuple1(0));
  }
}

void PrintNotes(vtkMultiBlockDataSet* output)
{
  for (const std::string& note : GetNotes(output))
  {
    std::printf("note: %s\n", note.c_str());
  }
}

} // namespace

void LevelTable::Print(const Options& options, vtkMultiBlockDataSet* output)
{
  if (options.Decimate)
  {
    PrintSurfaces(output);
    PrintNotes(output);
    return;
  }
  const std::vector<Object> objects = ListObjects(options.Inputs, output);
  for (const Object& object : objects)
  {
    if (objects.size() > 1)
    {
      std::printf("%s%s%s%s\n", object.Input.c_str(), object.Block.empty() ? "" : ": ",
        object.Block.c_str(), object.Levels->GetNumberOfBlocks() == 0 ? ": no levels" : "");
    }
    PrintLevels(object.Levels, options.Contours);
    PrintNotes(object.Levels);
  }
  if (objects.size() > 1)
  {
    PrintNotes(output);
  }
}

void LevelTable::PrintStream(vtkUnstructuredGrid* stream, bool contours)
{
  auto* strategy =
    vtkStringArray::SafeDownCast(stream->GetFieldData()->GetAbstractArray("Strategy"));
  if (strategy) // an empty input has none
  {
    vtkUnsignedCharArray* types = stream->GetCellTypesArray();
    const auto number =
      std::count(types->Begin(), types->End(), contours ? VTK_TRIANGLE : VTK_TETRA);
    std::printf("stream: %lld %s (%s)\n", static_cast<long long>(number),
      contours ? "triangles" : "tetrahedra", strategy->GetValue(0).c_str());
  }
}
