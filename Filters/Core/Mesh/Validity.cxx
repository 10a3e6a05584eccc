// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Validity.h"

#include "Core/Mesh/Fetch.h"
#include "Core/Mesh/ForEach.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

namespace carving
{
bool AreFinite(const std::vector<Point>& points)
{
  bool finite = true;
  for (const Point& p : points)
  {
    finite &= std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  }
  return finite;
}

namespace
{

/**
 * A signed multiplicity is a sum of as many signs as the multiplicity. The sum of all must not
 * overflow.
 */
template <int D>
bool MultiplicitiesArePossible(const ResolvedInput<D>& input)
{
  long long sum = 0;
  for (std::size_t i = 0; i < input.Multiplicities.size(); ++i)
  {
    if (input.Multiplicities[i] < 0 ||
      std::abs(static_cast<long long>(input.SignedMultiplicities[i])) > input.Multiplicities[i])
    {
      return false;
    }
    sum += input.Multiplicities[i];
  }
  return sum <= std::numeric_limits<int>::max();
}

/** The first mistake in points and facets, regardless of cells. */
template <int D>
std::string FindMistake(const ResolvedInput<D>& input)
{
  const std::size_t facets = input.Facets.size();
  if (input.PointSources.size() != input.Points.size() || input.FacetSources.size() != facets ||
    input.SignedMultiplicities.size() != facets || input.Multiplicities.size() != facets)
  {
    return "arrays that belong together differ in length";
  }
  if (!IndicesWithin(input.Facets, 0, input.Points.size()))
  {
    return "a vertex index is out of range";
  }
  return !CornersDiffer(input.Facets)   ? "a facet has a corner twice"
    : !AreFinite(input.Points)          ? "a coordinate is not finite"
    : !MultiplicitiesArePossible(input) ? "a facet has an impossible multiplicity"
                                        : "";
}

/** A bit per corner of a cell, set if the corner is not one of the face. Branch-free for speed. */
template <int D>
unsigned int CornersApart(const std::array<int, D + 1>& cell, const std::array<int, D>& face)
{
  unsigned int apart = 0;
  for (int corner = 0; corner <= D; ++corner)
  {
    bool found = false;
    for (const int vertex : face)
    {
      found |= cell[corner] == vertex;
    }
    apart |= static_cast<unsigned int>(!found) << corner;
  }
  return apart;
}

/** The corner of a cell opposite to a face with these corners; -1 if the cell has no such face. */
template <int D>
int FindOpposite(const std::array<int, D + 1>& cell, const std::array<int, D>& face)
{
  constexpr int corners[16] = { -1, 0, 1, -1, 2, -1, -1, -1, 3, -1, -1, -1, -1, -1, -1, -1 };
  return corners[CornersApart<D>(cell, face)];
}

/** Whether the bits, the counts and the list of a mesh's constraints belong together. */
template <int D>
bool IsConsistent(const FaceConstraints<D>& constraints)
{
  constexpr std::uint32_t allFaces = D == 3 ? 0xffffffffu : 0x77777777u;
  if (constraints.NumberOfCells < 0 ||
    constraints.Blocks.size() != (static_cast<std::size_t>(constraints.NumberOfCells) + 7) / 8)
  {
    return false;
  }
  std::size_t count = 0;
  for (std::size_t block = 0; block < constraints.Blocks.size(); ++block)
  {
    const auto [faces, before] = constraints.Blocks[block];
    const int cells = constraints.NumberOfCells - static_cast<int>(8 * block);
    const std::uint32_t present = cells < 8 ? (std::uint32_t{ 1 } << (4 * cells)) - 1 : allFaces;
    if (before < 0 || static_cast<std::size_t>(before) != count ||
      (faces & ~(allFaces & present)) != 0)
    {
      return false;
    }
    count += std::bitset<32>(faces).count();
  }
  return count == constraints.OfFaces.size();
}

/** The faces between cells that have been compared. */
struct ComparedFaces
{
  int FromBelow = 0; ///< faces of the cells with the lower indices
  int FromAbove = 0; ///< faces of the cells with the higher indices
  bool Agree = true;
};

/** Compares the faces of a range of cells with those of their neighbors of higher index. */
template <int D>
ComparedFaces CompareFaces(const Decomposition<D>& mesh, int first, int last)
{
  ComparedFaces result;
  for (int cell = first; cell < last; ++cell)
  {
    FetchAhead(mesh, cell, mesh.Cells, mesh.Neighbors);
    for (int f = 0; f <= D; ++f)
    {
      const int neighbor = mesh.Neighbors[cell][f];
      if (neighbor <= cell)
      {
        result.Agree &= neighbor != cell;
        result.FromAbove += neighbor >= 0;
        continue;
      }
      ++result.FromBelow;
      const int g = FindOpposite<D>(mesh.Cells[neighbor], mesh.OutwardFace(cell, f));
      if (g < 0 || mesh.Neighbors[neighbor][g] != cell ||
        mesh.Constraints.Get(neighbor, g) != mesh.Constraints.Get(cell, f))
      {
        result.Agree = false;
        return result;
      }
    }
  }
  return result;
}

/**
 * Whether both cells of every face agree on its corners, its cells and its constraint.
 *
 * Each face is compared once, by its cell with the lower index. No two cells match the same face of
 * a neighbor. If the cells with the higher index have as many faces, all of them have been
 * compared.
 */
template <int D>
bool NeighborsAgree(const Decomposition<D>& mesh, int threads)
{
  const long long numberOfCells = static_cast<long long>(mesh.Cells.size());
  std::vector<ComparedFaces> parts(std::max(threads, 1));
  ForEach(threads, static_cast<int>(parts.size()),
    [&](int i)
    {
      const auto begin = [&](int part)
      { return static_cast<int>(part * numberOfCells / static_cast<int>(parts.size())); };
      parts[i] = CompareFaces(mesh, begin(i), begin(i + 1));
    });
  ComparedFaces all;
  for (const ComparedFaces& part : parts)
  {
    all.FromBelow += part.FromBelow;
    all.FromAbove += part.FromAbove;
    all.Agree &= part.Agree;
  }
  return all.Agree && all.FromBelow == all.FromAbove;
}

/**
 * Whether a cell's face on a facet has no solid on the cell's side, and has missing solid on the
 * far side if and only if the neighbor there is Solid.
 */
template <int D>
bool AgreesWithSolid(const Decomposition<D>& mesh, int cell, int f, const std::array<int, 2>& solid)
{
  const int side = SideOfFacet(mesh, cell, f);
  return solid[side] < 0 && (solid[1 - side] >= 0) == (mesh.Neighbors[cell][f] == Solid);
}

/**
 * Whether every facet is exactly one face, either on the boundary or between two cells, and missing
 * solid adjoins cells at facets only. A facet inside the missing solid is no face of a cell.
 */
template <int D>
bool FacetsAreFaces(const Decomposition<D>& mesh, const std::vector<std::array<int, 2>>& solidSides)
{
  constexpr int none = -1;
  std::vector<int> cells(mesh.Surface.Facets.size(), none);
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      const int facet = mesh.Constraints.Get(cell, f);
      if (facet < 0)
      {
        if (mesh.Neighbors[cell][f] == Solid)
        {
          return false;
        }
        continue;
      }
      const std::array<int, D> face = mesh.OutwardFace(cell, f);
      const std::array<int, D>& corners = mesh.Surface.Facets[facet];
      if (!std::is_permutation(face.begin(), face.end(), corners.begin()) ||
        (cells[facet] != none && cells[facet] != mesh.Neighbors[cell][f]) ||
        (!solidSides.empty() && !AgreesWithSolid(mesh, cell, f, solidSides[facet])))
      {
        return false;
      }
      cells[facet] = cell;
    }
  }
  for (std::size_t facet = 0; facet < solidSides.size(); ++facet)
  {
    const auto [behind, inFront] = solidSides[facet];
    if (cells[facet] == none && behind < 0 && inFront < 0)
    {
      return false;
    }
  }
  return !solidSides.empty() || std::find(cells.begin(), cells.end(), none) == cells.end();
}

} // namespace

template <int D>
std::string FindMistake(
  const Decomposition<D>& mesh, const std::vector<std::array<int, 2>>& solidSides, int threads)
{
  for (const ResolvedInput<D>* input : { &mesh.Surface, &mesh.Unresolved })
  {
    const std::string mistake = FindMistake(*input);
    if (!mistake.empty())
    {
      return mistake;
    }
  }
  if (mesh.Neighbors.size() != mesh.Cells.size() ||
    static_cast<std::size_t>(mesh.Constraints.NumberOfCells) != mesh.Cells.size() ||
    (!mesh.Kept.empty() && mesh.Kept.size() != mesh.Cells.size()) ||
    mesh.MetShares.size() != mesh.Unresolved.Facets.size() ||
    (!solidSides.empty() && solidSides.size() != mesh.Surface.Facets.size()))
  {
    return "arrays that belong together differ in length";
  }
  if (mesh.Cells.size() > static_cast<std::size_t>(MaximumCells))
  {
    return "there are too many cells";
  }
  if (!IsConsistent(mesh.Constraints))
  {
    return "the constraints are not consistent";
  }
  if (!IndicesWithin(mesh.Cells, 0, mesh.Surface.Points.size()))
  {
    return "a vertex index is out of range";
  }
  if (!IndicesWithin(mesh.Neighbors, solidSides.empty() ? Outside : Solid, mesh.Cells.size()) ||
    !IndicesWithin(mesh.Constraints.OfFaces, 0, mesh.Surface.Facets.size()))
  {
    return "a neighbor or constraint index is out of range";
  }
  if (!CornersDiffer(mesh.Cells))
  {
    return "a cell has a corner twice";
  }
  if (!NeighborsAgree(mesh, threads))
  {
    return "neighboring tetrahedra disagree about their common face";
  }
  if (!FacetsAreFaces(mesh, solidSides))
  {
    return "a facet does not match exactly one face";
  }
  return {};
}

template std::string FindMistake<2>(
  const Decomposition<2>&, const std::vector<std::array<int, 2>>&, int);
template std::string FindMistake<3>(
  const Decomposition<3>&, const std::vector<std::array<int, 2>>&, int);

} // namespace carving
