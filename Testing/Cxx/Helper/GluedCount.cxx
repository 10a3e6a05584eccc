// SPDX-License-Identifier: BSD-3-Clause
#include "GluedCount.h"

#include "DisjointSets.h"

#include <algorithm>
#include <vector>

using namespace carving;

std::array<int, 2> CountGlued(const Tetrahedralization& mesh, const Stream& stream, int step)
{
  const int numberOfCells = static_cast<int>(mesh.Cells.size());
  const auto isLeft = [&](int cell) { return cell >= 0 && stream.Step[cell] > step; };
  constexpr int edges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
  DisjointSets cells(numberOfCells), corners(4 * numberOfCells), sides(6 * numberOfCells);
  int characteristic = 0;
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    if (!isLeft(cell))
    {
      continue;
    }
    --characteristic;
    for (int f = 0; f < 4; ++f)
    {
      const int other = mesh.Neighbors[cell][f];
      if (!isLeft(other) || other > cell)
      {
        ++characteristic; // each face once
        continue;
      }
      cells.Unite(cell, other);
      const auto find = [&](int corner)
      {
        const auto& c = mesh.Cells[other];
        return static_cast<int>(
          std::find(c.begin(), c.end(), mesh.Cells[cell][corner]) - c.begin());
      };
      for (int corner = 0; corner < 4; ++corner)
      {
        if (corner != f)
        {
          corners.Unite(4 * cell + corner, 4 * other + find(corner));
        }
      }
      for (int e = 0; e < 6; ++e)
      {
        if (edges[e][0] != f && edges[e][1] != f)
        {
          const auto [p, q] = std::minmax({ find(edges[e][0]), find(edges[e][1]) });
          const int otherEdge = static_cast<int>(
            std::find_if(edges, edges + 6,
              [p = p, q = q](const int(&x)[2]) { return x[0] == p && x[1] == q; }) -
            edges);
          sides.Unite(6 * cell + e, 6 * other + otherEdge);
        }
      }
    }
  }
  int components = 0;
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    for (int i = 0; i < 6 && isLeft(cell); ++i)
    {
      components += i < 1 && cells.Find(cell) == cell;
      characteristic += i < 4 && corners.Find(4 * cell + i) == 4 * cell + i;
      characteristic -= sides.Find(6 * cell + i) == 6 * cell + i;
    }
  }
  // Each component has an outer surface, and one for each of its voids. Two faces meet in an edge.
  DisjointSets faces(4 * numberOfCells);
  std::vector<int> faceAt(6 * numberOfCells, -1);
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    for (int i = 0; i < 24 && isLeft(cell); ++i)
    {
      const int f = i / 6, e = i % 6;
      if (!isLeft(mesh.Neighbors[cell][f]) && edges[e][0] != f && edges[e][1] != f)
      {
        int& other = faceAt[sides.Find(6 * cell + e)];
        other = other < 0 ? 4 * cell + f : other;
        faces.Unite(other, 4 * cell + f);
      }
    }
  }
  int surfaces = 0;
  for (int face = 0; face < 4 * numberOfCells; ++face)
  {
    surfaces +=
      isLeft(face / 4) && !isLeft(mesh.Neighbors[face / 4][face % 4]) && faces.Find(face) == face;
  }
  return { components, surfaces - characteristic };
}
