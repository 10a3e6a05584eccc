// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/ThinFaces.h"

#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/FacetTree.h"

#include <algorithm>

namespace carving
{
namespace
{

/** Whether the least height of a face is at most the width of a crack. */
bool IsThin(const FacetCorners<3>& face, double width)
{
  const Point sides[] = { face[1] - face[0], face[2] - face[1], face[0] - face[2] };
  const Point normal = Cross(sides[0], sides[1]); // twice the area long
  const double longest =
    std::max({ Dot(sides[0], sides[0]), Dot(sides[1], sides[1]), Dot(sides[2], sides[2]) });
  return Dot(normal, normal) <= width * width * longest;
}

/** Whether each height of a cell is greater than the width of a crack. */
bool IsThick(const Tetrahedralization& mesh, int cell, double width)
{
  double largest = 0.0;
  for (int f = 0; f < 4; ++f)
  {
    largest = std::max(largest, Size(CornersOf<3>(mesh.Surface.Points, mesh.OutwardFace(cell, f))));
  }
  return 3.0 * Size(CornersOfCell(mesh, cell)) > width * largest;
}

} // namespace

CellFace OtherSide(const Tetrahedralization& mesh, const CellFace& face)
{
  const int other = mesh.Neighbors[face.Cell][face.Face];
  if (other < 0)
  {
    return { other, 0 };
  }
  const auto& back = mesh.Neighbors[other];
  return { other, static_cast<int>(std::find(back.begin(), back.end(), face.Cell) - back.begin()) };
}

std::vector<CellFace> FindThinFaces(
  const Tetrahedralization& mesh, const Classification& regions, double width)
{
  std::vector<CellFace> faces;
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; regions.Kind(cell) == RegionKind::Outside && f < 4; ++f)
    {
      const int neighbor = mesh.Neighbors[cell][f];
      const bool isOfOther = neighbor >= 0 && (neighbor < cell || mesh.IsKept(neighbor));
      if (isOfOther || mesh.Constraints.Has(cell, f))
      {
        continue;
      }
      if (IsThin(CornersOf<3>(mesh.Surface.Points, mesh.OutwardFace(cell, f)), width))
      {
        faces.push_back({ cell, f });
      }
    }
  }
  return faces;
}

std::vector<char> FindThickRegions(
  const Tetrahedralization& mesh, const Classification& regions, double width)
{
  std::vector<char> thick(regions.Regions.size(), 0);
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    char& isThick = thick[regions.RegionOfCell[cell]];
    isThick = isThick || IsThick(mesh, cell, width);
  }
  return thick;
}

} // namespace carving
