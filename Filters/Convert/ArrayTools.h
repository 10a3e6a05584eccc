// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes named arrays in one line.
 */
#ifndef ArrayTools_h
#define ArrayTools_h

#include "Core/Mesh/LargePages.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>

/** Sets the size of a new array. */
template <class ArrayType>
void SetSize(ArrayType* array, vtkIdType tuples)
{
  array->SetNumberOfTuples(tuples);
  carving::ProvidePages(array->GetVoidPointer(0),
    static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
}

/** Provides the pages of arrays that have been allocated for a number of tuples. */
inline void ProvidePagesOf(vtkFieldData* arrays, vtkIdType tuples)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    if (array && array->HasStandardMemoryLayout())
    {
      carving::ProvidePages(array->GetVoidPointer(0),
        static_cast<std::size_t>(tuples) * array->GetNumberOfComponents() *
          array->GetDataTypeSize());
    }
  }
}

template <class ArrayType>
vtkNew<ArrayType> MakeArray(const char* name, vtkIdType size, int components = 1)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  SetSize<ArrayType>(array, size);
  return array;
}

template <class ArrayType, class Value>
void AddFieldValue(vtkFieldData* fieldData, const char* name, const Value& value)
{
  vtkNew<ArrayType> array = MakeArray<ArrayType>(name, 1);
  array->SetValue(0, value);
  fieldData->AddArray(array);
}

template <class ArrayType, class Values>
void AddFieldArray(vtkFieldData* fieldData, const char* name, const Values& values)
{
  vtkNew<ArrayType> array = MakeArray<ArrayType>(name, static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  fieldData->AddArray(array);
}

#endif
