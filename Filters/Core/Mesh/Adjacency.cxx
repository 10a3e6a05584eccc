// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Adjacency.h"

#include "Core/Mesh/Buckets.h"

#include <algorithm>

namespace carving
{
namespace
{

template <int D>
struct Face
{
  std::array<int, D> Corners; ///< ascending
  int Cell;                   ///< -1 for a facet of M
  int Index;                  ///< the opposite corner of the cell, or the facet

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

/** The faces of all cells and the facets of M, by their first corner. */
template <int D>
Buckets<Face<D>> CollectFaces(const Decomposition<D>& mesh)
{
  return { mesh.Surface.Points.size(),
    [&](auto&& visit)
    {
      const auto add = [&](const Face<D>& face) { visit(face.Corners[0], face); };
      for (std::size_t i = 0; i < mesh.Surface.Facets.size(); ++i)
      {
        add(MakeFace<D>(mesh.Surface.Facets[i], -1, static_cast<int>(i)));
      }
      for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
      {
        for (int f = 0; f <= D; ++f)
        {
          add(MakeFace<D>(mesh.OutwardFace(cell, f), cell, f));
        }
      }
    } };
}

/**
 * Connects the cells of equal faces. A facet of M comes first. `constraints` has the facets of each
 * cell. Returns false if the faces do not fit.
 */
template <int D>
bool Connect(const Face<D>* first, const Face<D>* last, Decomposition<D>& mesh,
  std::vector<typename FaceConstraints<D>::Facets>& constraints)
{
  const int facet = first->Cell < 0 ? first->Index : -1;
  const Face<D>* cells = first + (facet >= 0 ? 1 : 0);
  const auto count = last - cells;
  if (count > 2 || (count > 0 && cells->Cell < 0))
  {
    return false;
  }
  for (const Face<D>* face = cells; face != last; ++face)
  {
    constraints[face->Cell][face->Index] = facet;
  }
  if (count == 2)
  {
    mesh.Neighbors[cells[0].Cell][cells[0].Index] = cells[1].Cell;
    mesh.Neighbors[cells[1].Cell][cells[1].Index] = cells[0].Cell;
  }
  return true;
}

} // namespace

template <int D>
bool FindAdjacency(Decomposition<D>& mesh)
{
  typename Decomposition<D>::Cell none;
  none.fill(-1);
  mesh.Neighbors.assign(mesh.Cells.size(), none);
  std::vector<typename FaceConstraints<D>::Facets> constraints(mesh.Cells.size(), none);
  Buckets<Face<D>> faces = CollectFaces(mesh);
  for (int vertex = 0; vertex < faces.GetNumberOfBuckets(); ++vertex)
  {
    const auto bucket = faces[vertex];
    std::sort(bucket.begin(), bucket.end());
    for (auto first = bucket.begin(); first != bucket.end();)
    {
      const auto last = std::find_if(
        first, bucket.end(), [&](const Face<D>& face) { return face.Corners != first->Corners; });
      if (!Connect(&*first, &*first + (last - first), mesh, constraints))
      {
        return false;
      }
      first = last;
    }
  }
  mesh.Constraints = FaceConstraints<D>(constraints);
  return true;
}

template bool FindAdjacency<2>(Decomposition<2>&);
template bool FindAdjacency<3>(Decomposition<3>&);

} // namespace carving
