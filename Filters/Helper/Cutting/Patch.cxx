// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Cutting/Patch.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace carving::helper
{

Patch::Patch(CutMesh& mesh, const Triangle& corners)
  : Mesh(mesh)
  , Corners(corners)
  , Number(mesh.CountPatch())
{
  for (int i = 0; i < 3; ++i)
  {
    this->Loop.push_back(corners[i]);
    mesh.GetChains().Append(corners[i], corners[(i + 1) % 3], this->Loop);
  }
  for (const int vertex : this->Loop)
  {
    this->PutOnPlane(vertex);
  }
  this->RemoveSpurs();
  for (int i = 0; i < 3; ++i)
  {
    this->CornerPoints[i] = ToInexact(mesh.PointOf(corners[i]));
  }
  const Point& a = mesh.PointOf(corners[0]);
  this->Normal = Cross(mesh.PointOf(corners[1]) - a, mesh.PointOf(corners[2]) - a);
  const double length = Length(this->Normal);
  this->Normal = length > 0.0 ? this->Normal / length : Point{};
}

/**
 * Removes the edges of the border that it follows forth and back at once: where other vertices are
 * so close to a corner that both sides go through them.
 */
void Patch::RemoveSpurs()
{
  std::vector<int>& loop = this->Loop;
  std::vector<int> kept;
  for (const int vertex : loop)
  {
    if (kept.size() > 1 && kept[kept.size() - 2] == vertex)
    {
      kept.pop_back();
    }
    else
    {
      kept.push_back(vertex);
    }
  }
  // The spur at the first corner is at both ends of the list.
  std::size_t first = 0;
  while (kept.size() > first + 2 && kept[first + 1] == kept.back())
  {
    kept.pop_back();
    ++first;
  }
  loop.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
}

/** Whether the triangle has an area, and its border does not touch itself. */
bool Patch::IsSimple() const
{
  return this->Normal != Point{} && this->Loop.size() > 2 &&
    std::set<int>(this->Loop.begin(), this->Loop.end()).size() == this->Loop.size();
}

void Patch::PutOnPlane(int vertex)
{
  this->Mesh.GetMesh().GetVertex(vertex)->info().Side = { this->Number, 0 };
}

/** On which side of the plane a vertex is: 1, -1, or 0 if the vertex is on the plane. */
int Patch::SideOf(const PiercedMesh::Vertex& v)
{
  auto& side = v->info().Side;
  if (side.OfPatch != this->Number)
  {
    const double distance =
      Dot(this->Normal, ToPoint(v->point()) - this->Mesh.PointOf(this->Corners[0]));
    const double tolerance = this->Mesh.GetTolerance();
    side = { this->Number, distance >= tolerance ? 1 : distance <= -tolerance ? -1 : 0 };
  }
  return side.Which;
}

/**
 * All edges that cross the triangle. Every tetrahedron that the triangle pierces has such an edge,
 * since edges of the tetrahedralization make up its border.
 */
std::vector<std::pair<Patch::Edge, Patch::CellEdge>> Patch::FindCrossing()
{
  PiercedMesh& mesh = this->Mesh.GetMesh();
  std::vector<std::pair<Edge, CellEdge>> edges;
  std::vector<Cell> stack;
  std::unordered_set<std::uint64_t> known;
  std::unordered_set<int> centers(this->Loop.begin(), this->Loop.end());
  mesh.BeginWalk();
  for (const int vertex : this->Loop)
  {
    mesh.PushStar(mesh.GetVertex(vertex), stack);
  }
  while (!stack.empty())
  {
    const Cell cell = stack.back();
    stack.pop_back();
    std::array<int, 4> corners, sides;
    for (int i = 0; i < 4; ++i)
    {
      corners[i] = cell->vertex(i)->info().Index;
      sides[i] = this->SideOf(cell->vertex(i));
    }
    bool isCut = false;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        const int a = corners[i], b = corners[j];
        if (sides[i] * sides[j] < 0 && known.insert(EdgeKey(a, b)).second &&
          CrossesInside(cell->vertex(i)->point(), cell->vertex(j)->point(), this->CornerPoints))
        {
          isCut = true;
          edges.push_back(a < b ? std::pair(Edge{ a, b }, CellEdge(cell, i, j))
                                : std::pair(Edge{ b, a }, CellEdge(cell, j, i)));
          for (const Cell& around : mesh.FindCellsAround({ cell, i, j }))
          {
            mesh.Push(around, stack);
          }
        }
      }
    }
    for (int i = 0; i < 4 && isCut; ++i)
    {
      if (sides[i] == 0 && centers.insert(corners[i]).second)
      {
        mesh.PushStar(cell->vertex(i), stack);
      }
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const auto& one, const auto& other) { return one.first < other.first; });
  return edges;
}

bool Patch::CutEdges()
{
  if (!this->IsSimple())
  {
    return false;
  }
  const Point origin = this->Mesh.PointOf(this->Corners[0]);
  const auto heightOf = [&](int vertex)
  { return Dot(this->Normal, this->Mesh.PointOf(vertex) - origin); };
  constexpr int rounds = 20; // more than one if edges vanish with others
  bool isCut = false;
  for (int round = 0; round < rounds && !isCut; ++round)
  {
    isCut = true;
    for (const auto& [edge, hint] : this->FindCrossing())
    {
      const auto [a, b] = edge;
      const std::vector<Cell> around = this->Mesh.GetMesh().FindCellsAround(a, b, hint);
      if (around.empty())
      {
        isCut = false;
        continue;
      }
      if (this->Mesh.FlipEdge(a, b, around))
      {
        continue;
      }
      const double height = heightOf(a);
      const int vertex = this->Mesh.SplitEdge(a, b, height / (height - heightOf(b)));
      if (vertex < 0)
      {
        return false;
      }
      this->PutOnPlane(vertex);
    }
  }
  return isCut;
}

/**
 * Whether a cell at a face on the plane of the triangle is on one side of the plane, with no part
 * on the other. An infinite cell is on the side to which its face of the hull is turned.
 */
bool Patch::IsOnSide(const Cell& cell, int side)
{
  const auto& delaunay = this->Mesh.GetMesh().GetDelaunay();
  if (delaunay.is_infinite(cell))
  {
    const Corners3 inward = FaceOf(cell, cell->index(delaunay.infinite_vertex()));
    const Point a = ToPoint(inward[0]);
    return side * Dot(this->Normal, Cross(ToPoint(inward[1]) - a, ToPoint(inward[2]) - a)) < 0.0;
  }
  bool isOnSide = false;
  for (int i = 0; i < 4; ++i)
  {
    const int corner = side * this->SideOf(cell->vertex(i));
    if (corner < 0)
    {
      return false;
    }
    isOnSide |= corner > 0;
  }
  return isOnSide;
}

/** Whether a face is on the plane, between a cell on one side of the plane and one that is not. */
bool Patch::IsFace(const Cell& cell, int f, int side)
{
  for (const int i : FaceCorners[f])
  {
    const PiercedMesh::Vertex v = cell->vertex(i);
    if (this->Mesh.GetMesh().GetDelaunay().is_infinite(v) || this->SideOf(v) != 0)
    {
      return false;
    }
  }
  return this->IsOnSide(cell, side) != this->IsOnSide(cell->neighbor(f), side);
}

/**
 * The only face on the left of an edge, seen from the first of its corners. Faces whose third
 * corner is on the line of the edge count if there are no others.
 */
Patch::Left Patch::FindLeft(const CellEdge& edge, int side)
{
  const int a = edge.first->vertex(edge.second)->info().Index;
  const int b = edge.first->vertex(edge.third)->info().Index;
  const Point& origin = this->Mesh.PointOf(a);
  const Point along = this->Mesh.PointOf(b) - origin;
  Left found;
  double most = 0.0; // twice the area of the face found
  bool isOnly = true;
  for (const Cell& cell : this->Mesh.GetMesh().FindCellsAround(edge))
  {
    for (int f = 0; f < 4; ++f)
    {
      const int apex = cell->vertex(f)->info().Index;
      if (apex == a || apex == b || !this->IsFace(cell, f, side))
      {
        continue;
      }
      const auto isThird = [&](int i)
      { return cell->vertex(i)->info().Index != a && cell->vertex(i)->info().Index != b; };
      const int c =
        cell->vertex(*std::find_if(FaceCorners[f], FaceCorners[f] + 3, isThird))->info().Index;
      const double area = Dot(this->Normal, Cross(along, this->Mesh.PointOf(c) - origin));
      if (c == found.Corner || area <= 0.0)
      {
        continue;
      }
      isOnly &= std::min(area, most) <= this->Mesh.GetTolerance() * Length(along);
      found = area > most ? Left{ c, cell } : found;
      most = std::max(area, most);
    }
  }
  return isOnly ? found : Left();
}

std::vector<Triangle> Patch::FindFaces()
{
  std::vector<Triangle> faces = this->FindFaces(1);
  return faces.empty() ? this->FindFaces(-1) : faces;
}

/** The faces that bound the cells on one side: others are behind them where cells are flat. */
std::vector<Triangle> Patch::FindFaces(int side)
{
  std::unordered_map<std::uint64_t, int> border; // edges, and how many faces have them
  for (std::size_t i = 0; i < this->Loop.size(); ++i)
  {
    border[EdgeKey(this->Loop[i], this->Loop[(i + 1) % this->Loop.size()])] = 0;
  }
  std::set<Triangle> faces; // with the smallest corner first
  std::unordered_set<std::uint64_t> inside;
  std::unordered_set<int> vertices;
  const PiercedMesh& mesh = this->Mesh.GetMesh();
  const std::optional<CellEdge> first = mesh.FindEdge(this->Loop[0], this->Loop[1]);
  std::vector<CellEdge> stack; // with a face on the left
  if (first)
  {
    stack.push_back(*first);
  }
  while (!stack.empty())
  {
    const CellEdge edge = stack.back();
    stack.pop_back();
    const auto [c, cell] = this->FindLeft(edge, side);
    if (c < 0)
    {
      return {};
    }
    const int a = edge.first->vertex(edge.second)->info().Index;
    const int b = edge.first->vertex(edge.third)->info().Index;
    Triangle face = { a, b, c };
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    if (!faces.insert(face).second)
    {
      continue;
    }
    for (const auto& [p, q] : { Edge{ a, b }, Edge{ b, c }, Edge{ c, a } })
    {
      vertices.insert(p);
      const auto found = border.find(EdgeKey(p, q));
      if (found != border.end())
      {
        ++found->second;
      }
      else
      {
        inside.insert(EdgeKey(p, q));
        stack.emplace_back(cell, cell->index(mesh.GetVertex(q)), cell->index(mesh.GetVertex(p)));
      }
    }
  }
  const bool isClosed =
    std::all_of(border.begin(), border.end(), [](const auto& edge) { return edge.second == 1; });
  // A disk has an Euler characteristic of 1.
  const bool isDisk = vertices.size() + faces.size() == border.size() + inside.size() + 1;
  return isClosed && isDisk ? std::vector<Triangle>(faces.begin(), faces.end())
                            : std::vector<Triangle>();
}

std::vector<Patch::Cell> Patch::FindFlat()
{
  PiercedMesh& mesh = this->Mesh.GetMesh();
  std::vector<Cell> cells, flat;
  mesh.BeginWalk();
  for (const int vertex : this->Loop)
  {
    mesh.PushStar(mesh.GetVertex(vertex), cells);
  }
  for (const Cell& cell : cells)
  {
    const auto isOnPlane = [&](int i) { return this->SideOf(cell->vertex(i)) == 0; };
    if (isOnPlane(0) && isOnPlane(1) && isOnPlane(2) && isOnPlane(3))
    {
      flat.push_back(cell);
    }
  }
  return flat;
}

} // namespace carving::helper
