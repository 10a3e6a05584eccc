// SPDX-License-Identifier: BSD-3-Clause
#include "Objects/LevelCollection.h"

#include "vtkConvertToPartitionedDataSetCollection.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"

void CopyLevels(vtkMultiBlockDataSet* from, vtkPartitionedDataSetCollection* to)
{
  vtkNew<vtkConvertToPartitionedDataSetCollection> convert;
  convert->SetInputDataObject(from);
  convert->Update();
  to->ShallowCopy(convert->GetOutput());
  to->GetFieldData()->ShallowCopy(from->GetFieldData());
}
