// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The results that a filter keeps between updates, and when the helper program must run again.
 */
#include "CrackedModels.h"
#include "FilterTesting.h"
#include "RandomModels.h"

#include "vtkCellArray.h"
#include "vtkContourCarver.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace
{

/** Two boxes, one mesh each, that share their points; the points are the newest part of both. */
std::array<vtkSmartPointer<vtkPolyData>, 2> BoxesThatShareTheirPoints()
{
  auto first = TwoBoxes(), second = TwoBoxes();
  vtkNew<vtkCellArray> polys[2];
  for (vtkIdType i = 0; i < first->GetNumberOfPolys(); ++i)
  {
    vtkIdType size;
    const vtkIdType* corners;
    first->GetPolys()->GetCellAtId(i, size, corners);
    polys[i < 12 ? 0 : 1]->InsertNextCell(size, corners);
  }
  first->SetPolys(polys[0]);
  second->SetPolys(polys[1]);
  second->SetPoints(first->GetPoints());
  first->GetPoints()->Modified();
  EXPECT_EQ(first->GetMTime(), second->GetMTime());
  return { first, second };
}

using Setter = std::function<void(vtkTopologyCarver*)>;

/** Whether the helper program runs again when a property changes between two updates. */
bool RunsAgain(vtkPolyData* mesh, const Setter& before, const Setter& change)
{
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInputData(mesh);
  carver->SetNumberOfLevels(1);
  before(carver);
  carver->Update();
  EXPECT_TRUE(messages.Errors.empty());
  const OtherHelper missing("/there/is/no/such/helper");
  change(carver);
  carver->Update();
  return !messages.Errors.empty();
}

void Nothing(vtkTopologyCarver*)
{
}

/** A soup that TetGen cannot tetrahedralize, so that AUTO encloses it. */
vtkSmartPointer<vtkPolyData> Soup()
{
  std::mt19937_64 random(1);
  return ToPolyData(models::Soup(60, random));
}

} // namespace

// Two blocks that share their points are told apart.
TEST(Reuse, TellsBlocksApartThatShareTheirPoints)
{
  const auto boxes = BoxesThatShareTheirPoints();
  vtkNew<vtkMultiBlockDataSet> scene;
  scene->SetBlock(0, boxes[0]);
  scene->SetBlock(1, boxes[1]);
  const auto carver = Carve(scene);
  for (unsigned int block = 0; block < 2; ++block)
  {
    auto* levels = vtkMultiBlockDataSet::SafeDownCast(carver->GetOutput()->GetBlock(block));
    auto* level = vtkPolyData::SafeDownCast(levels->GetBlock(0));
    EXPECT_EQ(level->GetBounds()[0], block == 0 ? 0.0 : 2.0);
  }
}

// Another input mesh is carved anew even if it has the same time stamp.
TEST(Reuse, TellsInputsApartThatShareTheirPoints)
{
  const auto boxes = BoxesThatShareTheirPoints();
  vtkNew<vtkTopologyCarver> carver;
  for (int i = 0; i < 2; ++i)
  {
    Carve(carver, boxes[i]);
    EXPECT_EQ(GetLevel(carver, 0)->GetBounds()[0], 2.0 * i);
  }
}

// Another initial approximation is used even if it has the same time stamp.
TEST(Reuse, TellsInitialApproximationsApartThatShareTheirPoints)
{
  const carving::TriangleMesh both = models::Joined(
    models::Box({ -1, -1, -1 }, { 2, 2, 2 }), models::Box({ -3, -3, -3 }, { 4, 4, 4 }));
  carving::TriangleMesh near = both, far = both;
  near.Triangles.resize(12);
  far.Triangles.erase(far.Triangles.begin(), far.Triangles.begin() + 12);
  auto initial = ToPolyData(near), other = ToPolyData(far);
  other->SetPoints(initial->GetPoints());
  initial->GetPoints()->Modified();
  ASSERT_EQ(initial->GetMTime(), other->GetMTime());
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(0, ToPolyData(models::Box({ 0, 0, 0 }, { 1, 1, 1 })));
  carver->SetInitialApproximation(vtkTopologyCarver::CUSTOM);
  carver->SetNumberOfLevels(2);
  carver->SetInputData(1, initial);
  carver->Update();
  EXPECT_EQ(GetLevel(carver, 0)->GetBounds()[0], -1.0);
  carver->SetInputData(1, other);
  carver->Update();
  EXPECT_EQ(GetLevel(carver, 0)->GetBounds()[0], -3.0);
}

// If the first attempt succeeded, a change that cannot affect it does not run the helper program
// again.
TEST(Reuse, KeepsAMeshThatWasMetAtOnce)
{
  const std::pair<const char*, Setter> changes[] = {
    { "EnclosingTolerance", [](auto* c) { c->SetEnclosingTolerance(0.1); } },
    { "SnapTolerance", [](auto* c) { c->SetSnapTolerance(1e-6); } },
    { "Conformity", [](auto* c) { c->SetConformity(c->EXACT); } },
    { "SolidRule", [](auto* c) { c->SetSolidRule(c->EVEN_ODD); } },
    { "AppendInput", [](auto* c) { c->AppendInputOn(); } },
    { "PriorityMeasure", [](auto* c) { c->SetPriorityMeasure(c->VOLUME); } },
    { "DepthMeasure", [](auto* c) { c->SetDepthMeasure(c->DISTANCE); } },
    { "MaximumComponents", [](auto* c) { c->SetMaximumComponents(1); } },
    { "KeepBothFoldSides", [](auto* c) { c->KeepBothFoldSidesOn(); } },
    { "ComputeError", [](auto* c) { c->ComputeErrorOn(); } },
    { "LevelTarget", [](auto* c) { c->AddLevelTarget(16); } },
  };
  for (const auto& [name, change] : changes)
  {
    EXPECT_FALSE(RunsAgain(TwoBoxes(), Nothing, change)) << name;
  }
}

// If no attempt failed, a raised limit does not run the helper program again.
TEST(Reuse, KeepsAMeshWhenALimitIsRaised)
{
  const Setter limit = [](auto* c)
  {
    c->SetTimeLimit(100.0);
    c->SetMemoryLimit(1e8); // enough for the shadow memory of sanitizers, too
  };
  EXPECT_FALSE(RunsAgain(TwoBoxes(), limit, [](auto* c) { c->SetTimeLimit(200.0); }));
  EXPECT_FALSE(RunsAgain(TwoBoxes(), limit, [](auto* c) { c->SetMemoryLimit(2e8); }));
  EXPECT_FALSE(RunsAgain(TwoBoxes(), limit, [](auto* c) { c->SetMemoryLimit(0.0); }));
}

// A change that could affect the result runs the helper program again.
TEST(Reuse, TetrahedralizesAgainWhereTheResultCouldDiffer)
{
  const std::pair<const char*, Setter> changes[] = {
    { "InitialApproximation", [](auto* c) { c->SetInitialApproximation(c->BOUNDING_BOX); } },
    { "Conformity", [](auto* c) { c->SetConformity(c->ENCLOSING); } },
    { "a lower TimeLimit", [](auto* c) { c->SetTimeLimit(1.0); } },
    { "a lower MemoryLimit", [](auto* c) { c->SetMemoryLimit(500.0); } },
  };
  for (const auto& [name, change] : changes)
  {
    EXPECT_TRUE(RunsAgain(TwoBoxes(), Nothing, change)) << name;
  }
}

// For a mesh that is only enclosed, a change of the tolerances or of the attempts runs the helper
// program again.
TEST(Reuse, TetrahedralizesAnEnclosedMeshAgain)
{
  const Setter enclosing = [](auto* c) { c->SetConformity(c->ENCLOSING); };
  const auto soup = Soup();
  EXPECT_TRUE(RunsAgain(soup, enclosing, [](auto* c) { c->SetEnclosingTolerance(0.1); }));
  EXPECT_TRUE(RunsAgain(soup, enclosing, [](auto* c) { c->SetConformity(c->AUTO); }));
  EXPECT_TRUE(RunsAgain(soup, enclosing, [](auto* c) { c->SetSnapTolerance(1e-6); }));
  EXPECT_FALSE(RunsAgain(soup, enclosing, [](auto* c) { c->SetSolidRule(c->EVEN_ODD); }));
}

// AUTO snaps a mesh on which too many triangles cross each other, EXACT resolves it.
TEST(Reuse, TetrahedralizesASnappedMeshAgain)
{
  const carving::TriangleMesh box = models::PatchedBox({ 1, 1, 1 }, { 20, 20, 20, 20, 20, 20 });
  const auto twoBoxes = ToPolyData(models::Joined(box, models::Moved(box, { 3e-13, 0, 0 })));
  vtkNew<vtkTopologyCarver> carver;
  Carve(carver, twoBoxes);
  ASSERT_TRUE(LastLevel(carver)->GetFieldData()->HasArray("SnapDistance"));
  carver->SetConformity(vtkTopologyCarver::EXACT);
  carver->Update();
  EXPECT_FALSE(LastLevel(carver)->GetFieldData()->HasArray("SnapDistance"));
}

// Facets and points that close the solid across cracks are not left where another rule has no
// solid, and come back with the solid.
TEST(Reuse, DropsSealsWithTheSolid)
{
  std::mt19937_64 random(2);
  const auto box = ToPolyData(models::InSinglePrecision(
    models::Rotated(models::PatchedBox({ 3, 2, 1 }, { 3, 1, 1, 1, 1, 1 }), random)));
  const auto torus = ToPolyData(models::TorusInTwoParts(1e-7, 0.1, random));
  const int rules[] = { vtkTopologyCarver::SURFACE_ONLY, vtkTopologyCarver::NONZERO_WINDING,
    vtkTopologyCarver::SURFACE_ONLY, vtkTopologyCarver::EVEN_ODD };
  for (const auto& mesh : { box, torus })
  {
    vtkNew<vtkTopologyCarver> carver;
    carver->SetInputData(mesh);
    for (const int rule : rules)
    {
      vtkNew<vtkTopologyCarver> fresh;
      fresh->SetInputData(mesh);
      for (vtkTopologyCarver* each : { carver.Get(), fresh.Get() })
      {
        each->SetSolidRule(rule);
        each->Update();
      }
      for (int port = 0; port < 3; ++port)
      {
        ExpectEqualData(fresh->GetOutputDataObject(port), carver->GetOutputDataObject(port));
      }
    }
  }
}

// Without reuse, every update runs the helper program, and the outputs are the same: for a mesh
// that is met and one that is enclosed, with a budget, and for one that is in a scene twice.
TEST(Reuse, GivesTheSameWithout)
{
  vtkNew<vtkMultiBlockDataSet> twice;
  const auto boxes = TwoBoxes();
  twice->SetBlock(0, boxes);
  twice->SetBlock(1, boxes);
  const std::pair<vtkSmartPointer<vtkDataObject>, Setter> cases[] = {
    { ToPolyData(models::Torus(2.0, 0.8, 12, 8)), Nothing },
    { ToPolyData(models::Torus(2.0, 0.8, 12, 8)), [](auto* c) { c->SetMaximumTunnels(0); } },
    { ToPolyData(models::Torus(2.0, 0.8, 12, 8)),
      [](auto* c) { c->SetSolidRule(c->SURFACE_ONLY); } },
    { boxes, [](auto* c) { c->SetDepthMeasure(c->DISTANCE); } },
    { ToPolyData(models::Torus(2.0, 0.8, 12, 8)),
      [](auto* c) { c->SetDepthMeasure(c->DISTANCE); } },
    { Soup(), Nothing },
    { twice.Get(), Nothing },
  };
  for (const auto& [input, set] : cases)
  {
    vtkNew<vtkTopologyCarver> with, without;
    without->ReuseDecompositionOff();
    for (vtkTopologyCarver* carver : { with.Get(), without.Get() })
    {
      set(carver);
      Carve(carver, input);
    }
    for (int port = 0; port < 3; ++port)
    {
      ExpectEqualData(without->GetOutputDataObject(port), with->GetOutputDataObject(port));
    }
  }
  const Setter off = [](auto* c) { c->ReuseDecompositionOff(); };
  EXPECT_TRUE(RunsAgain(TwoBoxes(), off, [](auto* c) { c->AddLevelTarget(16); }));
  EXPECT_TRUE(RunsAgain(TwoBoxes(), off, [](auto* c) { c->ReuseDecompositionOn(); }));
}

// For contours, only the initial approximation runs the helper program again.
TEST(Reuse, KeepsContours)
{
  vtkNew<vtkContourCarver> carver;
  Messages messages(carver);
  const auto square = ToPolyData(models::Sheet(2));
  Carve(carver, square);
  const OtherHelper missing("/there/is/no/such/helper");
  carver->SetConformity(vtkContourCarver::EXACT);
  carver->SetEnclosingTolerance(0.1);
  carver->SetSnapTolerance(0.1);
  carver->SetTimeLimit(5.0);
  carver->Update();
  EXPECT_TRUE(messages.Errors.empty());
  carver->SetInitialApproximation(vtkContourCarver::BOUNDING_BOX);
  carver->Update();
  EXPECT_FALSE(messages.Errors.empty());
}
