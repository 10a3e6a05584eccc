// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/VertexWalls.h"

#include "Core/Mesh/Vector.h"
#include "Helper/Recovery/FillPolygon.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Vertex = PiercedMesh::Vertex;

constexpr int None = -1;
constexpr int Slit = -2; ///< instead of a triangle of M

} // namespace

VertexWalls::VertexWalls(const PiercedMesh& mesh, const Vertex& v)
  : Mesh(mesh)
  , V(v)
{
  mesh.GetDelaunay().tds().incident_cells(v, std::back_inserter(this->Star));
  for (std::size_t i = 0; i < this->Star.size(); ++i)
  {
    this->Star[i]->info().Index = static_cast<int>(i);
  }
}

bool VertexWalls::Retriangulate()
{
  if (!this->FindFaces())
  {
    return false;
  }
  this->ExtendOpenEdge();
  this->FindSpaces();
  this->Trace();
  const Point v = ToPoint(this->V->point());
  for (Wall& wall : this->Walls)
  {
    Point normal = {};
    const std::size_t count = wall.Rim.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      normal = normal +
        Cross(ToPoint(wall.Rim[i]->point()) - v, ToPoint(wall.Rim[(i + 1) % count]->point()) - v);
    }
    // A face between the vertex and one edge vanishes.
    if (count > 2)
    {
      wall.Triangles = FillPolygon(wall.Rim, normal / Length(normal));
    }
    if (count > 2 && wall.Triangles.empty())
    {
      return false;
    }
  }
  return true;
}

/**
 * Finds the faces of walls. Returns false if a part pierces a cell or is only a piece of a face.
 */
bool VertexWalls::FindFaces()
{
  const auto isInfinite = [&](const Cell& cell)
  { return this->Mesh.GetDelaunay().is_infinite(cell); };
  for (const Cell& cell : this->Star)
  {
    if (isInfinite(cell))
    {
      continue;
    }
    std::array<const PartContact*, 4> contacts = {};
    for (const PartContact& contact : cell->info().All)
    {
      if (!this->Mesh.IsOnWholeFace(cell, contact) || contacts[contact.How.Face])
      {
        return false;
      }
      contacts[contact.How.Face] = &contact;
    }
    for (int f = 0; f < 4; ++f)
    {
      const Cell neighbor = cell->neighbor(f);
      const bool isHull = isInfinite(neighbor);
      if (f != cell->index(this->V) && (isHull || contacts[f]) &&
        (isHull || neighbor->info().Index > cell->info().Index))
      {
        Face face = this->MakeFace(cell, f);
        if (contacts[f])
        {
          const auto& [corners, parent] = this->Mesh.GetParts().GetParts()[contacts[f]->Part];
          const auto at = std::find(corners.begin(), corners.end(), this->V->info().Index);
          face.Part = contacts[f]->Part;
          face.Parent = parent;
          face.BeginAt(corners[(at - corners.begin() + 1) % 3]);
        }
        this->Faces.push_back(face);
      }
    }
  }
  return true;
}

/** Face f of a cell. Outside of the cell is in front. */
VertexWalls::Face VertexWalls::MakeFace(const Cell& cell, int f) const
{
  VertexTriangle t;
  for (int i = 0; i < 3; ++i)
  {
    t[i] = cell->vertex(FaceCorners[f][i]);
  }
  std::rotate(t.begin(), std::find(t.begin(), t.end(), this->V), t.end());
  return { t[1], t[2], None, None, { cell->neighbor(f)->info().Index, cell->info().Index } };
}

/** Turns the face such that it begins at a vertex. */
void VertexWalls::Face::BeginAt(int vertex)
{
  if (this->From->info().Index != vertex)
  {
    std::swap(this->From, this->To);
    std::swap(this->Cells[0], this->Cells[1]);
  }
}

/**
 * Where a single wall ends at an edge of M, no vertex sees both of its sides. Two faces behind the
 * edge become another wall, which separates the sides.
 */
void VertexWalls::ExtendOpenEdge()
{
  const std::vector<Vertex> ends = this->FindOpenEnds();
  if (ends.size() != 2)
  {
    return;
  }
  const Point v = ToPoint(this->V->point());
  const Point edge = ToPoint(ends[1]->point()) - ToPoint(ends[0]->point());
  const auto perpendicular = [&](const Vertex& to)
  {
    const Point way = ToPoint(to->point()) - v;
    return way - Dot(way, edge) / Dot(edge, edge) * edge;
  };
  Point ahead = {}; // into the wall
  for (const Face& face : this->Faces)
  {
    ahead = ahead + perpendicular(face.From) + perpendicular(face.To);
  }
  std::map<int, std::array<std::optional<Face>, 2>> behind; // by the corner that is on no wall
  for (const Cell& cell : this->Star)
  {
    for (int f = 0; f < 4; ++f)
    {
      const Face face = this->MakeFace(cell, f);
      const bool isThere =
        f != cell->index(this->V) && !this->Mesh.GetDelaunay().is_infinite(cell, f);
      for (int end = 0; end < 2 && isThere; ++end)
      {
        if (face.From == ends[end] || face.To == ends[end])
        {
          const Vertex& other = face.From == ends[end] ? face.To : face.From;
          behind[other->info().Index][end] = face;
        }
      }
    }
  }
  const std::array<std::optional<Face>, 2>* best = nullptr;
  double least = 0.0;
  for (const auto& [index, faces] : behind)
  {
    const auto isAt = [i = index](const Face& face)
    { return face.From->info().Index == i || face.To->info().Index == i; };
    if (faces[0] && faces[1] && std::none_of(this->Faces.begin(), this->Faces.end(), isAt))
    {
      const Point way = perpendicular(faces[0]->From == ends[0] ? faces[0]->To : faces[0]->From);
      const double cosine = Dot(way, ahead) / Length(way);
      if (!best || cosine < least)
      {
        best = &faces;
        least = cosine;
      }
    }
  }
  for (int end = 0; end < 2 && best; ++end)
  {
    Face face = *(*best)[end];
    face.Parent = Slit;
    const bool isForwards = (face.From == ends[end]) == (end == 0);
    face.BeginAt((isForwards ? face.From : face.To)->info().Index);
    this->Faces.push_back(face);
  }
}

/** The ends of edges of faces that no other face continues. */
std::vector<Vertex> VertexWalls::FindOpenEnds() const
{
  std::vector<Vertex> ends;
  for (const Face& face : this->Faces)
  {
    for (const Vertex& end : { face.From, face.To })
    {
      const auto count = std::count_if(this->Faces.begin(), this->Faces.end(),
        [&](const Face& other) { return other.From == end || other.To == end; });
      if (count == 1)
      {
        ends.push_back(end);
      }
    }
  }
  return ends;
}

void VertexWalls::FindSpaces()
{
  const std::size_t count = this->Star.size();
  std::vector<std::array<bool, 4>> isWall(count);
  for (const Face& face : this->Faces)
  {
    for (int side = 0; side < 2; ++side)
    {
      const Cell cell = this->Star[face.Cells[side]], other = this->Star[face.Cells[1 - side]];
      isWall[face.Cells[side]][cell->index(other)] = true;
    }
  }
  this->SpaceOf.assign(count, None);
  std::vector<int> stack;
  for (std::size_t start = 0; start < count; ++start)
  {
    if (this->SpaceOf[start] != None)
    {
      continue;
    }
    this->SpaceOf[start] = this->NumberOfSpaces;
    stack.push_back(static_cast<int>(start));
    while (!stack.empty())
    {
      const int i = stack.back();
      stack.pop_back();
      for (int f = 0; f < 4; ++f)
      {
        const Cell cell = this->Star[i];
        const int next = cell->neighbor(f)->info().Index;
        if (f != cell->index(this->V) && !isWall[i][f] && this->SpaceOf[next] == None)
        {
          this->SpaceOf[next] = this->NumberOfSpaces;
          stack.push_back(next);
        }
      }
    }
    ++this->NumberOfSpaces;
  }
}

/** The face that continues a wall behind one end of a face; None if the wall ends there. */
int VertexWalls::FindNext(const Face& face, bool forwards) const
{
  const Vertex end = forwards ? face.To : face.From;
  int next = None, count = 0;
  for (std::size_t i = 0; i < this->Faces.size(); ++i)
  {
    const Face& other = this->Faces[i];
    count += other.From == end || other.To == end;
    if (other.Parent == face.Parent && (forwards ? other.From : other.To) == end)
    {
      next = static_cast<int>(i);
    }
  }
  return count == 2 ? next : None;
}

/** Joins faces to walls. */
void VertexWalls::Trace()
{
  for (std::size_t i = 0; i < this->Faces.size(); ++i)
  {
    if (this->Faces[i].IsTraced)
    {
      continue;
    }
    int first = static_cast<int>(i);
    for (int before = this->FindNext(this->Faces[first], false);
         before != None && before != static_cast<int>(i);
         before = this->FindNext(this->Faces[first], false))
    {
      first = before;
    }
    const Face& start = this->Faces[first];
    Wall& wall = this->Walls.emplace_back();
    wall.Parent = start.Parent;
    wall.Spaces = { this->SpaceOf[start.Cells[0]], this->SpaceOf[start.Cells[1]] };
    wall.Rim.push_back(start.From);
    int face = first;
    while (face != None && !this->Faces[face].IsTraced)
    {
      this->Faces[face].IsTraced = true;
      wall.Rim.push_back(this->Faces[face].To);
      face = this->FindNext(this->Faces[face], true);
    }
    if (wall.Rim.front() == wall.Rim.back())
    {
      wall.Rim.pop_back(); // all around the vertex
    }
  }
}

std::vector<VertexWalls::Space> VertexWalls::GetSpaces() const
{
  std::vector<Space> spaces(this->NumberOfSpaces);
  for (std::size_t i = 0; i < this->Star.size(); ++i)
  {
    spaces[this->SpaceOf[i]].Cells.push_back(this->Star[i]);
  }
  for (const Wall& wall : this->Walls)
  {
    for (const VertexTriangle& t : wall.Triangles)
    {
      spaces[wall.Spaces[0]].Walls.push_back(t);
      spaces[wall.Spaces[1]].Walls.push_back({ t[0], t[2], t[1] });
    }
  }
  return spaces;
}

std::vector<int> VertexWalls::GetParts() const
{
  std::vector<int> parts;
  for (const Face& face : this->Faces)
  {
    if (face.Part != None)
    {
      parts.push_back(face.Part);
    }
  }
  return parts;
}

std::vector<Subdivision::Part> VertexWalls::MakeParts() const
{
  std::vector<Subdivision::Part> parts;
  for (const Wall& wall : this->Walls)
  {
    for (const auto& [a, b, c] : wall.Triangles)
    {
      if (wall.Parent >= 0)
      {
        parts.push_back({ { a->info().Index, b->info().Index, c->info().Index }, wall.Parent });
      }
    }
  }
  return parts;
}

} // namespace carving::helper
