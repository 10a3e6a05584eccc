// SPDX-License-Identifier: BSD-3-Clause
#include "Session/CarverNotes.h"

#include "Convert/ArrayTools.h"
#include "Convert/StreamOutput.h"
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
  std::istringstream limits(reply.Limits);
  for (std::string line; std::getline(limits, line);)
  {
    texts.push_back("The result depends on a limit: " + line +
      ". With a higher one the mesh might have come out otherwise.");
  }
  if (reply.InteriorDropped > 0)
  {
    texts.push_back("Inside the solid " + std::to_string(reply.InteriorDropped) +
      " triangles were left out, which no level would show.");
  }
  if (reply.SnapDistance > 0.0)
  {
    std::ostringstream text;
    text << "The mesh was snapped: no point was moved farther than " << reply.SnapDistance
         << ". Levels enclose what came of it.";
    texts.push_back(text.str());
  }
  const carving::Tetrahedralization& result = reply.Result;
  if (!result.Kept.empty())
  {
    const auto kept = std::count(result.Kept.begin(), result.Kept.end(), 1);
    std::ostringstream text;
    text << "The mesh is enclosed, not met: " << kept
         << " tetrahedra that it pierces stay and reach " << reply.KeptDistance
         << " from it. For that " << reply.PointsAdded << " vertices were added to its "
         << result.Unresolved.Points.size() << ".";
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

void AddSettings(
  const CarverSettings& settings, const carving::Reply& reply, vtkFieldData* fieldData)
{
  const carving::CarveOptions& carve = settings.Carve;
  AddFieldValue<vtkStringArray>(fieldData, StreamArrays::Strategy, reply.Strategy.c_str());
  if (!reply.Result.Kept.empty())
  {
    AddFieldValue<vtkDoubleArray>(fieldData, StreamArrays::KeptDistance, reply.KeptDistance);
  }
  if (reply.SnapDistance > 0.0)
  {
    AddFieldValue<vtkDoubleArray>(fieldData, StreamArrays::SnapDistance, reply.SnapDistance);
  }
  AddFieldValue<vtkIntArray>(fieldData, "InitialApproximation", static_cast<int>(settings.Initial));
  AddFieldValue<vtkIntArray>(fieldData, "Conformity", static_cast<int>(settings.Conformity));
  AddFieldValue<vtkDoubleArray>(fieldData, "EnclosingTolerance", settings.EnclosingTolerance);
  AddFieldValue<vtkDoubleArray>(fieldData, "SnapTolerance", settings.SnapTolerance);
  AddFieldValue<vtkIntArray>(fieldData, "SolidRule", static_cast<int>(settings.Solid));
  AddFieldValue<vtkDoubleArray>(fieldData, "DepthExponent", carve.DepthExponent);
  AddFieldValue<vtkIntArray>(fieldData, "DepthMeasure", settings.DepthIsDistance);
  AddFieldValue<vtkDoubleArray>(fieldData, "BreadthRadius", carve.BreadthRadius);
  AddFieldValue<vtkIntArray>(fieldData, "CarveExposed", carve.CarveExposed);
  AddFieldValue<vtkIntArray>(fieldData, "CarveVoids", carve.CarveVoids);
  constexpr const char* budgets[] = { "MaximumComponents", "MaximumTunnels", "MaximumVoids" };
  for (std::size_t i = 0; i < carve.Budget.size(); ++i)
  {
    AddFieldValue<vtkIntArray>(fieldData, budgets[i], carve.Budget[i]);
  }
}
