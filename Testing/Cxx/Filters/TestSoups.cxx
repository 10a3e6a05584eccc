// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "Core/Mesh/Vector.h"
#include "FilterTesting.h"
#include "RandomModels.h"

#include "vtkExtractCarvedLOD.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

using namespace carving;

namespace
{

TriangleMesh DrawSoup(std::mt19937_64& random)
{
  const int n = static_cast<int>(random() % 30);
  switch (random() % 5)
  {
    case 0:
      return models::Soup(1 + n, random);
    case 1:
      return models::GridSoup(1 + n, random);
    case 2:
      return models::BoxSoup(1 + n / 6, random);
    case 3:
      return models::Joined(models::GridSoup(n / 2, random), models::BoxSoup(1 + n / 10, random));
    default:
      return models::MakeRandom(random).Mesh;
  }
}

void DrawSettings(std::mt19937_64& random, vtkTopologyCarver* carver)
{
  const auto below = [&](int end) { return static_cast<int>(random() % end); };
  carver->SetConformity(below(3));
  carver->SetInitialApproximation(below(2)); // not CUSTOM
  carver->SetSolidRule(below(3));
  carver->SetPriorityMeasure(below(6));
  carver->SetDepthMeasure(below(2));
  carver->SetDepthExponent(below(3));
  carver->SetBreadthRadius(below(2) * 0.5);
  carver->SetCarveExposed(below(2) != 0);
  carver->SetCarveVoids(below(2) != 0);
  carver->SetManifoldOutput(below(2) != 0);
  carver->SetAppendInput(below(2) != 0);
  carver->SetEnclosingTolerance(0.01 * (1 + below(10)));
  carver->SetReuseDecomposition(below(2) != 0);
  carver->SetNumberOfLevels(4);
  // Both sides of a fold cancel in the sums below, so that folds bound no volume.
  carver->KeepBothFoldSidesOn();
}

/** A level with equal points merged. */
struct Surface
{
  std::vector<Point> Points;
  std::vector<Triangle> All;   ///< each triangle once
  std::vector<Triangle> Shell; ///< without folds
};

Surface Merge(vtkPolyData* level)
{
  Surface surface;
  std::map<Point, int> places;
  std::map<Triangle, std::vector<Triangle>> copies;
  for (const auto& corners : GetTriangles(level))
  {
    Triangle triangle;
    for (int i = 0; i < 3; ++i)
    {
      triangle[i] = places.emplace(corners[i], static_cast<int>(places.size())).first->second;
    }
    Triangle sorted = triangle;
    std::sort(sorted.begin(), sorted.end());
    copies[sorted].push_back(triangle);
  }
  surface.Points.resize(places.size());
  for (const auto& [point, place] : places)
  {
    surface.Points[place] = point;
  }
  for (const auto& [sorted, triangles] : copies)
  {
    surface.All.push_back(triangles.front());
    if (triangles.size() % 2 != 0)
    {
      surface.Shell.push_back(triangles.front());
    }
  }
  return surface;
}

/** The corners of all triangles with an area, once each, and a point within each triangle. */
struct Probes
{
  std::vector<Point> Corners;
  std::vector<Point> Middles;
};

Probes GetProbes(const TriangleMesh& mesh)
{
  Probes probes;
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    const Point &p = mesh.Points[a], &q = mesh.Points[b], &r = mesh.Points[c];
    if (Length(Cross(q - p, r - p)) > 0.0)
    {
      probes.Corners.insert(probes.Corners.end(), { p, q, r });
      probes.Middles.push_back((p + q + r) / 3.0);
    }
  }
  std::sort(probes.Corners.begin(), probes.Corners.end());
  probes.Corners.erase(
    std::unique(probes.Corners.begin(), probes.Corners.end()), probes.Corners.end());
  return probes;
}

/** Whether a point is in the plane of a triangle, up to rounding. */
bool IsInAPlane(const Surface& surface, const Point& p)
{
  return std::any_of(surface.All.begin(), surface.All.end(),
    [&](const Triangle& t)
    {
      const Point &a = surface.Points[t[0]], &b = surface.Points[t[1]], &c = surface.Points[t[2]];
      const Point normal = Cross(b - a, c - a);
      return std::abs(Dot(normal, p - a)) < 1e-12 * Length(normal);
    });
}

std::string ToText(const Point& p)
{
  return std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]);
}

/**
 * Expects that every level encloses the soup, does not cross itself, and is no larger than the one
 * before.
 */
void CheckLevel(vtkPolyData* level, const Probes& probes, double& volume)
{
  const Surface surface = Merge(level);
  EXPECT_EQ(checks::CountCrossings(surface.Points, surface.All), 0);
  for (const Point& corner : probes.Corners)
  {
    EXPECT_TRUE(
      std::find(surface.Points.begin(), surface.Points.end(), corner) != surface.Points.end() ||
      checks::Encloses(surface.Points, surface.Shell, corner))
      << ToText(corner);
  }
  for (const Point& middle : probes.Middles)
  {
    EXPECT_TRUE(
      checks::Encloses(surface.Points, surface.Shell, middle) || IsInAPlane(surface, middle))
      << ToText(middle);
  }
  const double newVolume = checks::SixVolume(surface.Points, surface.Shell);
  EXPECT_LE(newVolume, volume * (1.0 + 1e-9) + 1e-9);
  volume = newVolume;
}

std::string GetKind(vtkPolyData* level)
{
  return vtkStringArray::SafeDownCast(level->GetFieldData()->GetAbstractArray("Kind"))->GetValue(0);
}

/** Whether the filter may refuse a soup: without volume, or, in exact mode, too hard for TetGen. */
bool MayFail(const std::string& error, int conformity)
{
  const auto has = [&](const char* words) { return error.find(words) != std::string::npos; };
  return has("All points lie in one plane") || has("No triangle of the mesh has an area") ||
    (conformity == vtkTopologyCarver::EXACT && has("TetGen cannot tetrahedralize the mesh"));
}

} // namespace

// With any settings, a soup gives a justified error, or levels that enclose it, do not cross
// themselves, shrink, and equal those of its stream.
TEST(Soups, AreEnclosedWithAnySettings)
{
  std::mt19937_64 random(9);
  int carved = 0;
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_FILTER_SOUPS", 200);
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("soup " + std::to_string(i));
    const TriangleMesh soup = DrawSoup(random);
    vtkNew<vtkTopologyCarver> carver;
    DrawSettings(random, carver);
    Messages messages(carver);
    Carve(carver, ToPolyData(soup));
    if (!messages.Errors.empty())
    {
      EXPECT_TRUE(MayFail(messages.Errors[0], carver->GetConformity())) << messages.Errors[0];
      EXPECT_EQ(CountLevels(carver), 0);
      continue;
    }
    ++carved;
    vtkNew<vtkExtractCarvedLOD> extract;
    extract->SetInputDataObject(0, carver->GetOutputDataObject(1));
    extract->SetLevelTargetType(vtkExtractCarvedLOD::STEP);
    extract->SetManifoldOutput(carver->GetManifoldOutput());
    const Probes probes = GetProbes(soup);
    double volume = HUGE_VAL;
    ASSERT_GT(CountLevels(carver), 0);
    for (int l = 0; l < CountLevels(carver); ++l)
    {
      vtkPolyData* level = GetLevel(carver, l);
      if (GetKind(level) == "input")
      {
        continue;
      }
      CheckLevel(level, probes, volume);
      extract->SetLevelTarget(GetLevelStep(carver, l));
      extract->Update();
      ExpectEqualData(extract->GetOutput(), level);
    }
  }
  EXPECT_GT(carved, count / 2);
}
