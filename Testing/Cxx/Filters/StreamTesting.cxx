// SPDX-License-Identifier: BSD-3-Clause
#include "StreamTesting.h"

#include "ContourTesting.h"
#include "Convert/ArrayTools.h"

#include "vtkDoubleArray.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

vtkSmartPointer<vtkUnstructuredGrid> MakeStream(bool plane)
{
  vtkSmartPointer<vtkCarverAlgorithm> carver;
  vtkSmartPointer<vtkPolyData> mesh;
  if (plane)
  {
    carver = vtkSmartPointer<vtkContourCarver>::New();
    mesh = MakePolygons({ LetterU(), Rectangle(5, 0, 6, 2) });
  }
  else
  {
    carver = vtkSmartPointer<vtkTopologyCarver>::New();
    mesh = TwoBoxes();
  }
  carver->SetInputData(mesh);
  carver->SetComputeError(true);
  carver->Update();
  auto stream = vtkSmartPointer<vtkUnstructuredGrid>::New();
  stream->DeepCopy(carver->GetOutputDataObject(1));
  AddFieldValue<vtkDoubleArray>(stream->GetFieldData(), "KeptDistance", 0.0);
  AddFieldValue<vtkDoubleArray>(stream->GetFieldData(), "KeptDistance99", 0.0);
  AddFieldValue<vtkDoubleArray>(stream->GetFieldData(), "KeptDistanceMean", 0.0);
  AddFieldValue<vtkDoubleArray>(stream->GetFieldData(), "MetShare", 1.0);
  AddFieldValue<vtkDoubleArray>(stream->GetFieldData(), "SnapDistance", 0.0);
  auto moved = MakeArray<vtkDoubleArray>("SnapDistance", stream->GetNumberOfPoints());
  moved->Fill(0.0);
  stream->GetPointData()->AddArray(moved);
  return stream;
}

std::string ErrorOf(vtkUnstructuredGrid* stream)
{
  vtkNew<vtkExtractCarvedLOD> extract;
  Messages messages(extract);
  extract->SetInputData(stream);
  for (int type = vtkExtractCarvedLOD::VERTICES; type <= vtkExtractCarvedLOD::STEP; ++type)
  {
    double range[2];
    extract->GetLevelTargetRange(type, range);
    extract->SetLevelTargetType(type);
    for (const double target : { range[0], range[1], 1e300 })
    {
      extract->SetLevelTarget(target);
      extract->SetManifoldOutput(!extract->GetManifoldOutput());
      extract->Update();
    }
  }
  EXPECT_TRUE(messages.Errors.empty() || extract->GetOutput()->GetNumberOfCells() == 0);
  for (const std::string& error : messages.Errors)
  {
    EXPECT_EQ(error.substr(error.find("The input")),
      messages.Errors[0].substr(messages.Errors[0].find("The input")));
  }
  return messages.Errors.empty() ? "" : messages.Errors[0];
}

void ExpectError(vtkUnstructuredGrid* stream, const std::string& text)
{
  const std::string error = ErrorOf(stream);
  EXPECT_NE(error.find("The input is not the stored stream of a carving: "), std::string::npos)
    << text;
  EXPECT_NE(error.find(text), std::string::npos) << text << "\nis not in: " << error;
}
