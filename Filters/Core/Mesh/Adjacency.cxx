// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Adjacency.h"

#include <algorithm>
#include <numeric>

namespace carving
{
namespace
{

template <int D>
struct Face
{
  std::array<int, D> Corners; ///< ascending
  int Cell;                   ///< -1 for a facet of M
  int Index;                  ///< the corner that it is opposite to, or the facet

  bool operator<(const Face& other) const
  {
    return this->Corners != other.Corners ? this->Corners < other.Corners
      : this->Cell != other.Cell          ? this->Cell < other.Cell
                                          : this->Index < other.Index;
  }
};

template <int D>
Face<D> MakeFace(std::array<int, D> corners, int cell, int index)
{
  std::sort(corners.begin(), corners.end());
  return { corners, cell, index };
}

/** Equal faces come to lie side by side: bucketed by the first corner, then sorted. */
template <int D>
std::vector<Face<D>> SortFaces(const Decomposition<D>& mesh)
{
  std::vector<Face<D>> faces;
  faces.reserve(mesh.Surface.Facets.size() + (D + 1) * mesh.Cells.size());
  for (std::size_t i = 0; i < mesh.Surface.Facets.size(); ++i)
  {
    faces.push_back(MakeFace<D>(mesh.Surface.Facets[i], -1, static_cast<int>(i)));
  }
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      const int index = static_cast<int>(cell);
      faces.push_back(MakeFace<D>(mesh.OutwardFace(index, f), index, f));
    }
  }
  std::vector<int> ends(mesh.Surface.Points.size() + 1, 0);
  for (const Face<D>& face : faces)
  {
    ++ends[face.Corners[0] + 1];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  const std::vector<int> begins = ends;
  std::vector<Face<D>> sorted(faces.size());
  for (const Face<D>& face : faces)
  {
    sorted[ends[face.Corners[0]]++] = face;
  }
  for (std::size_t vertex = 0; vertex + 1 < begins.size(); ++vertex)
  {
    std::sort(sorted.begin() + begins[vertex], sorted.begin() + begins[vertex + 1]);
  }
  return sorted;
}

} // namespace

template <int D>
bool FindAdjacency(Decomposition<D>& mesh)
{
  typename Decomposition<D>::Cell none;
  none.fill(-1);
  mesh.Neighbors.assign(mesh.Cells.size(), none);
  mesh.Constraints.assign(mesh.Cells.size(), none);
  const std::vector<Face<D>> faces = SortFaces(mesh);
  for (auto first = faces.begin(); first != faces.end();)
  {
    auto last = std::find_if(
      first, faces.end(), [&](const Face<D>& face) { return face.Corners != first->Corners; });
    const int facet = first->Cell < 0 ? first->Index : -1;
    const auto cells = first + (facet >= 0 ? 1 : 0);
    const auto count = last - cells;
    if (count > 2 || (count > 0 && cells->Cell < 0))
    {
      return false;
    }
    for (auto face = cells; face != last; ++face)
    {
      mesh.Constraints[face->Cell][face->Index] = facet;
    }
    if (count == 2)
    {
      mesh.Neighbors[cells[0].Cell][cells[0].Index] = cells[1].Cell;
      mesh.Neighbors[cells[1].Cell][cells[1].Index] = cells[0].Cell;
    }
    first = last;
  }
  return true;
}

template bool FindAdjacency<2>(Decomposition<2>&);
template bool FindAdjacency<3>(Decomposition<3>&);

} // namespace carving
