// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "Helper/Exact/InitialSurface.h"
#include "Helper/Resolve/Clean.h"
#include "HelperRun.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <utility>

using namespace carving;
using namespace carving::helper;

namespace
{

TriangleMesh BigBox()
{
  return models::Box({ -3, -3, -3 }, { 3, 3, 3 });
}

Job MakeJob(const TriangleMesh& mesh, const TriangleMesh& initial)
{
  Job job;
  job.Initial = InitialApproximation::Custom;
  job.Mesh = mesh;
  job.InitialMesh = initial;
  return job;
}

} // namespace

// The message names each check that fails, and no other.
TEST(InitialSurface, NamesEachCheckThatFails)
{
  TriangleMesh open = BigBox();
  open.Triangles.pop_back();
  const TriangleMesh two =
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 2, 0, 0 }, { 3, 1, 1 }));
  TriangleMesh crossing = models::Sphere(1);
  for (double& x : crossing.Points[0])
  {
    x *= -1.5; // through the opposite side
  }
  const std::pair<TriangleMesh, const char*> cases[] = { { open, "is not closed" },
    { two, "is not one component" }, { models::Torus(1.0, 0.3, 8, 6), "is not of genus zero" },
    { crossing, "intersects itself" }, { {}, "has no triangle" } };
  for (const auto& [mesh, expected] : cases)
  {
    const std::string error = CheckInitialSurface(Clean(AsResolved(mesh)));
    for (const auto& [ignored, problem] : cases)
    {
      EXPECT_EQ(error.find(problem) != std::string::npos, problem == expected) << error;
    }
  }
  EXPECT_EQ(CheckInitialSurface(Clean(AsResolved(BigBox()))), "");
}

// The tetrahedra fill the given C0, and only triangles of M constrain them.
TEST(InitialSurface, IsFilled)
{
  const Reply reply = GetReply(MakeJob(models::Sphere(1), BigBox()));
  EXPECT_NEAR(checks::SixVolume(reply.Result), 6.0 * 216.0, 1e-9);
  EXPECT_EQ(reply.Result.Surface.Facets.size(), models::Sphere(1).Triangles.size());
}

// A triangle of C0 that is given twice counts once.
TEST(InitialSurface, MayRepeatTriangles)
{
  TriangleMesh initial = BigBox();
  initial.Triangles.push_back(initial.Triangles.front());
  const Reply reply = GetReply(MakeJob(models::Sphere(1), initial));
  EXPECT_NEAR(checks::SixVolume(reply.Result), 6.0 * 216.0, 1e-9);
}

// The orientation of C0's triangles does not matter.
TEST(InitialSurface, MayHaveTurnedTriangles)
{
  TriangleMesh initial = BigBox();
  for (std::size_t i = 0; i < initial.Triangles.size(); i += 2)
  {
    std::swap(initial.Triangles[i][0], initial.Triangles[i][1]);
  }
  const Reply reply = GetReply(MakeJob(models::Sphere(1), initial));
  EXPECT_NEAR(checks::SixVolume(reply.Result), 6.0 * 216.0, 1e-9);
}

// A nonconvex C0 is filled, but not the space between it and its hull.
TEST(InitialSurface, NeedNotBeConvex)
{
  // A box whose upper side is dented to a point.
  TriangleMesh dented;
  for (int i = 0; i < 8; ++i)
  {
    dented.Points.push_back({ i & 1 ? 3.0 : -3.0, i & 2 ? 3.0 : -3.0, i & 4 ? 3.0 : -3.0 });
  }
  dented.Points.push_back({ 0, 0, 1.5 });
  dented.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 5 }, { 0, 5, 4 }, { 2, 6, 7 }, { 2, 7, 3 },
    { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 }, { 4, 5, 8 }, { 5, 7, 8 }, { 7, 6, 8 },
    { 6, 4, 8 } };
  const Reply reply = GetReply(MakeJob(models::Sphere(1), dented));
  // The missing pyramid has the base 6 x 6 and the height 1.5.
  EXPECT_NEAR(checks::SixVolume(reply.Result), 6.0 * (216.0 - 36.0 * 1.5 / 3.0), 1e-9);
}

// C0 may touch the input; triangles on both belong to the input.
TEST(InitialSurface, MayTouchTheInput)
{
  const TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  const Reply reply = GetReply(MakeJob(box, models::Box({ 0, 0, 0 }, { 1, 1, 2 })));
  EXPECT_NEAR(checks::SixVolume(reply.Result), 12.0, 1e-12);
  for (const int multiplicity : reply.Result.Surface.Multiplicities)
  {
    EXPECT_EQ(multiplicity, 1);
  }
  EXPECT_EQ(reply.IntersectingPairs, 0);
}

// An input that is not inside C0 is refused.
TEST(InitialSurface, MustContainTheInput)
{
  for (const double shift : { 2.5, 10.0 })
  {
    const HelperRun run =
      RunHelper(MakeJob(models::Moved(models::Sphere(1), { shift, 0, 0 }), BigBox()));
    EXPECT_NE(run.Reply.Error.find("does not contain the input"), std::string::npos)
      << run.Reply.Error;
  }
}
