// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Removes vertices from a PiercedMesh that were put on parts of M.
 */
#include "Core/Mesh/SortUnique.h"
#include "Helper/Enclosing/CellShape.h"
#include "Helper/Enclosing/PiercedMesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Vertex = PiercedMesh::Vertex;

/** The parts around a vertex, by triangles of M. */
class Umbrella
{
public:
  void Add(const Subdivision::Part& part, int vertex)
  {
    for (const int corner : part.Corners)
    {
      if (corner != vertex)
      {
        this->Edges.emplace_back(part.Parent, corner);
      }
    }
  }

  bool IsEmpty() const
  {
    return this->Edges.empty();
  }

  /**
   * The vertices to which the vertex may move so that each triangle of M stays the same: inside of
   * a triangle, along one of its edges; on the border of a triangle, along that border.
   */
  std::vector<int> FindTargets()
  {
    std::sort(this->Edges.begin(), this->Edges.end());
    std::vector<int> targets, common;
    for (auto begin = this->Edges.begin(); begin != this->Edges.end();)
    {
      const auto end = std::find_if(
        begin, this->Edges.end(), [&](const Edge& edge) { return edge.first != begin->first; });
      const std::vector<int> within = FindTargets(begin, end);
      common.clear();
      std::set_intersection(
        targets.begin(), targets.end(), within.begin(), within.end(), std::back_inserter(common));
      targets = begin == this->Edges.begin() ? within : common;
      begin = end;
    }
    return targets;
  }

private:
  using Edge = std::pair<int, int>; ///< the triangle of a part, and another corner of the part
  using At = std::vector<Edge>::const_iterator;

  /** The targets for one triangle, in ascending order. */
  static std::vector<int> FindTargets(At begin, const At& end)
  {
    std::vector<int> inside, border; // edges of two parts, and edges of one
    while (begin != end)
    {
      const At next = std::find_if(begin, end, [&](const Edge& edge) { return edge != *begin; });
      if (next - begin > 2)
      {
        return {};
      }
      (next - begin == 1 ? border : inside).push_back(begin->second);
      begin = next;
    }
    return border.empty() ? inside : border.size() == 2 ? border : std::vector<int>();
  }

  std::vector<Edge> Edges;
};

std::vector<int> FindNeighbors(const std::vector<Cell>& star, const Vertex& v)
{
  std::vector<int> neighbors;
  for (const Cell& cell : star)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (cell->vertex(i) != v)
      {
        neighbors.push_back(cell->vertex(i)->info().Index);
      }
    }
  }
  SortUnique(neighbors);
  return neighbors;
}

/** The least quality of the cells of a star after v has moved to u; 0 if one turns over. */
double FindQuality(
  const std::vector<Cell>& star, const Vertex& v, const Vertex& u, double quiteEnough)
{
  double least = HUGE_VAL;
  for (const Cell& cell : star)
  {
    if (cell->has_vertex(u))
    {
      continue;
    }
    if (!IsPositive(cell, cell->index(v), u->point()))
    {
      return 0.0;
    }
    least = std::min(least, QualityOf(MovedCorners(cell, cell->index(v), u->point())));
    if (least <= quiteEnough)
    {
      return least; // another neighbor is better
    }
  }
  return least;
}

} // namespace

int PiercedMesh::RemoveVertex(int vertex, const std::function<bool(int)>& mayMove)
{
  const Vertex v = this->Vertices[vertex];
  std::vector<Cell> star;
  this->Mesh.tds().incident_cells(v, std::back_inserter(star));
  std::vector<int> parts; // that have the vertex
  for (const Cell& cell : star)
  {
    if (this->Mesh.is_infinite(cell))
    {
      return -1;
    }
    for (const PartContact& contact : cell->info().All)
    {
      if (!this->IsOnWholeFace(cell, contact))
      {
        return -1;
      }
      if (contact.How.Face != cell->index(v))
      {
        parts.push_back(contact.Part);
      }
    }
  }
  SortUnique(parts);
  Umbrella umbrella;
  for (const int part : parts)
  {
    umbrella.Add(this->Parts.GetParts()[part], vertex);
  }
  int target = -1;
  double best = 0.0;
  for (const int u : umbrella.IsEmpty() ? FindNeighbors(star, v) : umbrella.FindTargets())
  {
    const double quality = mayMove(u) ? FindQuality(star, v, this->Vertices[u], best) : 0.0;
    target = quality > best ? u : target;
    best = std::max(best, quality);
  }
  if (target < 0)
  {
    return -1;
  }
  for (const int part : parts)
  {
    const Triangle& corners = this->Parts.GetParts()[part].Corners;
    if (std::find(corners.begin(), corners.end(), target) == corners.end())
    {
      this->Parts.MoveCorner(part, vertex, target);
    }
    else
    {
      this->Parts.Take(part);
    }
  }
  this->Collapse(star, v, this->Vertices[target]);
  this->DeleteVertex(vertex);
  return target;
}

/**
 * Moves a vertex to a neighbor. Cells at the edge between the two vertices vanish: the two faces of
 * such a cell that are not at the edge become one face. Every part that meets a cell of the star
 * has to be a face of this cell.
 */
void PiercedMesh::Collapse(const std::vector<Cell>& star, const Vertex& from, const Vertex& to)
{
  for (const Cell& cell : star)
  {
    if (!cell->has_vertex(to))
    {
      cell->set_vertex(cell->index(from), to);
      cell->info().Near = {};
      to->set_cell(cell);
      continue;
    }
    const int fromFace = cell->index(from), toFace = cell->index(to); // opposite to each
    const Cell kept = cell->neighbor(toFace), behind = cell->neighbor(fromFace);
    const int keptFace = kept->index(cell), behindFace = behind->index(cell);
    this->Mesh.tds().set_adjacency(kept, keptFace, behind, behindFace);
    for (int i = 0; i < 4; ++i)
    {
      cell->vertex(i)->set_cell(kept); // which may be all that is left around it
    }
    for (const PartContact& contact : cell->info().All)
    {
      if (contact.How.Face == fromFace)
      {
        kept->info().Add({ contact.Part, { false, keptFace } });
      }
      else if (contact.How.Face == toFace && !this->Mesh.is_infinite(behind))
      {
        behind->info().Add({ contact.Part, { false, behindFace } });
      }
    }
    this->Mesh.tds().delete_cell(cell);
  }
}

void PiercedMesh::DeleteVertex(int vertex)
{
  this->Mesh.tds().delete_vertex(this->Vertices[vertex]);
  this->Vertices[vertex] = Vertex();
  this->Free.push_back(vertex);
}

void PiercedMesh::ReplaceStar(int vertex, const std::vector<Cell>& star,
  const std::vector<std::array<Vertex, 4>>& cells, const std::vector<int>& gone,
  const std::vector<Subdivision::Part>& made)
{
  for (const int part : gone)
  {
    this->Parts.Take(part);
  }
  this->Refill(star, cells);
  this->DeleteVertex(vertex);
  for (const Subdivision::Part& part : made)
  {
    this->GivePart(part.Corners, part.Parent);
  }
}

void PiercedMesh::TakeParts(const std::vector<int>& parts)
{
  std::vector<char> isTaken(this->Parts.GetParts().size(), 0);
  for (const int part : parts)
  {
    isTaken[part] = 1;
    this->Parts.Take(part);
  }
  for (const Cell cell : this->Mesh.finite_cell_handles())
  {
    const std::vector<PartContact> contacts = cell->info().All;
    for (const PartContact& contact : contacts)
    {
      if (isTaken[contact.Part])
      {
        cell->info().Remove(contact.Part);
      }
    }
  }
}

void PiercedMesh::GivePart(const Triangle& corners, int parent)
{
  this->Settle(this->Parts.Give(corners, parent));
}

void PiercedMesh::GiveParts(const std::vector<Subdivision::Part>& parts, int threads,
  const std::function<bool(double)>& progress)
{
  std::vector<int> given;
  for (const auto& [corners, parent] : parts)
  {
    given.push_back(this->Parts.Give(corners, parent));
  }
  this->SettleAll(std::move(given), threads, progress);
}

} // namespace carving::helper
