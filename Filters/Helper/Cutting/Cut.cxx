// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Cutting/Cut.h"

#include "Core/Mesh/Vector.h"
#include "Helper/Cutting/Patch.h"

#include <algorithm>
#include <cmath>
#include <set>

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

  /** Gives the part back as it is, except for vertices on its edges. */
  void GiveUp(const Part& part);

  std::size_t GetEffort() const
  {
    return this->Mesh.GetEffort();
  }

private:
  bool TryOnce(const Part& part);

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

void Cutter::GiveUp(const Part& part)
{
  std::vector<Triangle> stack = { part.Corners };
  // Where vertices nearly coincide, each of two edges may be divided at an end of the other one.
  std::set<Triangle> known;
  while (!stack.empty())
  {
    const Triangle t = stack.back();
    stack.pop_back();
    const bool isNew = known.insert(t).second;
    std::vector<int> chain;
    int side = 0;
    for (; isNew && side < 3 && chain.empty(); ++side)
    {
      this->Mesh.GetChains().Append(t[side], t[(side + 1) % 3], chain);
    }
    if (chain.empty())
    {
      this->Mesh.GetMesh().GivePart(t, part.Parent);
      continue;
    }
    // A fan from the corner that is opposite to the side before.
    const int first = t[side - 1], last = t[side % 3], apex = t[(side + 1) % 3];
    chain.insert(chain.begin(), first);
    chain.push_back(last);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    {
      const Triangle piece = { chain[i], chain[i + 1], apex };
      if (piece[0] != apex && piece[1] != apex)
      {
        stack.push_back(piece);
      }
    }
  }
}

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
    const auto [a, b, c] = mesh.GetParts().GetCorners(part);
    ranks[part] = Length(Cross(b - a, c - a)) / std::sqrt(std::max(counts[part], 1));
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

std::size_t Cut(PiercedMesh& mesh, double tolerance, const CutLimits& limits,
  const std::function<bool(double)>& progress)
{
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
      return cutter.GetEffort() < mostEffort && points.size() < mostPoints && cutter.TryPart(part);
    };
    parts.erase(std::remove_if(parts.begin(), parts.end(), isDone), parts.end());
    if (parts.size() == before)
    {
      break;
    }
  }
  for (const Part& part : parts)
  {
    cutter.GiveUp(part);
  }
  return cutter.GetEffort();
}

} // namespace carving::helper
