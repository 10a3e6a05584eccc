// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Streams do what the paper's figures show. Topology is counted here from scratch, simplex by simplex.
 */
#include "Carver.h"
#include "Components.h"
#include "Figures.h"
#include "HelperRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

using namespace carving;

namespace
{

/** Per step, of the closed complex of M, the solid and the tetrahedra that are not carved. */
struct Topology
{
  std::vector<int> Components;
  std::vector<int> Tunnels;
};

/** V - E + F - T of the complex, per step: a simplex is in it while something around it is. */
std::vector<int> EulerCharacteristics(const Tetrahedralization& mesh, const Stream& stream)
{
  std::map<std::vector<int>, int> deaths;
  const auto addWithFaces = [&](std::vector<int> simplex, int death)
  {
    std::sort(simplex.begin(), simplex.end());
    for (unsigned int subset = 1; subset < 1u << simplex.size(); ++subset)
    {
      std::vector<int> face;
      for (std::size_t i = 0; i < simplex.size(); ++i)
      {
        if (subset >> i & 1)
        {
          face.push_back(simplex[i]);
        }
      }
      int& last = deaths[face];
      last = std::max(last, death);
    }
  };
  for (const Triangle& t : mesh.Surface.Facets)
  {
    addWithFaces({ t.begin(), t.end() }, Stream::Never);
  }
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    addWithFaces({ mesh.Cells[cell].begin(), mesh.Cells[cell].end() }, stream.Step[cell]);
  }
  std::vector<int> characteristics(stream.LastStep() + 1, 0);
  for (const auto& [simplex, death] : deaths)
  {
    const int end = std::min(death, stream.LastStep() + 1);
    for (int step = 0; step < end; ++step)
    {
      characteristics[step] += simplex.size() % 2 ? 1 : -1;
    }
  }
  return characteristics;
}

/** For meshes without voids: then tunnels are components less the Euler characteristic. */
Topology CountTopology(const TriangleMesh& given, double depthExponent)
{
  const HelperRun run = RunHelper(given);
  EXPECT_TRUE(run.Succeeded()) << run.Reply.Error;
  const Tetrahedralization& mesh = run.Reply.Result;
  CarveOptions options;
  options.DepthExponent = depthExponent;
  Stream stream;
  Carve(mesh, Classify(mesh), options, stream);
  Topology topology;
  topology.Components = CountComponents(mesh, stream);
  topology.Tunnels = EulerCharacteristics(mesh, stream);
  std::transform(topology.Components.begin(), topology.Components.end(), topology.Tunnels.begin(),
    topology.Tunnels.begin(), std::minus<int>());
  return topology;
}

/** The share of steps with one component and so many tunnels. */
double ShareOfSteps(const Topology& topology, int tunnels)
{
  int steps = 0;
  for (std::size_t i = 0; i < topology.Tunnels.size(); ++i)
  {
    steps += topology.Components[i] == 1 && topology.Tunnels[i] == tunnels;
  }
  return static_cast<double>(steps) / topology.Tunnels.size();
}

} // namespace

// Figure 4: two spheres are one component until they split, and two from then on; no tunnel opens.
TEST(Figures, TwoSpheresSplit)
{
  const Topology topology = CountTopology(models::TwoSpheres(), 0.0);
  EXPECT_EQ(topology.Components.front(), 1);
  EXPECT_EQ(topology.Components.back(), 2);
  EXPECT_TRUE(std::is_sorted(topology.Components.begin(), topology.Components.end()));
  EXPECT_EQ(topology.Tunnels.front(), 0);
  EXPECT_EQ(topology.Tunnels.back(), 0);
}

// Figure 10 (b): without depth, eight spheres are carved through the cube's six sides first. A frame of
// a cube, with 8 corners and 12 edges, has 12 - 8 + 1 = 5 tunnels.
TEST(Figures, EightSpheresBecomeAFrameWithoutDepth)
{
  EXPECT_GT(ShareOfSteps(CountTopology(models::EightSpheres(), 0.0), 5), 0.5);
}

// Figure 10 (c): with dp = 2 carving advances evenly, and nearly no tunnel opens before the spheres split.
TEST(Figures, EightSpheresStayWholeWithDepth)
{
  EXPECT_GT(ShareOfSteps(CountTopology(models::EightSpheres(), 2.0), 0), 0.85);
}
