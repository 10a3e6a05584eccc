// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Cutting/Cut.h"

#include "Core/Mesh/FaceDistance.h"
#include "Helper/Cutting/DividePolygon.h"
#include "Helper/Cutting/Patch.h"

#include <algorithm>
#include <cmath>

namespace carving::helper
{
namespace
{

using Part = Subdivision::Part;

/**
 * Most parts take less. Where more is needed, parts pierce hundreds of tetrahedra each, and a part
 * that fails takes as long as many small ones.
 */
constexpr std::size_t LeastEffort = 300000, EffortPerPart = 200;

double LengthOf(const Triangle& t, const std::vector<Point>& points)
{
  return LengthOfLongestSide<3>(carving::CornersOf<3>(points, t));
}

class Cutter
{
public:
  Cutter(PiercedMesh& mesh, double tolerance)
    : Mesh(mesh, tolerance)
  {
  }

  /** Announces a part that has been taken from the mesh. */
  void Add(const Part& part);

  /** Gives the part back to the mesh as faces. Returns whether that succeeded. */
  bool TryPart(const Part& part);

  /**
   * Gives parts back, divided at the vertices on their edges. Of needles, gives back the gaps at
   * their edges, and returns the needles.
   */
  std::vector<Part> GiveUp(
    const std::vector<Part>& parts, int threads, const std::function<bool(double)>& progress);

  std::size_t GetEffort() const
  {
    return this->Mesh.GetEffort();
  }

private:
  bool TryOnce(const Part& part);
  bool DivideAtEdges(const Part& part, std::vector<Part>& pieces) const;

  CutMesh Mesh;
};

void Cutter::Add(const Part& part)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto [a, b] = std::minmax(part.Corners[i], part.Corners[(i + 1) % 3]);
    Chains& chains = this->Mesh.GetChains();
    chains.Need(a, b);
    if (!chains.Has(a, b) && this->Mesh.IsEdge(a, b))
    {
      chains.Add({ a, b });
    }
  }
}

bool Cutter::TryOnce(const Part& part)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto [a, b] = std::minmax(part.Corners[i], part.Corners[(i + 1) % 3]);
    if (!this->Mesh.Connect(a, b))
    {
      return false;
    }
  }
  Patch patch(this->Mesh, part.Corners);
  if (!patch.CutEdges())
  {
    return false;
  }
  const std::vector<Triangle> faces = patch.FindFaces();
  if (faces.empty())
  {
    this->Mesh.RemoveFlat(patch.FindFlat());
  }
  for (const Triangle& face : faces)
  {
    this->Mesh.GetMesh().GivePart(face, part.Parent);
  }
  return !faces.empty();
}

bool Cutter::TryPart(const Part& part)
{
  constexpr int mostRepairs = 6;
  this->Mesh.TakeRepair();
  bool isDone = this->TryOnce(part);
  for (int i = 0; i < mostRepairs && !isDone && this->Mesh.TakeRepair(); ++i)
  {
    isDone = this->TryOnce(part);
  }
  for (int i = 0; i < 3 && isDone; ++i)
  {
    this->Mesh.GetChains().Release(part.Corners[i], part.Corners[(i + 1) % 3]);
  }
  this->Mesh.Thin();
  return isDone;
}

/**
 * Adds the pieces of a part between the vertices on its edges. Of a needle, adds the gaps between
 * its edges and these vertices alone, and returns false.
 */
bool Cutter::DivideAtEdges(const Part& part, std::vector<Part>& pieces) const
{
  Sides sides;
  for (int i = 0; i < 3; ++i)
  {
    const int from = part.Corners[i], to = part.Corners[(i + 1) % 3];
    std::vector<int>& side = sides.emplace_back(1, from);
    this->Mesh.GetChains().Append(from, to, side);
    side.push_back(to);
  }
  constexpr double most = 20.0; // of all pieces, in lengths of the whole
  const std::vector<Point>& points = this->Mesh.GetMesh().GetParts().GetPoints();
  std::vector<Triangle> divided = DividePolygon(sides, points);
  double length = 0.0;
  for (const Triangle& piece : divided)
  {
    length += LengthOf(piece, points);
  }
  const bool isNeedle = length > most * LengthOf(part.Corners, points);
  if (isNeedle)
  {
    divided.clear();
    for (const std::vector<int>& side : sides)
    {
      const std::vector<Triangle> gap = FillGap(side);
      divided.insert(divided.end(), gap.begin(), gap.end());
    }
  }
  for (const Triangle& piece : divided)
  {
    pieces.push_back({ piece, part.Parent });
  }
  return !isNeedle;
}

std::vector<Part> Cutter::GiveUp(
  const std::vector<Part>& parts, int threads, const std::function<bool(double)>& progress)
{
  std::vector<Part> pieces, needles;
  for (const Part& part : parts)
  {
    if (!this->DivideAtEdges(part, pieces))
    {
      needles.push_back(part);
    }
  }
  this->Mesh.GetMesh().GiveParts(pieces, threads, progress);
  return needles;
}

/** The area that cutting meets for its effort. */
class Yield
{
public:
  Yield(const PiercedMesh& mesh, double least)
    : Least(least)
  {
    for (const auto& [corners, parent] : mesh.GetParts().GetParts())
    {
      this->All += parent < 0 ? 0.0 : mesh.GetParts().AreaOf(corners);
    }
  }

  void Add(double area)
  {
    this->Met += area;
  }

  /** Returns false once the last changes have met too little. To be called often. */
  bool IsEnough(std::size_t effort)
  {
    constexpr std::size_t first = 700000, period = 100000;
    if (effort >= std::max(first, this->Start + period))
    {
      this->Enough &= this->Met - this->MetBefore >= this->Least * this->All;
      this->MetBefore = this->Met;
      this->Start = effort;
    }
    return this->Enough;
  }

private:
  double Least, All = 0.0, Met = 0.0, MetBefore = 0.0;
  std::size_t Start = 0;
  bool Enough = true;
};

/**
 * Takes the missing parts from the mesh, and returns them in the order of their turns. By area
 * alone, a mesh of which all parts have their turn loses the least area; by area per tetrahedron, a
 * mesh of which few do. The order is between both.
 */
std::vector<Part> TakeInOrder(PiercedMesh& mesh, std::vector<int> missing)
{
  const std::vector<Part>& all = mesh.GetParts().GetParts();
  const std::vector<int> counts = mesh.CountCells();
  std::vector<double> ranks(all.size(), 0.0);
  for (const int part : missing)
  {
    const double area = mesh.GetParts().AreaOf(all[part].Corners);
    ranks[part] = area / std::sqrt(std::max(counts[part], 1));
  }
  std::stable_sort(
    missing.begin(), missing.end(), [&](int a, int b) { return ranks[a] > ranks[b]; });
  std::vector<Part> parts;
  for (const int part : missing)
  {
    parts.push_back(all[part]);
  }
  mesh.TakeParts(missing);
  return parts;
}

} // namespace

std::vector<Part> Cut(PiercedMesh& mesh, double tolerance, const CutLimits& limits, int threads,
  const std::function<bool(double)>& progress)
{
  Yield yield(mesh, limits.LeastYield);
  std::vector<Part> parts = TakeInOrder(mesh, mesh.FindMissing());
  const std::vector<Point>& points = mesh.GetParts().GetPoints();
  Cutter cutter(mesh, tolerance);
  for (const Part& part : parts)
  {
    cutter.Add(part);
  }
  const std::size_t mostPoints = points.size() + limits.Points;
  const std::size_t mostEffort =
    std::min(limits.Effort, LeastEffort + EffortPerPart * parts.size());
  constexpr int passes = 2; // a part may succeed once others have
  for (int pass = 0; pass < passes && !parts.empty(); ++pass)
  {
    const std::size_t before = parts.size();
    const auto isDone = [&](const Part& part)
    {
      progress(static_cast<double>(cutter.GetEffort()) / static_cast<double>(mostEffort));
      const bool succeeds = yield.IsEnough(cutter.GetEffort()) && cutter.GetEffort() < mostEffort &&
        points.size() < mostPoints && cutter.TryPart(part);
      yield.Add(succeeds ? mesh.GetParts().AreaOf(part.Corners) : 0.0);
      return succeeds;
    };
    parts.erase(std::remove_if(parts.begin(), parts.end(), isDone), parts.end());
    if (parts.size() == before)
    {
      break;
    }
  }
  return cutter.GiveUp(parts, threads, [&](double) { return progress(1.0); });
}

} // namespace carving::helper
