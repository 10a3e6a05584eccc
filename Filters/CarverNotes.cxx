// SPDX-License-Identifier: BSD-3-Clause
#include "CarverNotes.h"

#include "ArrayTools.h"
#include "StreamOutput.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

void AddNotes(std::vector<std::string> texts, int intersectingPairs, int guessedRegions,
  bool nothingToCarve, vtkFieldData* fieldData)
{
  if (intersectingPairs > 0)
  {
    texts.push_back(std::to_string(intersectingPairs) +
      " pairs of triangles or edges cross each other and were split where they meet.");
  }
  if (guessedRegions > 0)
  {
    texts.push_back("The input is open or inconsistently oriented: whether " +
      std::to_string(guessedRegions) + " of its enclosed regions are solid is a guess.");
  }
  if (nothingToCarve)
  {
    texts.push_back("The input is its own initial approximation: there is nothing to carve.");
  }
  if (texts.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> notes;
  notes->SetName("Notes");
  for (const std::string& text : texts)
  {
    notes->InsertNextValue(text);
  }
  fieldData->AddArray(notes);
}

void AddSettings(const CarverSettings& settings, const char* rung, vtkFieldData* fieldData)
{
  const carving::CarveOptions& carve = settings.Carve;
  AddFieldValue<vtkStringArray>(fieldData, StreamArrays::Rung, rung);
  AddFieldValue<vtkIntArray>(fieldData, "InitialApproximation", static_cast<int>(settings.Initial));
  AddFieldValue<vtkIntArray>(fieldData, "SolidRule", static_cast<int>(settings.Solid));
  AddFieldValue<vtkDoubleArray>(fieldData, "DepthExponent", carve.DepthExponent);
  AddFieldValue<vtkIntArray>(fieldData, "DepthMeasure", settings.DepthIsDistance);
  AddFieldValue<vtkDoubleArray>(fieldData, "BreadthRadius", carve.BreadthRadius);
  AddFieldValue<vtkIntArray>(fieldData, "CarveExposed", carve.CarveExposed);
  AddFieldValue<vtkIntArray>(fieldData, "CarveVoids", carve.CarveVoids);
}
