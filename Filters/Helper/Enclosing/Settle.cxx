// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Finds the tetrahedra of a PiercedMesh that parts meet.
 */
#include "Core/Mesh/ForEach.h"
#include "Helper/Base/IndexedBox.h"
#include "Helper/Enclosing/PiercedMesh.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace carving::helper
{
namespace
{

template <std::size_t N>
CGAL::Bbox_3 BoundsOf(const std::array<Inexact::Point_3, N>& corners)
{
  CGAL::Bbox_3 bounds;
  for (const Inexact::Point_3& p : corners)
  {
    bounds += p.bbox();
  }
  return bounds;
}

} // namespace

/** Finds the contacts of a part that is a face, as most parts are, without a search. */
bool PiercedMesh::SettleOnFace(int part)
{
  const std::optional<Delaunay::Facet> found = this->FindFace(part);
  if (!found)
  {
    return false;
  }
  const auto& [cell, f] = *found;
  const Cell other = cell->neighbor(f);
  for (const auto& [side, face] : { std::pair(cell, f), std::pair(other, other->index(cell)) })
  {
    if (!this->Mesh.is_infinite(side))
    {
      side->info().Add({ part, { false, face } });
    }
  }
  return true;
}

void PiercedMesh::Push(const Cell& cell, std::vector<Cell>& stack)
{
  if (cell->info().LastWalk != this->NumberOfWalks && !this->Mesh.is_infinite(cell))
  {
    cell->info().LastWalk = this->NumberOfWalks;
    stack.push_back(cell);
  }
}

void PiercedMesh::PushStar(const Vertex& v, std::vector<Cell>& stack)
{
  this->Star.clear();
  this->Mesh.finite_incident_cells(v, std::back_inserter(this->Star));
  for (const Cell& cell : this->Star)
  {
    this->Push(cell, stack);
  }
}

/** Marks in the mesh of what a walk has visited, for one walk at a time. */
class PiercedMesh::MeshMarks
{
public:
  explicit MeshMarks(PiercedMesh& mesh)
    : Of(mesh)
  {
    mesh.BeginWalk();
    mesh.Stack.clear();
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
    return !this->Triangulation.is_infinite(v) &&
      this->Mark(this->OfVertices, v->info().Index, this->NumberOfWalks);
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

/**
 * Visits the tetrahedra that may meet a part: those around one of its corners, and the neighbors of
 * each tetrahedron for which `visit` returns that the part meets it.
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
    if (!visit(cell))
    {
      continue;
    }
    for (int i = 0; i < 4; ++i)
    {
      marks.Push(cell->neighbor(i));
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

/** Records the contact of a part with a cell; returns whether there is one. */
bool PiercedMesh::Meet(int part, const Piercer& piercer, const Cell& cell)
{
  const Contact contact = piercer.FindContact(helper::CornersOf(cell));
  if (contact.Exists())
  {
    cell->info().Add({ part, contact });
  }
  return contact.Exists();
}

/** Settles a part that is a face, or without area. Returns whether it was one. */
bool PiercedMesh::SettleSimply(int part)
{
  if (this->SettleOnFace(part))
  {
    return true;
  }
  const auto [a, b, c] = this->CornersOf(part);
  const bool isFlat = CGAL::collinear(a, b, c);
  if (isFlat)
  {
    this->Parts.Take(part); // rounding leaves it without area: its neighbors are enough
  }
  return isFlat;
}

/** Finds the tetrahedra that a part meets. */
void PiercedMesh::Settle(int part)
{
  if (!this->SettleSimply(part))
  {
    const Piercer piercer(this->CornersOf(part));
    MeshMarks marks(*this);
    this->Walk(
      part, piercer, marks, [&](const Cell& cell) { return this->Meet(part, piercer, cell); });
  }
}

/** Finds the tetrahedra that parts meet, as Settle does for each of them, on several threads. */
void PiercedMesh::SettleAll(
  std::vector<int> parts, int threads, const std::function<bool(double)>& progress)
{
  parts.erase(std::remove_if(
                parts.begin(), parts.end(), [this](int part) { return this->SettleSimply(part); }),
    parts.end());
  int cells = 0;
  for (const Cell cell : this->Mesh.all_cell_handles())
  {
    cell->info().Index = cells++;
  }
  threads = std::max(threads, 1);
  std::vector<OwnMarks> marks(threads, OwnMarks(*this));
  constexpr std::size_t batch = 2000; // whose contacts are held twice
  std::vector<std::vector<std::pair<Cell, Contact>>> contacts(batch);
  for (std::size_t first = 0; first < parts.size(); first += batch)
  {
    progress(static_cast<double>(first) / static_cast<double>(parts.size()));
    const std::size_t count = std::min(batch, parts.size() - first);
    std::atomic<std::size_t> next{ 0 };
    ForEach(threads, threads,
      [&](int thread)
      {
        for (std::size_t i = next++; i < count; i = next++)
        {
          this->FindContacts(parts[first + i], marks[thread], contacts[i]);
        }
      });
    for (std::size_t i = 0; i < count; ++i)
    {
      for (const auto& [cell, contact] : contacts[i])
      {
        cell->info().Add({ parts[first + i], contact });
      }
    }
  }
}

void PiercedMesh::FindContacts(
  int part, OwnMarks& marks, std::vector<std::pair<Cell, Contact>>& contacts) const
{
  const Piercer piercer(this->CornersOf(part));
  contacts.clear();
  marks.Begin();
  this->Walk(part, piercer, marks,
    [&](const Cell& cell)
    {
      const Contact contact = piercer.FindContact(helper::CornersOf(cell));
      if (contact.Exists())
      {
        contacts.emplace_back(cell, contact);
      }
      return contact.Exists();
    });
}

std::vector<PiercedMesh::Cell> PiercedMesh::FindCells(int part)
{
  std::vector<Cell> cells;
  const Piercer piercer(this->CornersOf(part));
  MeshMarks marks(*this);
  this->Walk(part, piercer, marks,
    [&](const Cell& cell)
    {
      const bool meets = piercer.FindContact(helper::CornersOf(cell)).Exists();
      if (meets)
      {
        cells.push_back(cell);
      }
      return meets;
    });
  return cells;
}

void PiercedMesh::Forget(int part)
{
  MeshMarks marks(*this);
  this->Walk(part, Piercer(this->CornersOf(part)), marks,
    [&](const Cell& cell) { return cell->info().Remove(part); });
}

/**
 * Records the contacts of parts with cells. Where points in a plane are off it by a rounding, both
 * are numerous and few of them meet.
 */
void PiercedMesh::MeetAll(const std::vector<int>& parts, const std::vector<Cell>& cells)
{
  // CGAL takes boxes of the same index for the same box, even from different sequences.
  const int firstCell = static_cast<int>(parts.size());
  std::vector<IndexedBox> partBoxes, cellBoxes;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    partBoxes.emplace_back(BoundsOf(this->CornersOf(parts[i])), static_cast<int>(i));
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    cellBoxes.emplace_back(BoundsOf(helper::CornersOf(cells[i])), firstCell + static_cast<int>(i));
  }
  std::vector<std::pair<int, int>> pairs;
  CGAL::box_intersection_d(partBoxes.begin(), partBoxes.end(), cellBoxes.begin(), cellBoxes.end(),
    [&](const IndexedBox& part, const IndexedBox& cell)
    { pairs.emplace_back(part.Index, cell.Index - firstCell); });
  std::sort(pairs.begin(), pairs.end());
  for (auto pair = pairs.begin(); pair != pairs.end();)
  {
    const int part = pair->first;
    const Piercer piercer(this->CornersOf(parts[part]));
    for (; pair != pairs.end() && pair->first == part; ++pair)
    {
      this->Meet(parts[part], piercer, cells[pair->second]);
    }
  }
}

} // namespace carving::helper
