// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Exact/EdgeSplitter.h"

#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/Kernels.h"
#include "Helper/Base/SortedEdge.h"

#include <algorithm>

namespace carving::helper
{

EdgeSplitter::EdgeSplitter(const std::vector<Edge>& edges, Tetrahedralization& mesh)
  : Mesh(mesh)
{
  std::vector<char> isEnd(mesh.Surface.Points.size(), 0); // most edges need no search
  for (const auto& [a, b] : edges)
  {
    isEnd[a] = isEnd[b] = 1;
  }
  const int count = static_cast<int>(mesh.Cells.size());
  this->Constraints.reserve(mesh.Cells.size());
  for (int cell = 0; cell < count; ++cell)
  {
    this->Constraints.push_back(mesh.Constraints.Get(cell));
    for (const Edge& edge : EdgesOf(mesh.Cells[cell]))
    {
      if (isEnd[edge[0]] && isEnd[edge[1]] && std::binary_search(edges.begin(), edges.end(), edge))
      {
        this->CellsAround[edge].push_back(cell);
      }
    }
  }
}

bool EdgeSplitter::Split(const Edge& edge, double share, double room)
{
  constexpr int places = 200; // rounding turns flat tetrahedra over at about every other one
  std::vector<Point>& points = this->Mesh.Surface.Points;
  const Point &a = points[edge[0]], &b = points[edge[1]];
  const double farthest = room / Length(b - a);
  for (int i = 0; i < places; ++i)
  {
    const double offset = (i % 2 == 0 ? farthest : -farthest) * i / places;
    const Point p = Between(a, b, share + offset);
    if (this->MaySplitAt(edge, p))
    {
      points.push_back(p);
      this->Mesh.Surface.PointSources.push_back(-1);
      this->SplitAt(edge, static_cast<int>(points.size()) - 1);
      return true;
    }
  }
  return false;
}

void EdgeSplitter::Finish()
{
  this->Mesh.Constraints = FaceConstraints<3>(this->Constraints);
}

int EdgeSplitter::CornerOf(int cell, int point) const
{
  const auto& c = this->Mesh.Cells[cell];
  return static_cast<int>(std::find(c.begin(), c.end(), point) - c.begin());
}

/** Whether both parts of each tetrahedron around an edge are positively oriented. */
bool EdgeSplitter::MaySplitAt(const Edge& edge, const Point& p) const
{
  const std::vector<int>& ring = this->CellsAround.at(edge);
  return std::all_of(ring.begin(), ring.end(),
    [&](int cell)
    {
      return std::all_of(edge.begin(), edge.end(),
        [&](int end)
        {
          auto corners = CornersOfCell(this->Mesh, cell);
          corners[this->CornerOf(cell, end)] = p;
          return CGAL::orientation(ToInexact(corners[0]), ToInexact(corners[1]),
                   ToInexact(corners[2]), ToInexact(corners[3])) == CGAL::POSITIVE;
        });
    });
}

/** Each cell around an edge becomes the part at its lower end. The other parts are appended. */
void EdgeSplitter::SplitAt(const Edge& edge, int point)
{
  const std::vector<int> ring = this->CellsAround.at(edge);
  this->CellsAround.erase(edge);
  UpperFacets upperFacets;
  const int first = static_cast<int>(this->Mesh.Cells.size());
  for (const int lower : ring)
  {
    const int upper = this->SplitCell(lower, edge, point, upperFacets);
    for (int& neighbor : this->Mesh.Neighbors[upper])
    {
      const auto place = std::find(ring.begin(), ring.end(), neighbor);
      if (neighbor != lower && place != ring.end())
      {
        neighbor = first + static_cast<int>(place - ring.begin());
      }
    }
  }
}

/** Returns the part at the upper end, whose neighbors around the edge are those of the cell. */
int EdgeSplitter::SplitCell(int lower, const Edge& edge, int point, UpperFacets& upperFacets)
{
  auto& cells = this->Mesh.Cells;
  auto& neighbors = this->Mesh.Neighbors;
  const int upper = static_cast<int>(cells.size());
  this->UpdateCellsAround(lower, upper, edge);
  const int atA = this->CornerOf(lower, edge[0]), atB = this->CornerOf(lower, edge[1]);
  cells.push_back(cells[lower]);
  neighbors.push_back(neighbors[lower]);
  this->Constraints.push_back(this->Constraints[lower]);
  if (!this->Mesh.Kept.empty())
  {
    this->Mesh.Kept.push_back(this->Mesh.Kept[lower]);
  }
  this->SplitFacets(lower, upper, edge, point, upperFacets);
  cells[lower][atB] = point;
  cells[upper][atA] = point;
  // The face opposite to the lower end is one of the upper part.
  const int beyond = neighbors[upper][atA];
  if (beyond >= 0)
  {
    std::replace(neighbors[beyond].begin(), neighbors[beyond].end(), lower, upper);
  }
  neighbors[lower][atA] = upper;
  neighbors[upper][atB] = lower;
  this->Constraints[lower][atA] = this->Constraints[upper][atB] = -1;
  return upper;
}

/** Splits the facets at the edge on which faces of a cell lie, unless another cell has done so. */
void EdgeSplitter::SplitFacets(
  int lower, int upper, const Edge& edge, int point, UpperFacets& upperFacets)
{
  ResolvedMesh& surface = this->Mesh.Surface;
  for (const int opposite :
    OtherCorners(this->CornerOf(lower, edge[0]), this->CornerOf(lower, edge[1])))
  {
    const int facet = this->Constraints[lower][opposite];
    if (facet < 0)
    {
      continue;
    }
    const auto [entry, isNew] = upperFacets.emplace(facet, static_cast<int>(surface.Facets.size()));
    if (isNew)
    {
      Triangle part = surface.Facets[facet];
      std::replace(part.begin(), part.end(), edge[0], point);
      AppendFacet<3>(surface, facet, part, surface);
      std::replace(surface.Facets[facet].begin(), surface.Facets[facet].end(), edge[1], point);
    }
    this->Constraints[upper][opposite] = entry->second;
  }
}

/** Takes over for the other edges of a cell that it will be divided at one of them. */
void EdgeSplitter::UpdateCellsAround(int lower, int upper, const Edge& edge)
{
  for (const Edge& other : EdgesOf(this->Mesh.Cells[lower]))
  {
    const auto around = this->CellsAround.find(other);
    const auto has = [&](int end) { return other[0] == end || other[1] == end; };
    if (around == this->CellsAround.end() || has(edge[0]))
    {
      continue;
    }
    if (has(edge[1]))
    {
      std::replace(around->second.begin(), around->second.end(), lower, upper);
    }
    else
    {
      around->second.push_back(upper);
    }
  }
}

} // namespace carving::helper
