// SPDX-License-Identifier: BSD-3-Clause
#include "CarverNotes.h"

#include "ArrayTools.h"
#include "StreamOutput.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <sstream>

namespace
{

/** How the mesh has been tetrahedralized, if not at the first attempt. */
void AddAttempts(const carving::Reply& reply, std::vector<std::string>& texts)
{
  std::istringstream attempts(reply.Attempts);
  for (std::string line; std::getline(attempts, line);)
  {
    texts.push_back("An attempt failed. " + line);
  }
  const auto kept = std::count(reply.Result.Kept.begin(), reply.Result.Kept.end(), 1);
  if (!reply.Result.Kept.empty())
  {
    std::ostringstream text;
    text << "The mesh is enclosed, not met: " << kept
         << " tetrahedra that it pierces stay, the longest "
         << "of them " << reply.LongestKeptEdge << " long, and no level comes closer there.";
    texts.push_back(text.str());
  }
}

} // namespace

void AddNotes(std::vector<std::string> texts, const carving::Reply& reply, int guessedRegions,
  bool nothingToCarve, vtkFieldData* fieldData)
{
  if (reply.IntersectingPairs > 0)
  {
    texts.push_back(std::to_string(reply.IntersectingPairs) +
      " pairs of triangles or edges cross each other and were split where they meet.");
  }
  AddAttempts(reply, texts);
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

void AddSettings(const CarverSettings& settings, const std::string& rung, vtkFieldData* fieldData)
{
  const carving::CarveOptions& carve = settings.Carve;
  AddFieldValue<vtkStringArray>(fieldData, StreamArrays::Rung, rung.c_str());
  AddFieldValue<vtkIntArray>(fieldData, "InitialApproximation", static_cast<int>(settings.Initial));
  AddFieldValue<vtkIntArray>(fieldData, "Conformity", static_cast<int>(settings.Conformity));
  AddFieldValue<vtkIntArray>(fieldData, "SolidRule", static_cast<int>(settings.Solid));
  AddFieldValue<vtkDoubleArray>(fieldData, "DepthExponent", carve.DepthExponent);
  AddFieldValue<vtkIntArray>(fieldData, "DepthMeasure", settings.DepthIsDistance);
  AddFieldValue<vtkDoubleArray>(fieldData, "BreadthRadius", carve.BreadthRadius);
  AddFieldValue<vtkIntArray>(fieldData, "CarveExposed", carve.CarveExposed);
  AddFieldValue<vtkIntArray>(fieldData, "CarveVoids", carve.CarveVoids);
}
