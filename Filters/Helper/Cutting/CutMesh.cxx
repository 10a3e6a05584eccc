// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Cutting/CutMesh.h"

#include "Helper/Enclosing/CellShape.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carving::helper
{
namespace
{

constexpr int NoWay = -1, Again = -2; ///< instead of a vertex

/** A line from one point towards another. */
class Line
{
public:
  Line(const Point& from, const Point& to)
    : From(from)
    , Along((to - from) / Length(to - from))
  {
  }

  double DistanceTo(const Point& p) const
  {
    return Length(Cross(p - this->From, this->Along));
  }

  bool IsAhead(const Point& p) const
  {
    return Dot(p - this->From, this->Along) > 0.0;
  }

  struct Approach
  {
    double Distance = HUGE_VAL;
    double Share = 0.0; ///< of the way from a to b
  };

  /** Where the inside of the segment ab comes closest. */
  Approach ApproachTo(const Point& a, const Point& b) const
  {
    const Point normal = Cross(b - a, this->Along);
    const double squared = Dot(normal, normal);
    const Point toLine = this->From - a;
    const double share = Dot(Cross(toLine, this->Along), normal) / squared;
    if (squared > 0.0 && share > 0.0 && share < 1.0)
    {
      return { std::abs(Dot(toLine, normal)) / std::sqrt(squared), share };
    }
    return {};
  }

private:
  Point From, Along;
};

} // namespace

CutMesh::CutMesh(PiercedMesh& mesh, double tolerance)
  : Mesh(mesh)
  , Tolerance(tolerance)
  , IsLink([this](int a, int b) { return this->Edges.IsLink(a, b); })
{
}

bool CutMesh::IsEdge(int a, int b) const
{
  return this->Mesh.FindEdge(a, b).has_value();
}

bool CutMesh::Connect(int a, int b)
{
  if (this->Edges.Has(a, b))
  {
    return true;
  }
  constexpr int mostSwaps = 4;
  int swaps = 0;
  std::vector<int> chain = { a };
  double distance = Length(this->PointOf(b) - this->PointOf(a));
  while (chain.back() != b)
  {
    const int next = this->Step(chain.back(), b);
    if (next == Again)
    {
      continue;
    }
    const double left = next == NoWay ? HUGE_VAL : Length(this->PointOf(b) - this->PointOf(next));
    // Vertices that nearly coincide are at the same distance, or swapped.
    const bool isSwapped = !(left < distance) && left < distance + this->Tolerance &&
      std::find(chain.begin(), chain.end(), next) == chain.end();
    if (!(left < distance) && !(isSwapped && ++swaps <= mostSwaps))
    {
      return false;
    }
    distance = std::min(left, distance);
    chain.push_back(next);
  }
  this->Edges.Add(chain);
  return true;
}

/** Returns the next vertex on the way, NoWay, or Again if a flip has shortened the way. */
int CutMesh::Step(int from, int to)
{
  if (this->IsEdge(from, to))
  {
    return to;
  }
  const Exit exit = this->FindExit(from, to);
  return exit.Of == Cell() ? this->FollowHull(from, to) : this->CrossFace(from, to, exit);
}

/**
 * The next vertex on a segment that is outside of all tetrahedra by a rounding: on a flat side of
 * the hull.
 */
int CutMesh::FollowHull(int from, int to)
{
  const Line line(this->PointOf(from), this->PointOf(to));
  const PiercedMesh::Vertex start = this->Mesh.GetVertex(from);
  std::vector<Cell> star;
  this->Mesh.GetDelaunay().finite_incident_cells(start, std::back_inserter(star));
  Line::Approach closest;
  std::array<int, 2> edge = {};
  for (const Cell& cell : star)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int a = cell->vertex(FaceCorners[cell->index(start)][i])->info().Index;
      const int b = cell->vertex(FaceCorners[cell->index(start)][(i + 1) % 3])->info().Index;
      if (line.DistanceTo(this->PointOf(a)) < this->Tolerance && line.IsAhead(this->PointOf(a)))
      {
        return a;
      }
      const Line::Approach approach = line.ApproachTo(this->PointOf(a), this->PointOf(b));
      if (approach.Distance < closest.Distance &&
        line.IsAhead(Between(this->PointOf(a), this->PointOf(b), approach.Share)))
      {
        closest = approach;
        edge = { a, b };
      }
    }
  }
  return closest.Distance < this->Tolerance ? this->SplitEdge(edge[0], edge[1], closest.Share)
                                            : NoWay;
}

/** The face through which a segment leaves the tetrahedra around its first end. */
CutMesh::Exit CutMesh::FindExit(int from, int to) const
{
  const PiercedMesh::Vertex start = this->Mesh.GetVertex(from), end = this->Mesh.GetVertex(to);
  std::vector<Cell> star;
  this->Mesh.GetDelaunay().finite_incident_cells(start, std::back_inserter(star));
  for (const Cell& cell : star)
  {
    const int f = cell->index(start);
    const Corners3 face = FaceOf(cell, f);
    bool isThrough = true, onBorder = false;
    for (int i = 0; i < 3 && isThrough; ++i)
    {
      const CGAL::Orientation side =
        CGAL::orientation(start->point(), face[i], face[(i + 1) % 3], end->point());
      isThrough = side != CGAL::NEGATIVE;
      onBorder |= side == CGAL::COPLANAR;
    }
    // The end may also be behind the start.
    if (isThrough && CGAL::orientation(face[0], face[1], face[2], end->point()) == CGAL::POSITIVE)
    {
      return { cell, f, onBorder };
    }
  }
  return { Cell(), 0, false };
}

int CutMesh::CrossFace(int from, int to, const Exit& exit)
{
  const Line line(this->PointOf(from), this->PointOf(to));
  std::array<int, 3> corners;
  std::array<Point, 3> points;
  for (int i = 0; i < 3; ++i)
  {
    corners[i] = exit.Of->vertex(FaceCorners[exit.Face][i])->info().Index;
    points[i] = this->PointOf(corners[i]);
    if (line.DistanceTo(points[i]) < this->Tolerance)
    {
      return corners[i];
    }
  }
  Line::Approach closest;
  int edge = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Line::Approach approach = line.ApproachTo(points[i], points[(i + 1) % 3]);
    if (approach.Distance < closest.Distance)
    {
      closest = approach;
      edge = i;
    }
  }
  if (closest.Distance < this->Tolerance || (exit.OnBorder && closest.Distance < HUGE_VAL))
  {
    return this->SplitEdge(corners[edge], corners[(edge + 1) % 3], closest.Share);
  }
  ++this->Effort;
  if (this->Mesh.FlipFace(exit.Of, exit.Face))
  {
    return Again;
  }
  const Point &start = this->PointOf(from), &end = this->PointOf(to);
  const double before = std::abs(SixVolume(points[0], points[1], points[2], start));
  const double behind = std::abs(SixVolume(points[0], points[1], points[2], end));
  const double share = before / (before + behind);
  return share > 0.0 && share < 1.0
    ? this->SplitFaceAt(exit.Of, exit.Face, Between(start, end, share))
    : NoWay;
}

int CutMesh::SplitEdge(int a, int b, double share)
{
  const Point from = this->PointOf(a), to = this->PointOf(b);
  // Rounding turns other cells over at other points; all of these are within the tolerance.
  const double shift = 0.1 * this->Tolerance / Length(to - from);
  for (const double shifts : { 0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0 })
  {
    ++this->Effort;
    const int vertex =
      this->Mesh.SplitEdge(a, b, Between(from, to, share + shifts * shift), this->IsLink);
    if (vertex >= 0)
    {
      this->Added.push_back(vertex);
      this->Edges.Split(a, b, vertex);
      return vertex;
    }
  }
  this->RemoveFlat(this->Mesh.FindCellsAround(a, b));
  return NoWay;
}

int CutMesh::SplitFaceAt(const Cell& cell, int f, const Point& p)
{
  ++this->Effort;
  const int vertex = this->Mesh.SplitFace(cell, f, p, this->IsLink);
  if (vertex >= 0)
  {
    this->Added.push_back(vertex);
    return vertex;
  }
  this->RemoveFlat({ cell->neighbor(f), cell });
  return NoWay;
}

bool CutMesh::FlipEdge(int a, int b, const std::vector<Cell>& around)
{
  constexpr std::size_t replaced = 3; // cells, by two
  if (around.size() != replaced || this->Edges.IsLink(a, b))
  {
    return false;
  }
  ++this->Effort;
  return this->Mesh.FlipEdge(a, b, { around[0], around[1], around[2] });
}

void CutMesh::RemoveFlat(const std::vector<Cell>& cells)
{
  for (const Cell& cell : cells)
  {
    if (this->Mesh.GetDelaunay().is_infinite(cell))
    {
      continue;
    }
    double area = 0.0; // twice that of the largest face
    for (int f = 0; f < 4; ++f)
    {
      const Corners3 face = FaceOf(cell, f);
      area = std::max(area,
        Length(Cross(ToPoint(face[1]) - ToPoint(face[0]), ToPoint(face[2]) - ToPoint(face[0]))));
    }
    if (SixVolumeOf(CornersOf(cell)) > this->Tolerance * area)
    {
      continue;
    }
    ++this->Effort;
    const PiercedMesh::Flattened flattened = this->Mesh.RemoveFlat(cell, this->IsLink);
    if (flattened.IsRemoved)
    {
      this->IsRepaired = true;
      if (flattened.Crossing >= 0)
      {
        this->Added.push_back(flattened.Crossing);
        for (const auto& [a, b] : flattened.Edges)
        {
          this->Edges.Split(a, b, flattened.Crossing);
        }
      }
      return;
    }
  }
}

bool CutMesh::TakeRepair()
{
  return std::exchange(this->IsRepaired, false);
}

void CutMesh::Thin()
{
  constexpr int rounds = 2; // neighbors that have gone make room
  for (int round = 0; round < rounds; ++round)
  {
    std::reverse(this->Added.begin(), this->Added.end());
    const auto isGone = [&](int vertex)
    {
      ++this->Effort;
      const bool gone =
        this->Mesh.RemoveVertex(vertex, [&](int u) { return this->Edges.MayMove(vertex, u); }) >= 0;
      if (gone)
      {
        this->Edges.Remove(vertex);
      }
      return gone;
    };
    this->Added.erase(
      std::remove_if(this->Added.begin(), this->Added.end(), isGone), this->Added.end());
  }
  this->Added.clear();
}

} // namespace carving::helper
