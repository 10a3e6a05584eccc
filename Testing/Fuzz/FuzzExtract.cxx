// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fuzz target: vtkExtractCarvedLOD on streams as files may contain them. Levels of an intact stream
 * have the right size; levels of a damaged or foreign one are valid data.
 */
#include "Carving.h"
#include "Convert/ArrayTools.h"
#include "Convert/SimplifiedOutput.h"
#include "Convert/StreamOutput.h"
#include "Core/Stream/Level.h"
#include "Decompositions.h"
#include "GridDamage.h"
#include "PolyData.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

using namespace carving;

namespace
{

/** Every corner is a point, and every array has one tuple per point or cell. */
void CheckLevel(vtkPolyData* level)
{
  const vtkIdType numberOfPoints = level->GetNumberOfPoints();
  for (vtkCellArray* cells : { level->GetPolys(), level->GetLines() })
  {
    vtkDataArray* corners = cells->GetConnectivityArray();
    for (vtkIdType i = 0; i < corners->GetNumberOfTuples(); ++i)
    {
      Require(corners->GetTuple1(i) >= 0.0 && corners->GetTuple1(i) < numberOfPoints);
    }
  }
  for (int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* data = level->GetAttributes(type);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      Require(data->GetAbstractArray(i)->GetNumberOfTuples() == level->GetNumberOfElements(type));
    }
  }
}

/** Extracts levels by every kind of target. */
void Extract(Bytes& bytes, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkExtractCarvedLOD> extract;
  extract->SetInputData(grid);
  for (int type = vtkExtractCarvedLOD::VERTICES; type <= vtkExtractCarvedLOD::STEP; ++type)
  {
    double range[2];
    extract->GetLevelTargetRange(type, range);
    extract->SetLevelTargetType(type);
    extract->SetLevelTarget(bytes.Bit() ? range[1] : bytes.Double());
    extract->SetManifoldOutput(bytes.Bit());
    extract->SetLevelSimplification(bytes.Bit());
    extract->SetMaximumVertices(bytes.Bit() ? bytes.Below(64) : 0);
    extract->Update();
    CheckLevel(extract->GetOutput());
  }
  extract->UpdateTimeStep(bytes.Bit() ? bytes.Below(50) : bytes.Double());
  CheckLevel(extract->GetOutput());
}

/** A chain whose collapses remove two triangles each and move nothing, and a level for its end. */
SimplifiedStream MakeSimplified(Bytes& bytes, const Carving<3>& carved)
{
  SimplifiedStream simplified;
  const Level<3> level =
    ExtractLevel(carved.Stored, carved.Steps[bytes.Below(static_cast<int>(carved.Steps.size()))]);
  DecimatedStep& step = simplified.Steps.emplace_back();
  step.Step = level.Step;
  step.Chain.Triangles = static_cast<int>(level.Faces.size());
  step.Chain.Vertices = step.Chain.Triangles;
  step.Chain.Collapses = bytes.Below(std::min(step.Chain.Triangles / 2 + 1, 256));
  for (std::size_t i = 0; i < level.Faces.size(); ++i)
  {
    const int death = std::min(static_cast<int>(i / 2), step.Chain.Collapses) + 1;
    step.Chain.Faces.push_back(
      { level.Faces[i].Corners, CellWithDataOf(carved.Stored, level.Faces[i]), 0, death });
  }
  step.Points.resize(carved.Stored.Mesh.Surface.Points.size());
  std::iota(step.Points.begin(), step.Points.end(), 0);
  simplified.Levels.push_back({ 0, step.Chain.Collapses, 0.5, level.Step, 8.0 });
  return simplified;
}

template <int D>
void FillGrid(Bytes& bytes, const Carving<D>& carved, vtkUnstructuredGrid* grid)
{
  const auto input = ToPolyData({ carved.Stored.Mesh.Surface.Points, {} });
  std::vector<vtkIdType> cellIds(carved.Stored.Mesh.Surface.FacetSources.size());
  std::iota(cellIds.begin(), cellIds.end(), 0);
  StoredStream<D> stored = carved.Stored;
  FillStream(stored, input, cellIds, grid);
  vtkNew<vtkTable> profile;
  FillProfile(carved.Profile, profile);
  AddProfile(profile, !carved.Profile.Error.empty(), grid->GetFieldData());
  // The input's own data.
  auto numbers = MakeArray<vtkDoubleArray>("Numbers", grid->GetNumberOfPoints());
  numbers->Fill(1.0);
  grid->GetPointData()->AddArray(numbers);
  grid->GetCellData()->AddArray(MakeArray<vtkStringArray>("Texts", grid->GetNumberOfCells()));
  vtkFieldData* fieldData = grid->GetFieldData();
  if constexpr (D == 3)
  {
    if (bytes.Bit())
    {
      FillSimplifiedStream(MakeSimplified(bytes, carved), fieldData);
    }
  }
  AddFieldValue<vtkStringArray>(fieldData, StreamArrays::Strategy, "a strategy");
  AddFieldValue<vtkDoubleArray>(fieldData, StreamArrays::KeptDistance, 0.5);
  AddFieldValue<vtkDoubleArray>(fieldData, StreamArrays::KeptDistance99, 0.5);
  AddFieldValue<vtkDoubleArray>(fieldData, StreamArrays::KeptDistanceMean, 0.5);
  AddFieldValue<vtkDoubleArray>(fieldData, StreamArrays::MetShare, 0.5);
  AddFieldValue<vtkDoubleArray>(fieldData, StreamArrays::SnapDistance, 0.25);
}

/** A level of an intact stream has as many faces as the profile states. */
template <int D>
void CheckWhole(const Carving<D>& carved, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkExtractCarvedLOD> extract;
  extract->SetInputData(grid);
  extract->SetLevelTargetType(vtkExtractCarvedLOD::STEP);
  for (const int step : carved.Steps)
  {
    extract->SetLevelTarget(step);
    extract->Update();
    Require(extract->GetOutput()->GetNumberOfCells() == carved.Profile.Triangles[step]);
  }
}

template <int D>
void ExtractDamaged(Bytes& bytes)
{
  const Carving<D> carved = CarveWith(bytes, MakeDecomposition<D>(bytes));
  vtkNew<vtkUnstructuredGrid> grid;
  FillGrid(bytes, carved, grid);
  if (!carved.Stored.Mesh.Surface.Facets.empty()) // M is not empty
  {
    CheckWhole(carved, grid);
  }
  for (int damages = bytes.Below(4); damages > 0; --damages)
  {
    Damage(bytes, grid);
  }
  Extract(bytes, grid);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  vtkObject::GlobalWarningDisplayOff(); // errors are expected
  Bytes bytes(data, size);
  switch (bytes.Below(4))
  {
    case 0:
      ExtractDamaged<2>(bytes);
      break;
    case 1:
    {
      vtkNew<vtkUnstructuredGrid> grid;
      MakeForeign(bytes, grid);
      Extract(bytes, grid);
      break;
    }
    default:
      ExtractDamaged<3>(bytes);
  }
  return 0;
}
