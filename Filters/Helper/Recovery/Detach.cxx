// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/Detach.h"

#include "Core/Mesh/SortUnique.h"
#include "Helper/Recovery/SpaceFilling.h"
#include "Helper/Recovery/VertexWalls.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <random>
#include <set>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Vertex = PiercedMesh::Vertex;

/**
 * Whether each edge of a border belongs to two of its triangles. The border is open if rounding has
 * put the vertex at a corner of three triangles of M, of which none continues another.
 */
bool IsClosed(const Border& border)
{
  using Edge = std::array<int, 3>; // the lesser end, the greater one, and the direction: 1 or -1
  std::vector<Edge> edges;
  edges.reserve(3 * border.size());
  for (const VertexTriangle& t : border)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int a = t[i]->info().Index, b = t[(i + 1) % 3]->info().Index;
      edges.push_back(a < b ? Edge{ a, b, 1 } : Edge{ b, a, -1 });
    }
  }
  std::sort(edges.begin(), edges.end());
  int sum = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (i > 0 && (edges[i][0] != edges[i - 1][0] || edges[i][1] != edges[i - 1][1]) && sum != 0)
    {
      return false;
    }
    sum += edges[i][2];
  }
  return sum == 0;
}

/** Whether both sides of a triangle are walls of the same space. */
bool HasBothSides(const Border& walls)
{
  std::vector<std::array<int, 3>> keys;
  for (const VertexTriangle& t : walls)
  {
    auto& key = keys.emplace_back(
      std::array<int, 3>{ t[0]->info().Index, t[1]->info().Index, t[2]->info().Index });
    std::sort(key.begin(), key.end());
  }
  std::sort(keys.begin(), keys.end());
  return std::adjacent_find(keys.begin(), keys.end()) != keys.end();
}

class Detacher
{
public:
  Detacher(PiercedMesh& mesh, int searches)
    : Mesh(mesh)
    , SearchesLeft(searches)
  {
  }

  /** Returns whether the vertex has been detached. */
  bool TryVertex(int vertex, bool mayTakeLong);

  /** The vertices around which cells have been replaced since the last call: 1 by index. */
  std::vector<char> TakeTouched();

private:
  bool IsInfinite(const Cell& cell) const
  {
    return this->Mesh.GetDelaunay().is_infinite(cell);
  }
  Border MakeBorder(const VertexWalls::Space& space, const Vertex& v) const;
  void Grow(VertexWalls::Space& space);
  std::optional<SpaceFilling> Fill(VertexWalls::Space& space, const Vertex& v, bool mayTakeLong);

  PiercedMesh& Mesh;
  std::set<Cell> Removed;
  std::vector<char> Touched;
  std::mt19937 Random;
  int SearchesLeft;
};

/** The walls of a space, and the faces at which it ends, except for those at `v`. */
Border Detacher::MakeBorder(const VertexWalls::Space& space, const Vertex& v) const
{
  std::vector<Cell> within = space.Cells;
  std::sort(within.begin(), within.end());
  Border border = space.Walls;
  for (const Cell& cell : space.Cells)
  {
    for (int f = 0; f < 4; ++f)
    {
      const auto& [a, b, c] = FaceCorners[f];
      const VertexTriangle inward = { cell->vertex(a), cell->vertex(c), cell->vertex(b) };
      const auto isEnd = [&]
      {
        return cell->info().PartOn(f) >= 0 ||
          !std::binary_search(within.begin(), within.end(), cell->neighbor(f));
      };
      if (!Has(inward, v) && isEnd())
      {
        border.push_back(inward);
      }
    }
  }
  return border;
}

/** Adds a ring of cells to a space, but none behind a part of M. */
void Detacher::Grow(VertexWalls::Space& space)
{
  const std::size_t count = space.Cells.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    for (int f = 0; f < 4; ++f)
    {
      const Cell cell = space.Cells[i], neighbor = cell->neighbor(f);
      if (!this->IsInfinite(neighbor) && cell->info().PartOn(f) < 0 &&
        this->Removed.insert(neighbor).second)
      {
        space.Cells.push_back(neighbor);
      }
    }
  }
}

/** Fills a space, which `v` saw as a whole when it was on the border. */
std::optional<SpaceFilling> Detacher::Fill(
  VertexWalls::Space& space, const Vertex& v, bool mayTakeLong)
{
  Border border = this->MakeBorder(space, v);
  if (!IsClosed(border))
  {
    return {};
  }
  if (this->IsInfinite(space.Cells.front()))
  {
    return MakeStar(border, this->Mesh.GetDelaunay().infinite_vertex(), CGAL::ORIGIN);
  }
  std::optional<SpaceFilling> filling;
  if (!HasBothSides(space.Walls)) // or no star could have the wall between its tetrahedra
  {
    filling = FillFromVertex(border);
    filling = filling ? filling : FillFromPoint(border, v->point());
  }
  constexpr int rings = 2, draws = 6;
  for (int ring = 0; ring <= rings && mayTakeLong && !filling; ++ring)
  {
    for (int points = 0; points < draws && !filling && this->SearchesLeft > 0; ++points)
    {
      --this->SearchesLeft;
      filling = SearchFilling(space.Cells, border, v, points, this->Random);
    }
    if (!filling)
    {
      this->Grow(space);
      border = this->MakeBorder(space, v);
    }
  }
  return filling;
}

bool Detacher::TryVertex(int vertex, bool mayTakeLong)
{
  const Vertex v = this->Mesh.GetVertex(vertex);
  VertexWalls walls(this->Mesh, v);
  if (!walls.Retriangulate())
  {
    return false;
  }
  std::vector<VertexWalls::Space> spaces = walls.GetSpaces();
  this->Removed.clear();
  if (mayTakeLong) // spaces grow only then
  {
    this->Removed.insert(walls.GetStar().begin(), walls.GetStar().end());
  }
  std::vector<SpaceFilling> fillings;
  for (VertexWalls::Space& space : spaces)
  {
    std::optional<SpaceFilling> filling = this->Fill(space, v, mayTakeLong);
    if (!filling)
    {
      return false;
    }
    fillings.push_back(std::move(*filling));
  }
  std::vector<Cell> old;
  std::vector<std::array<Vertex, 4>> cells;
  for (std::size_t s = 0; s < spaces.size(); ++s)
  {
    old.insert(old.end(), spaces[s].Cells.begin(), spaces[s].Cells.end());
    for (const std::array<int, 4>& cell : fillings[s].Cells)
    {
      auto& corners = cells.emplace_back();
      for (int i = 0; i < 4; ++i)
      {
        Vertex& corner = fillings[s].Vertices[cell[i]];
        corner =
          corner == Vertex() ? this->Mesh.AddVertex(ToPoint(fillings[s].Points[cell[i]])) : corner;
        corners[i] = corner;
      }
    }
  }
  this->Touched.resize(this->Mesh.GetParts().GetPoints().size(), 0);
  for (const Cell& cell : old)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (!this->Mesh.GetDelaunay().is_infinite(cell->vertex(i)))
      {
        this->Touched[cell->vertex(i)->info().Index] = 1;
      }
    }
  }
  this->Mesh.ReplaceStar(vertex, old, cells, walls.GetParts(), walls.MakeParts());
  return true;
}

std::vector<char> Detacher::TakeTouched()
{
  std::vector<char> touched;
  touched.swap(this->Touched);
  touched.resize(this->Mesh.GetParts().GetPoints().size(), 0);
  return touched;
}

/** The vertices that were put on M. */
std::vector<int> FindAdded(const PiercedMesh& mesh, int firstAdded)
{
  std::vector<int> added;
  for (const auto& [corners, parent] : mesh.GetParts().GetParts())
  {
    for (const int corner : corners)
    {
      if (parent >= 0 && corner >= firstAdded)
      {
        added.push_back(corner);
      }
    }
  }
  SortUnique(added);
  return added;
}

/** The neighbors of vertices that were added, but are not on M; in ascending order. */
std::vector<int> FindFreeNeighbors(
  const PiercedMesh& mesh, const std::vector<int>& vertices, int firstAdded)
{
  std::vector<int> neighbors;
  std::vector<Vertex> around;
  for (const int vertex : vertices)
  {
    around.clear();
    mesh.GetDelaunay().finite_adjacent_vertices(mesh.GetVertex(vertex), std::back_inserter(around));
    for (const Vertex& v : around)
    {
      if (v->info().Index >= firstAdded)
      {
        neighbors.push_back(v->info().Index);
      }
    }
  }
  SortUnique(neighbors);
  const std::vector<int> onM = FindAdded(mesh, firstAdded);
  std::vector<int> free;
  std::set_difference(
    neighbors.begin(), neighbors.end(), onM.begin(), onM.end(), std::back_inserter(free));
  return free;
}

} // namespace

void RemoveFolds(PiercedMesh& mesh)
{
  const auto& parts = mesh.GetParts().GetParts();
  std::vector<std::pair<Triangle, int>> byCorners;
  for (int part = 0; part < static_cast<int>(parts.size()); ++part)
  {
    if (parts[part].Parent >= 0)
    {
      Triangle corners = parts[part].Corners;
      std::sort(corners.begin(), corners.end());
      byCorners.emplace_back(corners, part);
    }
  }
  std::sort(byCorners.begin(), byCorners.end());
  std::vector<int> folds;
  for (std::size_t i = 0; i + 1 < byCorners.size(); ++i)
  {
    if (byCorners[i].first == byCorners[i + 1].first)
    {
      folds.insert(folds.end(), { byCorners[i].second, byCorners[i + 1].second });
      ++i;
    }
  }
  if (!folds.empty())
  {
    mesh.TakeParts(folds);
  }
}

void DetachAll(PiercedMesh& mesh, int firstAdded, int maximumSearches)
{
  Detacher detacher(mesh, maximumSearches);
  std::vector<int> added = FindAdded(mesh, firstAdded);
  for (const bool mayTakeLong : { false, true })
  {
    std::vector<int> next = added;
    bool isWorthwhile = !mayTakeLong || static_cast<int>(added.size()) <= maximumSearches;
    while (isWorthwhile && !next.empty())
    {
      if (mayTakeLong)
      {
        // Cutting leaves vertices so close to M that there is no room beside them.
        for (const int vertex : FindFreeNeighbors(mesh, next, firstAdded))
        {
          detacher.TryVertex(vertex, false);
        }
      }
      const auto removed = std::count_if(next.begin(), next.end(),
        [&](int vertex) { return detacher.TryVertex(vertex, mayTakeLong); });
      isWorthwhile = 10 * removed >= static_cast<std::ptrdiff_t>(next.size());
      // Vertices that have gone make room for others. A search may find now what it has missed.
      added = FindAdded(mesh, firstAdded); // without those that have lost their parts
      const std::vector<char> touched = detacher.TakeTouched();
      next.clear();
      std::copy_if(added.begin(), added.end(), std::back_inserter(next),
        [&](int vertex) { return mayTakeLong || touched[vertex]; });
    }
  }
}

} // namespace carving::helper
