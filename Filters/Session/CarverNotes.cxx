// SPDX-License-Identifier: BSD-3-Clause
#include "Session/CarverNotes.h"

#include "Convert/ArrayNames.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <sstream>

namespace
{

/** Adds a note for each line of a text. */
void AddLines(const std::string& before, const std::string& lines, const std::string& after,
  std::vector<std::string>& notes)
{
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);)
  {
    notes.push_back(before + line + after);
  }
}

} // namespace

void DescribeDecomposition(
  const carving::Reply& reply, int dimension, std::vector<std::string>& notes)
{
  if (reply.IntersectingPairs > 0)
  {
    const std::string number = std::to_string(reply.IntersectingPairs);
    notes.push_back(dimension == 3
        ? number + " pairs of triangles cross each other and were split where they meet."
        : "Edges cross or touch others in " + number + " points and were split there.");
  }
  AddLines("An attempt failed. ", reply.Attempts, "", notes);
  AddLines("The result depends on a limit: ", reply.Limits,
    ". With a higher limit, the result might differ.", notes);
  if (reply.InteriorDropped > 0)
  {
    notes.push_back(std::to_string(reply.InteriorDropped) +
      " triangles inside the solid were left out. No level would show them.");
  }
  if (reply.CracksSealed > 0)
  {
    notes.push_back("The mesh has cracks narrower than a millionth of its diagonal: " +
      std::to_string(reply.CracksSealed) + " triangles were added to close its solid.");
  }
  if (reply.CracksOpen != 0)
  {
    notes.push_back(
      "The mesh has cracks that cannot be closed, so that levels may show the inside of its "
      "solid. A SnapTolerance of 1e-6 mostly joins the sides of such cracks.");
  }
  if (reply.SnapDistance > 0.0)
  {
    std::ostringstream text;
    text
      << "The mesh was snapped: points were moved, or flat parts got other triangles, by at most "
      << reply.SnapDistance << ". Levels enclose the snapped mesh.";
    notes.push_back(text.str());
  }
  const carving::Tetrahedralization& result = reply.Result;
  const auto kept = std::count(result.Kept.begin(), result.Kept.end(), 1);
  const std::string added = std::to_string(reply.PointsAdded) + " vertices were added to the " +
    std::to_string(result.Unresolved.Points.size()) + " of the mesh" +
    (reply.IntersectingPairs > 0 ? " and its crossings." : ".");
  if (kept == 0 && reply.MetShare < 1.0)
  {
    std::ostringstream text;
    text << "The mesh is only enclosed: " << 100.0 * reply.MetShare
         << " % of its area is met. Its other triangles lie on faces with other edges, which may "
            "reach beyond them. "
         << added;
    notes.push_back(text.str());
  }
  if (kept > 0)
  {
    std::ostringstream text;
    text << "The mesh is only enclosed: " << 100.0 * reply.MetShare << " % of its area is met. "
         << kept << " tetrahedra that it pierces are not carved and reach " << reply.KeptDistance
         << " from it; 99 % of their surface is within " << reply.KeptDistance99 << ", the mean is "
         << reply.KeptDistanceMean << ". To keep them small, " << added;
    notes.push_back(text.str());
  }
}

void WriteNotes(const std::vector<std::string>& notes, vtkFieldData* fieldData)
{
  if (notes.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> array;
  array->SetName(NotesArray);
  for (const std::string& note : notes)
  {
    array->InsertNextValue(note);
  }
  fieldData->AddArray(array);
}
