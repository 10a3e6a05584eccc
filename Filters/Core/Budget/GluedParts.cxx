// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Budget/GluedParts.h"

#include "Core/Budget/EdgeRotation.h"

namespace carving
{

GluedParts::GluedParts(const Decomposition<3>& mesh, const RemainingCells<3>& cells)
  : Cells(cells)
  , Graph(cells)
  , OnSurface(mesh.Surface.Points.size(), 0)
{
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      if (cells.GetNeighbor(cell, f) == Outside)
      {
        for (const int vertex : mesh.OutwardFace(cell, f))
        {
          this->OnSurface[vertex] = 1;
        }
      }
    }
  }
}

/** Whether all tetrahedra around the edge between two corners of a cell remain. */
bool GluedParts::IsBuried(int cell, int p, int q) const
{
  const auto& corners = this->Cells.Records[cell].Corners;
  return !this->OnSurface[corners[p]] || !this->OnSurface[corners[q]] ||
    !AnyAroundEdge(this->Cells, cell, p, q,
      [this](const auto& next) { return !this->Cells.IsRemaining(next.Cell); });
}

Labels<4> GluedParts::Examine(int cell)
{
  Labels<4> labels;
  for (int f = 0; f < 4; ++f)
  {
    labels[f] = this->Cells.IsRemaining(this->Cells.GetNeighbor(cell, f)) ? f : -1;
  }
  for (int f = 1; f < 4; ++f)
  {
    for (int g = 0; g < f; ++g)
    {
      if (labels[f] >= 0 && labels[g] >= 0 && labels[f] != labels[g])
      {
        const auto [q, p] = OtherCorners(f, g);
        if (this->IsBuried(cell, p, q))
        {
          MergeLabels(labels, labels[f], labels[g]);
        }
      }
    }
  }
  if (this->Exact && CountLabels(labels) > 1)
  {
    this->Search.Join(this->Graph, cell, labels);
  }
  return labels;
}

void GluedParts::Carve(int cell, const Labels<4>& labels)
{
  this->Components += CountLabels(labels) - 1;
  this->Graph.Carve(cell);
  for (const int vertex : this->Cells.Records[cell].Corners)
  {
    this->OnSurface[vertex] = 1;
  }
}

void GluedParts::MakeExact()
{
  this->Exact = true;
  if (this->Components > 1)
  {
    this->Components = this->Graph.CountComponents();
  }
}

} // namespace carving
