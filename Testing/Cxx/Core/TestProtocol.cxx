// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Protocol/Protocol.h"
#include "Core/Solid/DropSolid.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <sstream>

using namespace carving;

namespace
{

Reply MakeReply()
{
  Reply reply;
  reply.Result = small::NestedTetrahedra(small::InnerFaces());
  reply.Limits = "a limit\n";
  reply.IntersectingPairs = 7;
  reply.SnapDistance = 0.125;
  reply.StageSeconds = { 0.25, 0.5, 0.75, 1.0, 1.25 };
  reply.Strategy = "a strategy";
  reply.Attempts = "an attempt\n";
  reply.KeptDistance = 0.3;
  reply.KeptDistance99 = 0.2;
  reply.KeptDistanceMean = 0.1;
  reply.MetShare = 0.75;
  reply.PointsAdded = 11;
  reply.InteriorDropped = 12;
  reply.CracksSealed = 13;
  reply.CracksOpen = 1;
  reply.SolidMatters = 1;
  // A tetrahedron, of which an edge collapses into a new point: two triangles are left.
  Decimation& decimation = reply.Decimation;
  decimation.Chain = { 4, 4, 1,
    { { { 0, 1, 2 }, 7, 0, 1 }, { { 0, 3, 1 }, 6, 0, 1 }, { { 0, 2, 3 }, 5, 0, 1 },
      { { 1, 3, 2 }, 4, 0, 1 }, { { 4, 2, 3 }, 5, 1, 2 }, { { 4, 3, 2 }, 4, 1, 2 } } };
  decimation.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.1, 0.2, 0.3 } };
  decimation.PointSources = { 3, 2, 1, 0, -1 };
  decimation.Surfaces = { { 1, 0, 0.5 } };
  return reply;
}

template <class Message>
std::string Written(const Message& message)
{
  std::ostringstream out;
  Write(out, message);
  return out.str();
}

std::string ReadReply(const std::string& bytes, int threads = 1)
{
  Reply reply;
  return Read(bytes.data(), bytes.size(), reply, threads);
}

} // namespace

// A job is read as it was written.
TEST(Protocol, RestoresAJob)
{
  Job job;
  job.Kind = JobKind::CountIntersections;
  job.Initial = InitialApproximation::Custom;
  job.Conformity = Conformity::Enclosing;
  job.EnclosingTolerance = 0.25;
  job.Strategy = Strategy::Recover;
  job.SnapTolerance = 0.5;
  job.TimeLimit = 2.0;
  job.MemoryLimit = 3.0;
  job.Solid = SolidRule::EvenOdd;
  job.DropSolid = 1;
  job.Mesh = { { { 1, 2, 3 }, { 4, 5, 6 }, { 0.1, 0.2, 0.3 } }, { { 2, 1, 0 } } };
  job.InitialMesh = { { { 7, 8, 9 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  job.Contours = { { { 1, 1, 0 }, { 2, 1, 0 } }, { { 0, 1 } } };
  job.InitialContours = { { { 3, 1, 0 }, { 4, 1, 0 } }, { { 1, 0 } } };
  job.Surface.Points = { { 6.0, 7.0, 8.0 } };
  job.Surface.Triangles = { { 0, 0, 0 } };
  job.Parts = { { { 8, 7, 6 }, { 5, 4, 3 } }, { { 1, 0, 1 } } };
  job.Decimation = { DecimationTarget::ErrorBound, { 0.5, 0.25 }, { 0.1, 0.2 }, 1, 1 };
  job.Processes = 5;
  const std::string bytes = Written(job);
  Job restored;
  ASSERT_EQ(Read(bytes.data(), bytes.size(), restored), "");
  EXPECT_EQ(restored.Kind, job.Kind);
  EXPECT_EQ(restored.Processes, 5);
  EXPECT_TRUE(static_cast<HelperOptions&>(restored) == job);
  EXPECT_EQ(restored.Solid, job.Solid);
  EXPECT_EQ(restored.DropSolid, 1);
  EXPECT_EQ(restored.Mesh.Points, job.Mesh.Points);
  EXPECT_EQ(restored.Mesh.Triangles, job.Mesh.Triangles);
  EXPECT_EQ(restored.InitialMesh.Points, job.InitialMesh.Points);
  EXPECT_EQ(restored.InitialMesh.Triangles, job.InitialMesh.Triangles);
  EXPECT_EQ(restored.Contours.Points, job.Contours.Points);
  EXPECT_EQ(restored.Contours.Edges, job.Contours.Edges);
  EXPECT_EQ(restored.InitialContours.Points, job.InitialContours.Points);
  EXPECT_EQ(restored.InitialContours.Edges, job.InitialContours.Edges);
  EXPECT_EQ(restored.Surface.Points, job.Surface.Points);
  EXPECT_EQ(restored.Surface.Triangles, job.Surface.Triangles);
  EXPECT_EQ(restored.Parts.Points, job.Parts.Points);
  EXPECT_EQ(restored.Parts.Triangles, job.Parts.Triangles);
  EXPECT_EQ(restored.Decimation.Type, job.Decimation.Type);
  EXPECT_EQ(restored.Decimation.Targets, job.Decimation.Targets);
  EXPECT_EQ(restored.Decimation.Bounds, job.Decimation.Bounds);
  EXPECT_EQ(restored.Decimation.GivesUp, job.Decimation.GivesUp);
  EXPECT_EQ(restored.Decimation.Nested, job.Decimation.Nested);
}

// A reply is read as it was written.
TEST(Protocol, RestoresAReply)
{
  const Reply reply = MakeReply();
  const std::string bytes = Written(reply);
  Reply restored;
  ASSERT_EQ(Read(bytes.data(), bytes.size(), restored), "");
  EXPECT_EQ(restored.Result.Cells, reply.Result.Cells);
  EXPECT_EQ(restored.Result.Constraints, reply.Result.Constraints);
  EXPECT_EQ(restored.Result.Neighbors, reply.Result.Neighbors);
  EXPECT_EQ(restored.Result.Surface.Points, reply.Result.Surface.Points);
  EXPECT_EQ(restored.Result.Surface.PointSources, reply.Result.Surface.PointSources);
  EXPECT_EQ(restored.Result.Surface.Facets, reply.Result.Surface.Facets);
  EXPECT_EQ(restored.Result.Surface.FacetSources, reply.Result.Surface.FacetSources);
  EXPECT_EQ(restored.Result.Surface.Multiplicities, reply.Result.Surface.Multiplicities);
  EXPECT_EQ(
    restored.Result.Surface.SignedMultiplicities, reply.Result.Surface.SignedMultiplicities);
  EXPECT_EQ(restored.Strategy, reply.Strategy);
  EXPECT_EQ(restored.Attempts, reply.Attempts);
  EXPECT_EQ(restored.Limits, reply.Limits);
  EXPECT_EQ(restored.KeptDistance, 0.3);
  EXPECT_EQ(restored.KeptDistance99, 0.2);
  EXPECT_EQ(restored.KeptDistanceMean, 0.1);
  EXPECT_EQ(restored.MetShare, 0.75);
  EXPECT_EQ(restored.PointsAdded, 11);
  EXPECT_EQ(restored.InteriorDropped, 12);
  EXPECT_EQ(restored.CracksSealed, 13);
  EXPECT_EQ(restored.CracksOpen, 1);
  EXPECT_EQ(restored.SolidMatters, 1);
  EXPECT_EQ(restored.IntersectingPairs, 7);
  EXPECT_EQ(restored.SnapDistance, 0.125);
  EXPECT_EQ(restored.StageSeconds, reply.StageSeconds);
  const Decimation& decimation = restored.Decimation;
  EXPECT_EQ(decimation.Points, reply.Decimation.Points);
  EXPECT_EQ(decimation.PointSources, reply.Decimation.PointSources);
  ASSERT_EQ(decimation.Chain.Faces.size(), 6u);
  EXPECT_EQ(decimation.Chain.Faces[4].Corners, (Triangle{ 4, 2, 3 }));
  ASSERT_EQ(decimation.Surfaces.size(), 1u);
  EXPECT_EQ(decimation.Surfaces[0].Collapses, 1);
  EXPECT_EQ(decimation.Surfaces[0].Reached, 0);
  EXPECT_EQ(decimation.Surfaces[0].Error, 0.5);
}

// So is the reply of a mesh that is enclosed, and that of contours.
TEST(Protocol, RestoresWhatOnlySomeRepliesHave)
{
  Reply reply = MakeReply();
  reply.Result.Unresolved = reply.Result.Surface;
  reply.Result.Kept.assign(reply.Result.Cells.size(), 0);
  reply.Result.Kept.front() = 1;
  reply.Result.MetShares.assign(reply.Result.Surface.Facets.size(), 0.5);
  reply.Plane.Surface.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  reply.Plane.Surface.PointSources = { 2, -1, 0 };
  reply.Plane.Cells = { { 0, 1, 2 } };
  reply.Plane.Neighbors = { { Outside, Outside, Outside } };
  reply.Plane.Constraints.Append({ -1, -1, -1 });
  const std::string bytes = Written(reply);
  Reply restored;
  ASSERT_EQ(Read(bytes.data(), bytes.size(), restored), "");
  EXPECT_EQ(restored.Result.Unresolved.Points, reply.Result.Unresolved.Points);
  EXPECT_EQ(restored.Result.Unresolved.Facets, reply.Result.Unresolved.Facets);
  EXPECT_EQ(restored.Result.Kept, reply.Result.Kept);
  EXPECT_EQ(restored.Result.MetShares, reply.Result.MetShares);
  EXPECT_EQ(restored.Plane.Surface.Points, reply.Plane.Surface.Points);
  EXPECT_EQ(restored.Plane.Surface.PointSources, reply.Plane.Surface.PointSources);
  EXPECT_EQ(restored.Plane.Cells, reply.Plane.Cells);
  EXPECT_EQ(restored.Plane.Neighbors, reply.Plane.Neighbors);
  EXPECT_EQ(restored.Plane.Constraints.NumberOfCells, 1);
}

// A reply without the solid is read as it was written, and rejected if its regions do not fit.
TEST(Protocol, RestoresRegions)
{
  Reply reply = MakeReply();
  reply.Regions = Classify(reply.Result);
  DropSolid(reply.Result, reply.Regions);
  const std::string bytes = Written(reply);
  Reply restored;
  ASSERT_EQ(Read(bytes.data(), bytes.size(), restored), "");
  EXPECT_EQ(restored.Regions.RegionOfCell, reply.Regions.RegionOfCell);
  EXPECT_EQ(restored.Regions.SolidRegions, reply.Regions.SolidRegions);
  ASSERT_EQ(restored.Regions.Regions.size(), 2u);
  EXPECT_EQ(restored.Regions.Regions[1].Kind, RegionKind::Solid);
  EXPECT_EQ(restored.Regions.Regions[1].Winding, 1.0);
  const auto mistakeAfter = [&](const std::function<void(Classification&)>& change)
  {
    Reply changed = reply;
    change(changed.Regions);
    return ReadReply(Written(changed));
  };
  EXPECT_NE(mistakeAfter([](Classification& c) { c.RegionOfCell.pop_back(); }), "");
  EXPECT_NE(mistakeAfter([](Classification& c) { c.RegionOfCell[0] = 2; }), "");
  EXPECT_NE(mistakeAfter([](Classification& c) { c.RegionOfCell[0] = -1; }), "");
  EXPECT_NE(mistakeAfter([](Classification& c) { c.Regions.pop_back(); }), "");
  EXPECT_NE(mistakeAfter([](Classification& c) { c.SolidRegions.pop_back(); }), "");
  EXPECT_NE(mistakeAfter([](Classification& c) { c.SolidRegions.clear(); }), "");
  EXPECT_NE(mistakeAfter([](Classification& c) { c.SolidRegions[0] = { -1, 1 }; }), "");
}

// A chain of collapses is rejected if its faces name points that do not exist, do not add up to two
// fewer with each collapse, or if a surface has more collapses.
TEST(Protocol, RejectsWrongChains)
{
  const auto mistakeAfter = [](const std::function<void(Decimation&)>& change)
  {
    Reply reply = MakeReply();
    change(reply.Decimation);
    return ReadReply(Written(reply));
  };
  EXPECT_EQ(mistakeAfter([](Decimation&) {}), "");
  EXPECT_NE(mistakeAfter([](Decimation& d) { d.Chain.Faces[0].Corners[1] = 5; }), "");
  EXPECT_NE(mistakeAfter([](Decimation& d) { d.Chain.Faces[0].Corners[1] = 0; }), "");
  EXPECT_NE(mistakeAfter([](Decimation& d) { d.Chain.Faces[0].Death = 2; }), "");
  EXPECT_NE(mistakeAfter([](Decimation& d) { d.Chain.Faces[4].Death = 3; }), "");
  EXPECT_NE(mistakeAfter([](Decimation& d) { d.Chain.Triangles = 5; }), "");
  EXPECT_NE(mistakeAfter([](Decimation& d) { d.Chain.Collapses = -1; }), "");
  EXPECT_NE(mistakeAfter([](Decimation& d) { d.PointSources.pop_back(); }), "");
  EXPECT_NE(mistakeAfter([](Decimation& d) { d.Points[1][2] = NAN; }), "");
  EXPECT_NE(mistakeAfter([](Decimation& d) { d.Surfaces[0].Collapses = 2; }), "");
}

// A reply whose sources are not those of its job, such as that of another program, is told.
TEST(Protocol, TellsSourcesThatDoNotExist)
{
  const auto mistakeAfter = [](const std::function<void(Reply&)>& change)
  {
    Job job;
    job.Mesh.Points.resize(4);
    job.Mesh.Triangles.resize(8);
    Reply reply;
    reply.Decimation = MakeReply().Decimation;
    change(reply);
    return FindForeignSource(reply, CountSources(job));
  };
  EXPECT_EQ(mistakeAfter([](Reply&) {}), "");
  EXPECT_NE(mistakeAfter([](Reply& r) { r.Decimation.PointSources[0] = 4; }), "");
  EXPECT_NE(mistakeAfter([](Reply& r) { r.Decimation.Chain.Faces[0].Source = 8; }), "");
  EXPECT_NE(mistakeAfter([](Reply& r) { r.Decimation.Chain.Faces[0].Source = -1; }), "");
  EXPECT_NE(mistakeAfter([](Reply& r) { r.Result.Surface.PointSources = { 4 }; }), "");
  EXPECT_NE(mistakeAfter([](Reply& r) { r.Result.Unresolved.FacetSources = { 8 }; }), "");
  EXPECT_NE(mistakeAfter([](Reply& r) { r.Plane.Surface.FacetSources = { -2 }; }), "");
}

// A reply that reports an error holds just that.
TEST(Protocol, RestoresAnError)
{
  Reply reply;
  reply.Error = "it does not work";
  reply.StageSeconds.assign(NumberOfStages, 0.0);
  const std::string bytes = Written(reply);
  Reply restored;
  ASSERT_EQ(Read(bytes.data(), bytes.size(), restored), "");
  EXPECT_EQ(restored.Error, reply.Error);
}

// Nothing, text, and the other message's bytes are foreign formats.
TEST(Protocol, RejectsForeignData)
{
  Job job;
  EXPECT_NE(ReadReply(""), "");
  EXPECT_NE(ReadReply("Segmentation fault"), "");
  EXPECT_NE(ReadReply(Written(job)), "");
  const std::string reply = Written(MakeReply());
  EXPECT_NE(Read(reply.data(), reply.size(), job), "");
}

// A message that was cut off anywhere, or continued, is rejected.
TEST(Protocol, RejectsAWrongLength)
{
  const std::string bytes = Written(MakeReply());
  for (std::size_t length = 0; length < bytes.size(); ++length)
  {
    ASSERT_NE(ReadReply(bytes.substr(0, length)), "") << length;
  }
  EXPECT_NE(ReadReply(bytes + "x"), "");
}

// Random changes of single bytes never crash; what is accepted has indices in range.
TEST(Protocol, SurvivesChangedBytes)
{
  const std::string bytes = Written(MakeReply());
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i)
  {
    std::string changed = bytes;
    changed[random() % changed.size()] = static_cast<char>(random());
    Reply reply;
    if (Read(changed.data(), changed.size(), reply).empty())
    {
      for (const auto& cell : reply.Result.Cells)
      {
        for (const int corner : cell)
        {
          ASSERT_GE(corner, 0);
          ASSERT_LT(corner, static_cast<int>(reply.Result.Surface.Points.size()));
        }
      }
    }
  }
}

// A job with a triangle that names a point that there is not is rejected.
TEST(Protocol, RejectsIndicesOutOfRange)
{
  for (const int corner : { -1, 3 })
  {
    Job job;
    job.Mesh = { { { 1, 2, 3 }, { 4, 5, 6 }, { 0, 0, 0 } }, { { 0, 1, corner } } };
    const std::string bytes = Written(job);
    EXPECT_NE(Read(bytes.data(), bytes.size(), job), "");
  }
}

// Neighbors that do not agree about their common face are rejected, whatever the number of threads.
TEST(Protocol, RejectsNeighborsThatDisagree)
{
  for (std::size_t cell = 0; cell < MakeReply().Result.Cells.size(); ++cell)
  {
    Reply reply = MakeReply();
    for (const int threads : { 0, 1, 2, 3, 50 })
    {
      EXPECT_EQ(ReadReply(Written(reply), threads), "");
    }
    for (int& neighbor : reply.Result.Neighbors[cell])
    {
      neighbor = -1;
    }
    for (const int threads : { 0, 1, 2, 3, 50 })
    {
      EXPECT_NE(ReadReply(Written(reply), threads), "") << cell;
    }
  }
}

// Cells, facets, coordinates and counts that cannot be are rejected, each with words of its own.
TEST(Protocol, RejectsImpossibleNumbers)
{
  const auto reject = [](const std::string& words, const std::function<void(ResolvedMesh&)>& spoil)
  {
    Reply reply = MakeReply();
    ASSERT_EQ(ReadReply(Written(reply)), "");
    spoil(reply.Result.Surface);
    const std::string mistake = ReadReply(Written(reply));
    EXPECT_NE(mistake.find(words), std::string::npos) << mistake;
  };
  reject("not finite", [](auto& mesh) { mesh.Points[3][1] = HUGE_VAL; });
  reject("not finite", [](auto& mesh) { mesh.Points[0][2] = std::nan(""); });
  reject("corner twice", [](auto& mesh) { mesh.Facets[1][2] = mesh.Facets[1][0]; });
  reject("impossible multiplicity", [](auto& mesh) { mesh.SignedMultiplicities[2] = -2; });
  reject("impossible multiplicity", [](auto& mesh) { mesh.Multiplicities[2] = -1; });
  reject("impossible multiplicity",
    [](auto& mesh)
    { mesh.Multiplicities[0] = mesh.Multiplicities[1] = std::numeric_limits<int>::max(); });
  reject("differ in length", [](auto& mesh) { mesh.PointSources.pop_back(); });
  // A facet that no cell has, one without a cell, and one of another cell.
  reject("one face", [](auto& mesh) { mesh.Facets[0] = { 0, 1, 4 }; });
  reject("one face",
    [](auto& mesh)
    {
      mesh.Facets.push_back({ 0, 1, 2 });
      mesh.FacetSources.push_back(0);
      mesh.SignedMultiplicities.push_back(1);
      mesh.Multiplicities.push_back(1);
    });
  reject("one face", [](auto& mesh) { std::swap(mesh.Facets[0], mesh.Facets[1]); });
}

// A cell that has a corner twice, or that shares no face with its neighbor, is rejected.
TEST(Protocol, RejectsCellsThatDoNotFit)
{
  Reply reply = MakeReply();
  reply.Result.Cells[0][0] = reply.Result.Cells[0][1];
  EXPECT_NE(ReadReply(Written(reply)).find("corner twice"), std::string::npos);
  reply = MakeReply();
  std::swap(reply.Result.Cells[0], reply.Result.Cells[12]);
  EXPECT_NE(ReadReply(Written(reply)).find("disagree"), std::string::npos);
}

// A line of progress is understood, any other line is not taken for one.
TEST(Protocol, TellsProgressFromWords)
{
  for (const char* attempt : { "", "TetGen -pcY, order 1" })
  {
    std::string line = ProgressLine({ Stage::Resolve, 0.25, attempt });
    EXPECT_EQ(line.back(), '\n');
    line.pop_back();
    WorkProgress progress;
    EXPECT_TRUE(ParseProgress(line, progress));
    EXPECT_EQ(progress.Stage, Stage::Resolve);
    EXPECT_EQ(progress.Fraction, 0.25);
    EXPECT_EQ(progress.Attempt, attempt);
  }
  WorkProgress progress;
  EXPECT_FALSE(ParseProgress("Assertion failed", progress));
  EXPECT_FALSE(ParseProgress("@progress 17 5000", progress));
}

// Progress is the same where the decimal point is a comma.
TEST(Protocol, TellsProgressInEveryLocale)
{
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  const char* names[] = { "de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "fr_FR" };
  if (std::none_of(std::begin(names), std::end(names),
        [](const char* name) { return std::setlocale(LC_NUMERIC, name) != nullptr; }))
  {
    GTEST_SKIP() << "No locale with a decimal comma is installed.";
  }
  WorkProgress progress;
  EXPECT_TRUE(ParseProgress("@progress 3 2500 TetGen -pcY", progress));
  EXPECT_EQ(progress.Fraction, 0.25);
  EXPECT_EQ(progress.Attempt, "TetGen -pcY");
  EXPECT_EQ(ProgressLine(progress), "@progress 3 2500 TetGen -pcY\n");
  std::setlocale(LC_NUMERIC, before.c_str());
}
