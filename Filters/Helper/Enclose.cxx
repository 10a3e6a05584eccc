// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Enclose.h"

#include "Pierce.h"
#include "Vector.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <unordered_set>

using namespace carving;

namespace
{

struct CellInfo
{
  bool Pierced = false;
  std::array<int, 4> OnFace = { -1, -1, -1, -1 }; ///< a triangle that overlaps a face
  int Index = -1;
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<int, Inexact>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<CellInfo, Inexact,
  CGAL::Delaunay_triangulation_cell_base_3<Inexact>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Inexact,
  CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Cell = Delaunay::Cell_handle;
using Vertex = Delaunay::Vertex_handle;

/** The corners of face f, counter-clockwise as seen from outside. */
Corners3 FaceOf(const Cell& cell, int f)
{
  Corners3 face;
  for (int i = 0; i < 3; ++i)
  {
    face[i] = cell->vertex(FaceCorners[f][i])->point();
  }
  return face;
}

Corners4 CornersOf(const Cell& cell)
{
  return { cell->vertex(0)->point(), cell->vertex(1)->point(), cell->vertex(2)->point(),
    cell->vertex(3)->point() };
}

Point ToPoint(const Inexact::Point_3& p)
{
  return { p[0], p[1], p[2] };
}

double LongestEdge(const Cell& cell)
{
  double longest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    for (int k = 0; k < i; ++k)
    {
      longest = std::max(
        longest, Length(ToPoint(cell->vertex(i)->point()) - ToPoint(cell->vertex(k)->point())));
    }
  }
  return longest;
}

class Encloser
{
public:
  Encloser(const ResolvedMesh& input, const std::vector<Point>& further)
    : Input(input)
  {
    std::vector<std::pair<Inexact::Point_3, int>> points;
    for (const std::vector<Point>* part : { &input.Points, &further })
    {
      for (const Point& p : *part)
      {
        points.emplace_back(ToInexact(p), static_cast<int>(points.size()));
      }
    }
    this->Mesh.insert(points.begin(), points.end());
    this->Vertices.resize(points.size());
    for (const Vertex v : this->Mesh.finite_vertex_handles())
    {
      this->Vertices[v->info()] = v;
    }
  }

  void Run(const std::function<bool(double)>& progress)
  {
    const int count = static_cast<int>(this->Input.Facets.size());
    for (int t = 0; t < count; ++t)
    {
      if (!this->IsFace(t))
      {
        this->Find(t);
      }
      if (t % 1000 == 0)
      {
        progress(static_cast<double>(t) / count);
      }
    }
  }

  double Write(Tetrahedralization& result);

private:
  Corners3 CornersOfTriangle(int t) const
  {
    const Triangle& corners = this->Input.Facets[t];
    return { this->Vertices[corners[0]]->point(), this->Vertices[corners[1]]->point(),
      this->Vertices[corners[2]]->point() };
  }

  static void Lay(int t, const Cell& cell, int f)
  {
    int& found = cell->info().OnFace[f];
    found = found < 0 ? t : std::min(found, t);
  }

  /** Most triangles are faces. Then there is nothing to look for. */
  bool IsFace(int t)
  {
    const Triangle& corners = this->Input.Facets[t];
    Cell cell;
    int i = 0, j = 0, k = 0;
    if (!this->Mesh.is_facet(this->Vertices[corners[0]], this->Vertices[corners[1]],
          this->Vertices[corners[2]], cell, i, j, k))
    {
      return false;
    }
    const int f = 6 - i - j - k; // the remaining one of 0, 1, 2, 3
    const Cell other = cell->neighbor(f);
    Lay(t, cell, f);
    Lay(t, other, other->index(cell));
    return true;
  }

  /** Finds the tetrahedra that a triangle pierces and the faces that it overlaps. */
  void Find(int t)
  {
    const Corners3 triangle = this->CornersOfTriangle(t);
    std::vector<Cell> stack;
    std::unordered_set<const void*> seen;
    const auto push = [&](const Cell& cell)
    {
      if (!this->Mesh.is_infinite(cell) && seen.insert(&*cell).second)
      {
        stack.push_back(cell);
      }
    };
    std::vector<Cell> star;
    std::unordered_set<const void*> starred;
    const auto pushStar = [&](const Vertex& v)
    {
      if (starred.insert(&*v).second)
      {
        star.clear();
        this->Mesh.finite_incident_cells(v, std::back_inserter(star));
        std::for_each(star.begin(), star.end(), push);
      }
    };
    for (const int corner : this->Input.Facets[t])
    {
      pushStar(this->Vertices[corner]);
    }
    while (!stack.empty())
    {
      const Cell cell = stack.back();
      stack.pop_back();
      if (!this->Meets(t, triangle, cell))
      {
        continue;
      }
      for (int i = 0; i < 4; ++i)
      {
        push(cell->neighbor(i));
        // Through a corner on the triangle it may go on in cells that share no face with this one.
        const Vertex v = cell->vertex(i);
        if (CGAL::orientation(triangle[0], triangle[1], triangle[2], v->point()) == CGAL::COPLANAR)
        {
          pushStar(v);
        }
      }
    }
  }

  /** Records whether a triangle pierces a cell or overlaps its faces; returns whether it does either. */
  bool Meets(int t, const Corners3& triangle, const Cell& cell)
  {
    if (Pierces(triangle, CornersOf(cell)))
    {
      cell->info().Pierced = true;
      return true;
    }
    bool lies = false;
    for (int f = 0; f < 4; ++f)
    {
      if (OverlapInPlane(triangle, FaceOf(cell, f)))
      {
        lies = true;
        Lay(t, cell, f);
      }
    }
    return lies;
  }

  const ResolvedMesh& Input;
  Delaunay Mesh;
  std::vector<Vertex> Vertices;
};

/** Returns the longest edge of what is kept. */
double Encloser::Write(Tetrahedralization& result)
{
  double longest = 0.0;
  ResolvedMesh& surface = result.Surface;
  for (const Vertex& v : this->Vertices)
  {
    surface.Points.push_back(ToPoint(v->point()));
  }
  surface.PointSources = this->Input.PointSources;
  surface.PointSources.resize(surface.Points.size(), -1);
  int count = 0;
  for (const Cell cell : this->Mesh.finite_cell_handles())
  {
    cell->info().Index = count++;
  }
  for (const Cell cell : this->Mesh.finite_cell_handles())
  {
    auto& corners = result.Cells.emplace_back();
    auto& neighbors = result.Neighbors.emplace_back();
    auto& constraints = result.Constraints.emplace_back();
    for (int i = 0; i < 4; ++i)
    {
      const Cell other = cell->neighbor(i);
      corners[i] = cell->vertex(i)->info();
      neighbors[i] = this->Mesh.is_infinite(other) ? Outside : other->info().Index;
      constraints[i] = -1;
    }
    result.Kept.push_back(cell->info().Pierced);
    if (cell->info().Pierced)
    {
      longest = std::max(longest, LongestEdge(cell));
    }
  }
  for (const Cell cell : this->Mesh.finite_cell_handles())
  {
    const int index = cell->info().Index;
    for (int f = 0; f < 4; ++f)
    {
      const int t = cell->info().OnFace[f];
      if (t < 0 || result.Constraints[index][f] >= 0)
      {
        continue;
      }
      const int facet = static_cast<int>(surface.Facets.size());
      const Triangle outward = result.OutwardFace(index, f);
      surface.Facets.push_back(
        FaceAlike(this->CornersOfTriangle(t), FaceOf(cell, f)) ? outward : Flipped<3>(outward));
      surface.FacetSources.push_back(this->Input.FacetSources[t]);
      surface.Windings.push_back(this->Input.Windings[t]);
      surface.Counts.push_back(this->Input.Counts[t]);
      result.Constraints[index][f] = facet;
      const Cell other = cell->neighbor(f);
      if (!this->Mesh.is_infinite(other))
      {
        result.Constraints[other->info().Index][other->index(cell)] = facet;
      }
    }
  }
  result.Unresolved = this->Input;
  return longest;
}

} // namespace

double Enclose(const ResolvedMesh& input, const std::vector<Point>& further,
  const std::function<bool(double)>& progress, Tetrahedralization& result)
{
  Encloser encloser(input, further);
  encloser.Run(progress);
  result = {};
  return encloser.Write(result);
}
