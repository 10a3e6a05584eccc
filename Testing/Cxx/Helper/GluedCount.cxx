// SPDX-License-Identifier: BSD-3-Clause
#include "GluedCount.h"

#include "Core/Mesh/DisjointSets.h"

using namespace carving;

int CountGlued(const Tetrahedralization& mesh, const Stream& stream, int step)
{
  const int numberOfCells = static_cast<int>(mesh.Cells.size());
  const auto isRemaining = [&](int cell) { return cell >= 0 && stream.Step[cell] > step; };
  DisjointSets sets(numberOfCells);
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    for (const int neighbor : mesh.Neighbors[cell])
    {
      if (isRemaining(cell) && isRemaining(neighbor))
      {
        sets.Unite(cell, neighbor);
      }
    }
  }
  int components = 0;
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    components += isRemaining(cell) && sets.Find(cell) == cell;
  }
  return components;
}
