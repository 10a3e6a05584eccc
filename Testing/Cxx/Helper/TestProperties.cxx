// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What must hold for every stream, on random meshes and on real ones.
 */
#include "Carver.h"
#include "Checks.h"
#include "Classification.h"
#include "Components.h"
#include "HelperRun.h"
#include "Level.h"
#include "LevelSelection.h"
#include "ManifoldCheck.h"
#include "OffReader.h"
#include "Profile.h"
#include "RandomModels.h"
#include "Shapes.h"
#include "Vector.h"
#include "Winding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <set>
#include <tuple>

using namespace carving;

namespace
{

struct Carved
{
  Tetrahedralization Mesh;
  Classification Regions;
  carving::Stream Stream;
  StoredStream<3> Stored;
  carving::Profile Profile;
};

Carved CarveResult(const Tetrahedralization& mesh, const CarveOptions& options = {},
  SolidRule rule = SolidRule::NonzeroWinding)
{
  Carved carved = { mesh, Classify(mesh, rule), {}, {}, {} };
  Carve(carved.Mesh, carved.Regions, options, carved.Stream);
  carved.Stored = Store(carved.Mesh, carved.Regions, carved.Stream);
  carved.Profile = ComputeProfile(carved.Stored);
  return carved;
}

/** The part of a level that bounds a volume: all but the folds. */
std::vector<Triangle> Shell(const Level<3>& level)
{
  std::vector<Triangle> shell;
  for (const FaceLife<3>& face : level.Faces)
  {
    if (!face.Fold)
    {
      shell.push_back(face.Corners);
    }
  }
  return shell;
}

std::vector<Triangle> AllTriangles(const Level<3>& level)
{
  std::vector<Triangle> triangles;
  for (const FaceLife<3>& face : level.Faces)
  {
    triangles.push_back(face.Corners);
  }
  return triangles;
}

std::vector<char> UsedPoints(const Carved& carved, const Level<3>& level)
{
  std::vector<char> used(carved.Mesh.Surface.Points.size(), 0);
  for (const FaceLife<3>& face : level.Faces)
  {
    for (const int corner : face.Corners)
    {
      used[corner] = 1;
    }
  }
  return used;
}

/** Property 1, for one level: no input vertex is outside. */
void ExpectToEnclose(const Carved& carved, const Level<3>& level, int samples)
{
  ResolvedMesh shell;
  shell.Points = carved.Mesh.Surface.Points;
  shell.Facets = Shell(level);
  shell.Windings.assign(shell.Facets.size(), 1);
  EXPECT_TRUE(IsClosed(shell));
  const std::vector<char> used = UsedPoints(carved, level);
  std::vector<int> hidden;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (!used[i] && carved.Mesh.Surface.PointSources[i] >= 0)
    {
      hidden.push_back(static_cast<int>(i));
    }
  }
  const std::size_t stride = std::max<std::size_t>(1, hidden.size() / samples);
  for (std::size_t i = 0; i < hidden.size(); i += stride)
  {
    EXPECT_TRUE(checks::Encloses(shell.Points, shell.Facets, shell.Points[hidden[i]]));
  }
}

/** Property 1, between two levels: no line that misses the coarser one hits the finer one. */
void ExpectSilhouetteToShrink(const Carved& carved, const Level<3>& coarse, const Level<3>& fine,
  int lines, std::mt19937_64& random)
{
  const std::vector<Point>& points = carved.Mesh.Surface.Points;
  std::normal_distribution<double> normal;
  for (int i = 0; i < lines; ++i)
  {
    const Point direction = { normal(random), normal(random), normal(random) };
    // Through a point near the finer level, so that lines graze it.
    const Triangle& t = fine.Faces[random() % fine.Faces.size()].Corners;
    Point through = points[t[0]];
    for (double& x : through)
    {
      x *= 1.0 + 0.05 * normal(random);
    }
    if (checks::LineHits(points, AllTriangles(fine), through, direction))
    {
      EXPECT_TRUE(checks::LineHits(points, AllTriangles(coarse), through, direction));
    }
  }
}

/** The first level is the convex hull of all points, those of a box included. */
void ExpectHull(const Carved& carved, const Level<3>& level)
{
  const std::vector<Point>& points = carved.Mesh.Surface.Points;
  const checks::Hull hull = checks::ConvexHull(points);
  EXPECT_NEAR(
    checks::SixVolume(points, AllTriangles(level)), hull.SixVolume, 1e-9 * hull.SixVolume);
  std::set<Point> vertices;
  for (const FaceLife<3>& face : level.Faces)
  {
    for (const int corner : face.Corners)
    {
      vertices.insert(points[corner]);
    }
  }
  EXPECT_TRUE(
    std::includes(vertices.begin(), vertices.end(), hull.Vertices.begin(), hull.Vertices.end()));
}

/** The last level is every triangle of M that has not solid on both sides, once, and no other. */
void ExpectInput(const Carved& carved, const Level<3>& level)
{
  const std::vector<Triangle>& triangles = carved.Mesh.Surface.Facets;
  std::vector<char> hidden(triangles.size(), 1);
  for (std::size_t cell = 0; cell < carved.Mesh.Cells.size(); ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      const int constraint = carved.Mesh.Constraints[cell][f];
      const bool outside = carved.Mesh.Neighbors[cell][f] < 0;
      if (constraint >= 0 &&
        (outside || carved.Regions.Kind(static_cast<int>(cell)) != RegionKind::Solid))
      {
        hidden[constraint] = 0;
      }
    }
  }
  std::vector<int> expected;
  for (std::size_t i = 0; i < hidden.size(); ++i)
  {
    if (!hidden[i])
    {
      expected.push_back(static_cast<int>(i));
    }
  }
  std::vector<int> found;
  for (const FaceLife<3>& face : level.Faces)
  {
    found.push_back(face.Constraint);
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
}

/**
 * What the last level of closed solids bounds is where the given mesh winds around a point, at random
 * points.
 */
void ExpectSolidByWinding(
  const TriangleMesh& given, const Carved& carved, const Level<3>& last, std::mt19937_64& random)
{
  ResolvedMesh all, shell;
  all.Points = given.Points;
  all.Facets = given.Triangles;
  all.Windings.assign(given.Triangles.size(), 1);
  shell.Points = carved.Mesh.Surface.Points;
  shell.Facets = Shell(last);
  shell.Windings.assign(shell.Facets.size(), 1);
  std::uniform_real_distribution<double> coordinate(-1.0, 3.0);
  for (int i = 0; i < 100; ++i)
  {
    const Point p = { coordinate(random), coordinate(random), coordinate(random) };
    const bool solid = std::abs(WindingNumber(all, p)) > 0.5;
    EXPECT_EQ(std::round(WindingNumber(shell, p)), solid ? 1.0 : 0.0);
  }
}

/** Property 4, with one or both sides of folds. */
void ExpectManifold(const Carved& carved, int step)
{
  StoredStream<3> stream = carved.Stored;
  for (const FoldSides folds : { FoldSides::One, FoldSides::Both })
  {
    stream.Folds = folds;
    const Level<3> level = ExtractLevel(stream, step);
    EXPECT_EQ(checks::FindFaults(level, CutIntoManifold(stream, level)), checks::ManifoldFaults());
  }
}

/** Properties 1 to 5, on some steps of the stream. */
void ExpectProperties(
  const TriangleMesh& given, const Carved& carved, int numberOfLevels, int samples)
{
  std::mt19937_64 random(7);
  const std::vector<Point>& points = carved.Mesh.Surface.Points;
  const std::set<Point> givenPoints(given.Points.begin(), given.Points.end());
  const std::vector<int> steps = SpreadLevels(carved.Profile, numberOfLevels);
  const std::vector<int> componentsOfSteps = CountComponents(carved.Mesh, carved.Stream);
  double volume = HUGE_VAL, hullVolume = 0.0;
  int components = 0, inputVertices = 0;
  Level<3> coarser;
  for (const int step : steps)
  {
    const Level<3> level = ExtractLevel(carved.Stored, step);
    ExpectToEnclose(carved, level, samples);
    ExpectManifold(carved, step);
    EXPECT_EQ(checks::CountCrossings(points, AllTriangles(level)), 0);

    const double newVolume = checks::SixVolume(points, Shell(level));
    // Of a sum over the surface, the rounding error is that of the whole.
    hullVolume = std::max(hullVolume, newVolume);
    EXPECT_LE(newVolume, volume + 1e-12 * hullVolume);
    volume = newVolume;
    const int newComponents = componentsOfSteps[step];
    EXPECT_GE(newComponents, components);
    components = newComponents;

    int newInputVertices = 0, allVertices = 0;
    const std::vector<char> used = UsedPoints(carved, level);
    for (std::size_t i = 0; i < used.size(); ++i)
    {
      allVertices += used[i];
      newInputVertices += used[i] && carved.Mesh.Surface.PointSources[i] >= 0;
      if (used[i] && carved.Mesh.Surface.PointSources[i] >= 0)
      {
        EXPECT_TRUE(givenPoints.count(points[i]));
      }
    }
    EXPECT_GE(newInputVertices, inputVertices);
    inputVertices = newInputVertices;
    EXPECT_EQ(carved.Profile.Vertices[step], allVertices);
    EXPECT_EQ(carved.Profile.Triangles[step], static_cast<int>(level.Faces.size()));

    if (step == 0)
    {
      ExpectHull(carved, level);
    }
    else
    {
      ExpectSilhouetteToShrink(carved, coarser, level, samples, random);
    }
    coarser = level;
  }
  ExpectInput(carved, coarser);
}

/** How many random meshes to try: a slice by default, more through the environment. */
int NumberOfRandomMeshes()
{
  const char* number = std::getenv("TOPOLOGYCARVING_RANDOM_MESHES");
  return number ? std::atoi(number) : 200;
}

/** Every property of a carving, drawn at random. */
struct RandomOptions
{
  /** How many values each property has, and the one that was drawn. */
  static constexpr std::array<int, 6> Counts = { 3, 3, 4, 3, 3, 2 };
  std::array<int, 6> Drawn;

  explicit RandomOptions(std::mt19937_64& random)
  {
    for (std::size_t i = 0; i < Counts.size(); ++i)
    {
      this->Drawn[i] = static_cast<int>(random() % Counts[i]);
    }
    this->Initial = static_cast<InitialApproximation>(this->Drawn[0]);
    this->Rule = static_cast<SolidRule>(this->Drawn[1]);
    this->Carve.Measure = static_cast<PriorityMeasure>(this->Drawn[2]);
    this->Carve.DepthExponent = this->Drawn[3];
    this->Carve.BreadthRadius = 0.2 * this->Drawn[4];
    this->Carve.CarveExposed = this->Drawn[5] == 0;
  }

  InitialApproximation Initial;
  SolidRule Rule;
  CarveOptions Carve;
};

/** Which pairs of values of two properties have been tried. */
class TriedPairs
{
public:
  void Add(const RandomOptions& options)
  {
    for (std::size_t i = 0; i < options.Drawn.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        this->Pairs.insert({ i, options.Drawn[i], j, options.Drawn[j] });
      }
    }
  }

  bool AreAll() const
  {
    std::size_t all = 0;
    for (std::size_t i = 0; i < RandomOptions::Counts.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        all += RandomOptions::Counts[i] * RandomOptions::Counts[j];
      }
    }
    return this->Pairs.size() == all;
  }

private:
  std::set<std::tuple<std::size_t, int, std::size_t, int>> Pairs;
};

/** A reply without the seconds, which differ from run to run. */
bool Equal(const Reply& a, const Reply& b)
{
  return a.Result.Surface.Points == b.Result.Surface.Points &&
    a.Result.Surface.Facets == b.Result.Surface.Facets &&
    a.Result.Surface.FacetSources == b.Result.Surface.FacetSources &&
    a.Result.Surface.Windings == b.Result.Surface.Windings && a.Result.Cells == b.Result.Cells &&
    a.Result.Neighbors == b.Result.Neighbors && a.Result.Constraints == b.Result.Constraints;
}

class RealMesh : public testing::TestWithParam<const char*>
{
};

} // namespace

// Enclosure, monotony, the ends of the stream, exact vertices, manifolds and freedom from crossings hold on random
// meshes (closed solids, open sheets, many components, overlapping ones) with random properties.
TEST(Properties, HoldOnRandomMeshes)
{
  std::mt19937_64 random(20061121);
  int refused = 0;
  TriedPairs pairs;
  const int count = NumberOfRandomMeshes();
  for (int i = 0; i - refused < count && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("random mesh " + std::to_string(i));
    const models::RandomModel model = models::MakeRandom(random);
    const RandomOptions options(random);
    Job job;
    job.Initial = options.Initial;
    job.Mesh = model.Mesh;
    job.InitialMesh = models::Moved(models::Sphere(2), { 1, 1, 1 }, 6.0);
    const HelperRun run = RunHelper(job);
    if (!run.Succeeded())
    {
      // TetGen does not cope with every mesh; that it copes with nearly all is part of the test.
      std::printf("refused: mesh %d, exit code %d, %s\n", i, run.ExitCode, run.Reply.Error.c_str());
      ++refused;
      ASSERT_LE(refused, 1 + count / 50);
      continue;
    }
    pairs.Add(options);
    const Carved carved = CarveResult(run.Reply.Result, options.Carve, options.Rule);
    ExpectProperties(model.Mesh, carved, 6, 20);
    if (model.Closed && options.Rule == SolidRule::NonzeroWinding)
    {
      ExpectSolidByWinding(
        model.Mesh, carved, ExtractLevel(carved.Stored, carved.Stream.LastStep()), random);
    }
  }
}

// The same input gives the same tetrahedra and the same stream, bit for bit.
TEST(Properties, AreDeterministic)
{
  std::mt19937_64 random(3);
  for (int i = 0; i < 10; ++i)
  {
    const models::RandomModel model = models::MakeRandom(random);
    const HelperRun first = RunHelper(model.Mesh), second = RunHelper(model.Mesh);
    EXPECT_TRUE(Equal(first.Reply, second.Reply));
    EXPECT_EQ(
      CarveResult(first.Reply.Result).Stream.Step, CarveResult(second.Reply.Result).Stream.Step);
  }
}

// A convex mesh is its own hull: there is no step, and its only level is itself.
TEST(Properties, LeaveConvexMeshesAsTheyAre)
{
  for (const TriangleMesh& mesh : { models::Tetrahedron(), models::Sphere(2),
         models::Box({ 0, 0, 0 }, { 1, 2, 3 }), models::Flipped(models::Sphere(1)) })
  {
    const HelperRun run = RunHelper(mesh);
    ASSERT_TRUE(run.Succeeded()) << run.Reply.Error;
    const Carved carved = CarveResult(run.Reply.Result);
    EXPECT_EQ(carved.Stream.LastStep(), 0);
    EXPECT_EQ(ExtractLevel(carved.Stored, 0).Faces.size(), mesh.Triangles.size());
  }
}

// The same properties hold on real meshes.
TEST_P(RealMesh, HasTheProperties)
{
  OffMesh off;
  ASSERT_EQ(ReadOff(std::string(TOPOLOGYCARVING_MESHES "/") + GetParam(), off), "");
  TriangleMesh mesh = { off.Points, {} };
  for (const std::vector<int>& face : off.Faces)
  {
    ASSERT_EQ(face.size(), 3u);
    mesh.Triangles.push_back({ face[0], face[1], face[2] });
  }
  const HelperRun run = RunHelper(mesh);
  ASSERT_TRUE(run.Succeeded()) << run.Reply.Error;
  const Carved carved = CarveResult(run.Reply.Result);
  ExpectProperties(mesh, carved, 4, 20);
}

INSTANTIATE_TEST_SUITE_P(Debian, RealMesh,
  testing::Values("bones.off", "elephant.off", "cheese.off", "bunny.off"),
  [](const auto& parameter)
  {
    const std::string name = parameter.param;
    return name.substr(0, name.find('.'));
  });
