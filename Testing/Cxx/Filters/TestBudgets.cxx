// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Budgets of components, tunnels and voids as properties of the filter.
 */
#include "FilterTesting.h"
#include "RandomModels.h"

#include "vtkExtractCarvedLOD.h"
#include "vtkFeatureEdges.h"
#include "vtkIdList.h"
#include "vtkPolyDataConnectivityFilter.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace
{

vtkSmartPointer<vtkPolyData> Torus()
{
  return ToPolyData(models::Torus(1.0, 0.4, 24, 12));
}

/** V - E + F of a surface; 2 for a sphere, 0 for a torus. */
vtkIdType EulerCharacteristic(vtkPolyData* surface)
{
  std::set<vtkIdType> vertices;
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  vtkNew<vtkIdList> corners;
  for (vtkIdType face = 0; face < surface->GetNumberOfCells(); ++face)
  {
    surface->GetCellPoints(face, corners);
    for (int i = 0; i < 3; ++i)
    {
      vertices.insert(corners->GetId(i));
      edges.insert(std::minmax({ corners->GetId(i), corners->GetId((i + 1) % 3) }));
    }
  }
  return static_cast<vtkIdType>(vertices.size()) - static_cast<vtkIdType>(edges.size()) +
    surface->GetNumberOfCells();
}

/** Edges that do not have exactly two triangles. */
vtkIdType CountOpenEdges(vtkPolyData* surface)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

int CountComponents(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataConnectivityFilter> components;
  components->SetInputData(surface);
  components->SetExtractionModeToAllRegions();
  components->Update();
  return components->GetNumberOfExtractedRegions();
}

} // namespace

// Without a budget of tunnels, the last level of a torus is a sphere around it, and a note says so.
TEST(Budgets, CloseATorus)
{
  const auto carver = Carve(Torus());
  EXPECT_EQ(EulerCharacteristic(LastLevel(carver)), 0);
  EXPECT_EQ(GetNotes(carver), "");
  carver->SetMaximumTunnels(0);
  carver->Update();
  EXPECT_EQ(EulerCharacteristic(LastLevel(carver)), 2);
  EXPECT_EQ(CountComponents(LastLevel(carver)), 1);
  EXPECT_TRUE(Has(GetNotes(carver), "The budget"));
  carver->SetMaximumTunnels(1);
  carver->Update();
  EXPECT_EQ(EulerCharacteristic(LastLevel(carver)), 0);
  EXPECT_EQ(GetNotes(carver), "");
}

// With a budget of one component, two boxes stay joined; without a budget of voids, a hollow stays
// filled.
TEST(Budgets, KeepPiecesTogetherAndHollowsFilled)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetMaximumComponents(1);
  Carve(carver, TwoBoxes());
  EXPECT_EQ(CountComponents(LastLevel(carver)), 1);
  carver->SetMaximumComponents(-1);
  carver->Update();
  EXPECT_EQ(CountComponents(LastLevel(carver)), 2);
  carver->SetMaximumVoids(0);
  Carve(carver,
    ToPolyData(models::Joined(models::Box({ 0, 0, 0 }, { 3, 3, 3 }),
      models::Flipped(models::Box({ 1, 1, 1 }, { 2, 2, 2 })))));
  EXPECT_EQ(LastLevel(carver)->GetNumberOfPolys(), 12);
  // There are tetrahedra to carve, but not within the budget.
  EXPECT_TRUE(Has(GetNotes(carver), "The budget"));
  EXPECT_FALSE(Has(GetNotes(carver), "nothing to carve"));
  carver->SetMaximumVoids(1);
  carver->Update();
  EXPECT_EQ(LastLevel(carver)->GetNumberOfPolys(), 24);
}

// With budgets of 1, 0 and 0, each component of every level is a sphere, around sheets, too, unless
// these show one side.
TEST(Budgets, GiveClosedSurfacesAroundSheets)
{
  std::mt19937_64 random(3);
  const models::TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  const models::TriangleMesh fin = models::Moved(models::Sheet(2), { 0.5, 0.5, 0.5 });
  std::vector<vtkSmartPointer<vtkPolyData>> meshes = { ToPolyData(models::Joined(box, fin)),
    ToPolyData(models::Joined(box, models::Moved(fin, { 2, 0, 0 }))) };
  for (int i = 0; i < 20; ++i)
  {
    meshes.push_back(ToPolyData(models::GridSoup(3 + i, random)));
    meshes.push_back(ToPolyData(models::Joined(box, models::Soup(1 + i / 4, random))));
  }
  int open = 0;
  for (const auto& mesh : meshes)
  {
    vtkNew<vtkTopologyCarver> carver;
    Messages messages(carver);
    carver->SetInputData(mesh);
    carver->SetInitialApproximation(vtkTopologyCarver::BOUNDING_BOX); // for flat soups
    carver->SetMaximumComponents(1);
    carver->SetMaximumTunnels(0);
    carver->SetMaximumVoids(0);
    carver->SetNumberOfLevels(3);
    carver->Update();
    ASSERT_TRUE(messages.Errors.empty());
    for (int level = 0; level < CountLevels(carver); ++level)
    {
      EXPECT_EQ(CountOpenEdges(GetLevel(carver, level)), 0);
      EXPECT_EQ(
        EulerCharacteristic(GetLevel(carver, level)), 2 * CountComponents(GetLevel(carver, level)));
    }
    carver->SetKeepBothFoldSides(vtkTopologyCarver::ONE_SIDE);
    carver->Update();
    open += CountOpenEdges(LastLevel(carver)) > 0;
  }
  EXPECT_GT(open, 10);
}

// The stored stream of a carving with budgets gives the same last level, and its field data have
// the budgets.
TEST(Budgets, AreInTheStoredStream)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetMaximumComponents(1);
  carver->SetMaximumTunnels(0);
  carver->SetMaximumVoids(0);
  Carve(carver, Torus());
  vtkUnstructuredGrid* stream = GetStream(carver);
  for (const auto& [name, value] : { std::pair("MaximumComponents", 1),
         std::pair("MaximumTunnels", 0), std::pair("MaximumVoids", 0) })
  {
    EXPECT_EQ(GetFieldValue(stream, name), value);
  }
  vtkNew<vtkExtractCarvedLOD> extract;
  extract->SetInputData(stream);
  extract->SetLevelTarget(1e9);
  extract->Update();
  ExpectEqualData(extract->GetOutput(), LastLevel(carver));
}

// Budgets below -1 become -1.
TEST(Budgets, AreMinusOneOrMore)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetMaximumComponents(-5);
  carver->SetMaximumTunnels(-2);
  carver->SetMaximumVoids(-7);
  EXPECT_EQ(carver->GetMaximumComponents(), -1);
  EXPECT_EQ(carver->GetMaximumTunnels(), -1);
  EXPECT_EQ(carver->GetMaximumVoids(), -1);
}
