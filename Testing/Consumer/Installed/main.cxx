// SPDX-License-Identifier: BSD-3-Clause
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkSphereSource.h>
#include <vtkTopologyCarver.h>

int main()
{
  vtkNew<vtkSphereSource> bowl;
  bowl->SetEndPhi(120);
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputConnection(bowl->GetOutputPort());
  carver->Update();
  return carver->GetOutput()->GetNumberOfBlocks() == 8 ? 0 : 1;
}
