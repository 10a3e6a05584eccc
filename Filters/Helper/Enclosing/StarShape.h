// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The cells of a PiercedMesh around a point that becomes a vertex.
 */
#ifndef carving_StarShape_h
#define carving_StarShape_h

#include "Helper/Enclosing/CellShape.h"
#include "Helper/Enclosing/PiercedMesh.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

namespace carving::helper
{

inline int IndexOf(const PiercedMesh::Cell& cell, int i)
{
  return cell->vertex(i)->info().Index;
}

/**
 * Whether a point is beyond the hull at some infinite cells. Roundings of earlier vertices have
 * dented the hull, which could cross itself at such a vertex.
 */
inline bool IsBeyond(const PiercedMesh::Delaunay& mesh, const std::vector<PiercedMesh::Cell>& cells,
  const Inexact::Point_3& p)
{
  return std::any_of(cells.begin(), cells.end(),
    [&](const PiercedMesh::Cell& cell)
    { return IsPositive(cell, cell->index(mesh.infinite_vertex()), p); });
}

/** A set of cells around a point, which sees all of their outer finite faces from inside. */
class StarShape
{
public:
  static constexpr std::size_t MaximumSize = 64; ///< cells

  explicit StarShape(const std::vector<PiercedMesh::Cell>& cells)
    : Cells(cells)
    , Within(cells.begin(), cells.end())
  {
  }

  /**
   * Adds the cells behind faces that the point does not see. Returns false if such a face is a part
   * of M, if it is on the hull (a point that is `onHull` may be in its plane), or if there are too
   * many.
   */
  bool Grow(const PiercedMesh::Delaunay& mesh, const Inexact::Point_3& p, bool onHull)
  {
    for (std::size_t i = 0; i < this->Cells.size(); ++i)
    {
      const PiercedMesh::Cell cell = this->Cells[i];
      for (int f = 0; f < 4 && !mesh.is_infinite(cell); ++f)
      {
        const PiercedMesh::Cell neighbor = cell->neighbor(f);
        if (this->Within.count(neighbor) > 0 || IsPositive(cell, f, p))
        {
          continue;
        }
        const bool isOutside = mesh.is_infinite(neighbor);
        if ((isOutside && (!onHull || IsBeyond(mesh, { neighbor }, p))) ||
          cell->info().PartOn(f) >= 0 || this->Cells.size() >= MaximumSize)
        {
          return false;
        }
        this->Within.insert(neighbor);
        this->Cells.push_back(neighbor);
      }
    }
    return true;
  }

  bool Has(const PiercedMesh::Cell& cell) const
  {
    return this->Within.count(cell) > 0;
  }
  const std::vector<PiercedMesh::Cell>& GetCells() const
  {
    return this->Cells;
  }

private:
  std::vector<PiercedMesh::Cell> Cells;
  std::set<PiercedMesh::Cell> Within;
};

/** The vertices and edges of the outer faces of a star. */
class StarSurface
{
public:
  explicit StarSurface(const StarShape& star)
  {
    for (const PiercedMesh::Cell& cell : star.GetCells())
    {
      for (int f = 0; f < 4; ++f)
      {
        if (star.Has(cell->neighbor(f)))
        {
          continue;
        }
        ++this->NumberOfFaces;
        for (int i = 0; i < 3; ++i)
        {
          const int a = IndexOf(cell, FaceCorners[f][i]);
          this->Vertices.insert(a);
          this->Edges.insert(EdgeKey(a, IndexOf(cell, FaceCorners[f][(i + 1) % 3])));
        }
      }
    }
  }
  bool Has(int vertex) const
  {
    return this->Vertices.count(vertex) > 0;
  }
  bool Has(int a, int b) const
  {
    return this->Edges.count(EdgeKey(a, b)) > 0;
  }
  /**
   * Whether the faces are a sphere, by their Euler characteristic. Two infinite cells of a star may
   * have only an edge in common, in which four faces meet then.
   */
  bool IsSphere() const
  {
    return 2 * this->Edges.size() == 3 * this->NumberOfFaces &&
      this->Vertices.size() + this->NumberOfFaces == this->Edges.size() + 2;
  }

private:
  std::size_t NumberOfFaces = 0;
  std::set<int> Vertices;
  std::set<std::uint64_t> Edges;
};

} // namespace carving::helper

#endif
