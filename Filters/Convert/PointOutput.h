// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From points of the core to points of a data object, with the point data of the input.
 */
#ifndef PointOutput_h
#define PointOutput_h

#include "Core/Mesh/Mesh.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"

class vtkPointSet;
class vtkPolyData;

/**
 * Adds the arrays of ids, which VTK omits when it interpolates, as plain arrays, since several
 * parts of a cell can have the same id. `source(i)` is the index in the input of entry i, or -1;
 * then the id is -1.
 */
template <class Source>
void AddIdArrays(
  vtkDataSetAttributes* input, vtkIdType count, const Source& source, vtkDataSetAttributes* output)
{
  for (int k = 0; k < input->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* from = input->GetAbstractArray(k);
    if (!from->GetName() || output->HasArray(from->GetName()))
    {
      continue;
    }
    vtkSmartPointer<vtkAbstractArray> to;
    to.TakeReference(from->NewInstance());
    to->SetName(from->GetName());
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->SetNumberOfTuples(count);
    if (auto* numbers = vtkDataArray::SafeDownCast(to))
    {
      numbers->Fill(-1.0);
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (source(i) >= 0)
      {
        to->SetTuple(i, source(i), from);
      }
    }
    output->AddArray(to);
  }
}

/**
 * Sets the points of `output` and their data: those of the source for points of the input, and data
 * interpolated at the closest point of the input for all others.
 */
template <int D>
void FillPoints(const carving::ResolvedInput<D>& points, vtkPolyData* input, vtkPointSet* output);

#endif
