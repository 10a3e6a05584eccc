// SPDX-License-Identifier: BSD-3-Clause
#include "GridDamage.h"

#include "Convert/ArrayTools.h"
#include "Convert/StreamOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

namespace
{

vtkIdType DrawIndex(Bytes& bytes, vtkIdType count)
{
  const vtkIdType high = 256 * bytes.Below(256);
  return (high + bytes.Below(256)) % count;
}

/** A small integer, which may be valid, or any number. */
double DrawValue(Bytes& bytes)
{
  return bytes.Below(4) > 0 ? bytes.Below(256) - 4.0 : bytes.Double();
}

/** A small id, which may be valid, or an invalid one. */
vtkIdType DrawId(Bytes& bytes)
{
  switch (bytes.Below(8))
  {
    case 0:
      return VTK_ID_MAX;
    case 1:
      return VTK_ID_MIN;
    case 2:
      return -1;
    default:
      return bytes.Below(256);
  }
}

int DrawType(Bytes& bytes)
{
  constexpr int types[] = { VTK_TETRA, VTK_TRIANGLE, VTK_LINE, VTK_VERTEX, VTK_QUAD,
    VTK_EMPTY_CELL };
  return types[bytes.Below(6)];
}

vtkFieldData* GetData(vtkUnstructuredGrid* grid, int which)
{
  vtkFieldData* const all[] = { grid->GetPointData(), grid->GetCellData(), grid->GetFieldData() };
  return all[which];
}

void DamageIds(Bytes& bytes, vtkDataArray* ids)
{
  if (ids->GetNumberOfTuples() > 0)
  {
    ids->SetTuple1(
      DrawIndex(bytes, ids->GetNumberOfTuples()), static_cast<double>(DrawId(bytes) / 2));
  }
}

/** Changes a value, possibly to one that the array's own type cannot represent. */
void DamageValue(Bytes& bytes, vtkFieldData* data, vtkDataArray* array)
{
  auto changed = MakeArray<vtkDoubleArray>("", 0);
  changed->DeepCopy(array);
  if (changed->GetNumberOfValues() > 0)
  {
    changed->SetValue(DrawIndex(bytes, changed->GetNumberOfValues()), DrawValue(bytes));
  }
  data->AddArray(changed);
}

void DamageLength(Bytes& bytes, vtkAbstractArray* array)
{
  const vtkIdType tuples = array->GetNumberOfTuples();
  if (bytes.Bit() && tuples > 0)
  {
    array->InsertNextTuple(0, array);
  }
  else
  {
    array->SetNumberOfTuples(DrawIndex(bytes, tuples + 1));
  }
}

void DamageForm(Bytes& bytes, vtkFieldData* data, vtkAbstractArray* array)
{
  const vtkIdType tuples = array->GetNumberOfTuples();
  if (bytes.Bit())
  {
    data->AddArray(MakeArray<vtkStringArray>(array->GetName(), tuples));
  }
  else
  {
    auto several = MakeArray<vtkDoubleArray>(array->GetName(), tuples, bytes.Below(4));
    several->Fill(bytes.Below(2));
    data->AddArray(several);
  }
}

void DamageArray(Bytes& bytes, vtkFieldData* data)
{
  if (data->GetNumberOfArrays() == 0)
  {
    return;
  }
  vtkAbstractArray* array = data->GetAbstractArray(bytes.Below(data->GetNumberOfArrays()));
  auto* numbers = vtkDataArray::SafeDownCast(array);
  switch (bytes.Below(6))
  {
    case 0:
      data->RemoveArray(array->GetName());
      break;
    case 1:
      DamageLength(bytes, array);
      break;
    case 2:
      DamageForm(bytes, data, array);
      break;
    default:
      if (numbers)
      {
        DamageValue(bytes, data, numbers);
      }
  }
}

} // namespace

void Damage(Bytes& bytes, vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  switch (bytes.Below(9))
  {
    case 0:
    case 1:
      DamageIds(bytes, grid->GetCells()->GetConnectivityArray());
      break;
    case 2:
      DamageIds(bytes, grid->GetCells()->GetOffsetsArray());
      break;
    case 3:
      DamageLength(bytes, types);
      break;
    case 4:
      if (types->GetNumberOfValues() > 0)
      {
        const vtkIdType i = DrawIndex(bytes, types->GetNumberOfValues());
        types->SetValue(i, static_cast<unsigned char>(DrawType(bytes)));
      }
      break;
    case 5:
      if (grid->GetNumberOfPoints() > 0)
      {
        const vtkIdType i = DrawIndex(bytes, grid->GetNumberOfPoints());
        grid->GetPoints()->SetPoint(i, bytes.Double(), 0.0, 1.0);
      }
      break;
    default:
      DamageArray(bytes, GetData(grid, bytes.Below(3)));
  }
}

void MakeForeign(Bytes& bytes, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int left = bytes.Below(16); left > 0; --left)
  {
    const double x = DrawValue(bytes), y = DrawValue(bytes);
    points->InsertNextPoint(x, y, DrawValue(bytes));
  }
  grid->SetPoints(points);
  for (int left = bytes.Below(16); left > 0; --left)
  {
    std::vector<vtkIdType> corners;
    const int type = DrawType(bytes);
    for (int corner = bytes.Below(6); corner > 0; --corner)
    {
      corners.push_back(bytes.Below(8) > 0 ? bytes.Below(16) : DrawId(bytes));
    }
    grid->InsertNextCell(type, static_cast<vtkIdType>(corners.size()), corners.data());
  }
  for (const char* name :
    { StreamArrays::Priority, StreamArrays::Depth, StreamArrays::Step, StreamArrays::Region,
      StreamArrays::SolidSides, StreamArrays::OriginalCells, StreamArrays::OriginalPoints,
      StreamArrays::Measure, StreamArrays::BothFoldSides, StreamArrays::ProfileVertices,
      StreamArrays::ProfileTriangles, StreamArrays::ProfileComponents, StreamArrays::ProfileTunnels,
      StreamArrays::ProfileVoids, StreamArrays::ProfileVolume, StreamArrays::ProfilePriority })
  {
    const int which = bytes.Below(3);
    const vtkIdType fitting[] = { grid->GetNumberOfPoints(), grid->GetNumberOfCells(), 2 };
    auto array =
      MakeArray<vtkDoubleArray>(name, bytes.Below(8) > 0 ? fitting[which] : bytes.Below(16));
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      array->SetValue(i, DrawValue(bytes));
    }
    GetData(grid, which)->AddArray(array);
  }
}
