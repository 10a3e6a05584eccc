// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Walks over the tetrahedra of a PiercedMesh that a part may meet. For PiercedMesh only.
 */
#ifndef carving_Walk_h
#define carving_Walk_h

#include "Helper/Enclosing/PiercedMesh.h"

#include <utility>

namespace carving::helper
{

/** Marks in the mesh of what a walk has visited, for one walk at a time. */
class PiercedMesh::MeshMarks
{
public:
  explicit MeshMarks(PiercedMesh& mesh)
    : Of(mesh)
  {
  }
  void Begin()
  {
    this->Of.BeginWalk();
    this->Of.Stack.clear();
  }
  /** Returns whether the vertex has not been reached before. */
  bool Reach(const Vertex& v)
  {
    return std::exchange(v->info().LastWalk, this->Of.NumberOfWalks) != this->Of.NumberOfWalks;
  }
  void Push(const Cell& cell)
  {
    this->Of.Push(cell, this->Of.Stack);
  }
  void PushStar(const Vertex& v)
  {
    this->Of.PushStar(v, this->Of.Stack);
  }
  std::vector<Cell>& GetStack()
  {
    return this->Of.Stack;
  }

private:
  PiercedMesh& Of;
};

/** Marks outside of the mesh, for walks on a thread of their own. All cells must be numbered. */
class PiercedMesh::OwnMarks
{
public:
  explicit OwnMarks(const PiercedMesh& mesh)
    : Triangulation(mesh.Mesh)
    , OfVertices(mesh.Vertices.size(), 0)
    , OfCells(mesh.Mesh.number_of_cells(), 0)
    , OfStar(OfCells)
  {
  }
  void Begin()
  {
    ++this->NumberOfWalks;
    this->Stack.clear();
  }
  bool Reach(const Vertex& v)
  {
    return this->Mark(this->OfVertices, v->info().Index, this->NumberOfWalks);
  }
  void Push(const Cell& cell)
  {
    if (!this->Triangulation.is_infinite(cell) &&
      this->Mark(this->OfCells, cell->info().Index, this->NumberOfWalks))
    {
      this->Stack.push_back(cell);
    }
  }
  /** CGAL's own search for the cells around a vertex marks cells. */
  void PushStar(const Vertex& v)
  {
    ++this->NumberOfStars;
    this->Star = { v->cell() };
    this->Mark(this->OfStar, v->cell()->info().Index, this->NumberOfStars);
    for (std::size_t i = 0; i < this->Star.size(); ++i)
    {
      const Cell cell = this->Star[i];
      this->Push(cell);
      for (int f = 0; f < 4; ++f)
      {
        const Cell neighbor = cell->neighbor(f);
        if (cell->vertex(f) != v &&
          this->Mark(this->OfStar, neighbor->info().Index, this->NumberOfStars))
        {
          this->Star.push_back(neighbor);
        }
      }
    }
  }
  std::vector<Cell>& GetStack()
  {
    return this->Stack;
  }

private:
  static bool Mark(std::vector<unsigned>& marks, int index, unsigned mark)
  {
    return std::exchange(marks[index], mark) != mark;
  }

  const Delaunay& Triangulation;
  std::vector<unsigned> OfVertices, OfCells, OfStar;
  unsigned NumberOfWalks = 0, NumberOfStars = 0;
  std::vector<Cell> Stack, Star;
};

/** Pushes the tetrahedra below the hull faces around another one, given by its infinite cell. */
template <class Marks>
void PiercedMesh::PushBeside(const Cell& outside, Marks& marks) const
{
  for (int i = 0; i < 4; ++i)
  {
    const Cell beside = outside->neighbor(i);
    if (this->Mesh.is_infinite(beside))
    {
      marks.Push(beside->neighbor(beside->index(this->Mesh.infinite_vertex())));
    }
  }
}

/**
 * Visits the tetrahedra that may meet a part: those around one of its corners, and the neighbors of
 * each tetrahedron for which `visit` returns that the part meets it. A part that is outside of the
 * hull in places, by a rounding, may come back at other hull faces.
 */
template <class Marks, class Visit>
void PiercedMesh::Walk(int part, const Piercer& piercer, Marks& marks, const Visit& visit) const
{
  const Triangle& corners = this->Parts.GetParts()[part].Corners;
  for (const int corner : corners)
  {
    marks.Reach(this->Vertices[corner]);
  }
  marks.PushStar(this->Vertices[corners[0]]);
  std::vector<Cell>& stack = marks.GetStack();
  while (!stack.empty())
  {
    const Cell cell = stack.back();
    stack.pop_back();
    const bool meets = visit(cell);
    for (int i = 0; i < 4; ++i)
    {
      const Cell neighbor = cell->neighbor(i);
      if (this->Mesh.is_infinite(neighbor) && (meets || this->MayPassBeyond(part, cell, i)))
      {
        this->PushBeside(neighbor, marks);
      }
      if (!meets)
      {
        continue;
      }
      marks.Push(neighbor);
      // If an edge of the cell lies in the triangle, the part may continue in cells around that
      // edge that share no face with this cell. Corners of the triangle need no search, since an
      // edge between two of them is on the border.
      const Vertex v = cell->vertex(i);
      if (marks.Reach(v) && piercer.SideOf(v->point()) == CGAL::COPLANAR)
      {
        marks.PushStar(v);
      }
    }
  }
}

} // namespace carving::helper

#endif
