// SPDX-License-Identifier: BSD-3-Clause
#include "Implicit.h"

#include "PointMath.h"

#include <algorithm>
#include <map>
#include <utility>

using carving::Triangle;

namespace models
{
namespace
{

/** Marching tetrahedra: constructs the piece of the surface in each tetrahedron of a grid. */
class Marcher
{
public:
  Marcher(
    const Implicit& solid, const Point& lower, const Point& upper, const std::array<int, 3>& cells)
    : Solid(solid)
    , Cells(cells)
  {
    for (int k = 0; k <= cells[2]; ++k)
    {
      for (int j = 0; j <= cells[1]; ++j)
      {
        for (int i = 0; i <= cells[0]; ++i)
        {
          Point p = lower;
          const int node[3] = { i, j, k };
          for (int axis = 0; axis < 3; ++axis)
          {
            p[axis] += (upper[axis] - lower[axis]) * node[axis] / cells[axis];
          }
          this->Nodes.push_back(p);
          this->Values.push_back(solid(p));
        }
      }
    }
  }

  TriangleMesh March()
  {
    for (int k = 0; k < this->Cells[2]; ++k)
    {
      for (int j = 0; j < this->Cells[1]; ++j)
      {
        for (int i = 0; i < this->Cells[0]; ++i)
        {
          this->MarchCell(i + this->Step(1) * j + this->Step(2) * k);
        }
      }
    }
    return this->Mesh;
  }

private:
  /** The index difference between neighboring nodes along an axis. */
  int Step(int axis) const
  {
    return axis == 0 ? 1
      : axis == 1    ? this->Cells[0] + 1
                     : (this->Cells[0] + 1) * (this->Cells[1] + 1);
  }

  bool IsInside(int node) const
  {
    return this->Values[node] < 0.0;
  }

  /**
   * Splits a cube into six tetrahedra, one per order of the axes on a path from the first corner to
   * the last.
   */
  void MarchCell(int first)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const bool odd : { false, true })
      {
        const int second = first + this->Step(axis);
        const int third = second + this->Step((axis + (odd ? 2 : 1)) % 3);
        const int last = first + this->Step(0) + this->Step(1) + this->Step(2);
        this->MarchTetrahedron({ first, second, third, last }, odd);
      }
    }
  }

  /** `odd`: the tetrahedron is negatively oriented. */
  void MarchTetrahedron(std::array<int, 4> t, bool odd)
  {
    // Inside corners move to the front, which leaves three cases.
    for (int pass = 0; pass < 3; ++pass)
    {
      for (int i = 0; i < 3; ++i)
      {
        if (!this->IsInside(t[i]) && this->IsInside(t[i + 1]))
        {
          std::swap(t[i], t[i + 1]);
          odd = !odd;
        }
      }
    }
    const auto inside =
      std::count_if(t.begin(), t.end(), [&](int node) { return this->IsInside(node); });
    if (odd)
    {
      const int pair = inside == 3 ? 0 : 2;
      std::swap(t[pair], t[pair + 1]);
    }
    switch (inside)
    {
      case 1:
        this->Add({ this->Cut(t[0], t[1]), this->Cut(t[0], t[2]), this->Cut(t[0], t[3]) });
        break;
      case 2:
      {
        const int a = this->Cut(t[0], t[2]), b = this->Cut(t[0], t[3]);
        const int c = this->Cut(t[1], t[3]), d = this->Cut(t[1], t[2]);
        this->Add({ a, b, c });
        this->Add({ a, c, d });
        break;
      }
      case 3:
        this->Add({ this->Cut(t[0], t[3]), this->Cut(t[1], t[3]), this->Cut(t[2], t[3]) });
        break;
      default:
        break;
    }
  }

  void Add(const Triangle& t)
  {
    this->Mesh.Triangles.push_back(t);
  }

  /** The vertex of the surface on an edge. */
  int Cut(int a, int b)
  {
    const auto [found, isNew] =
      this->Cuts.try_emplace(std::minmax(a, b), static_cast<int>(this->Mesh.Points.size()));
    if (isNew)
    {
      this->Mesh.Points.push_back(this->IsInside(a) ? this->FindZero(a, b) : this->FindZero(b, a));
    }
    return found->second;
  }

  /**
   * Finds the zero on an edge by bisection. The result keeps away from the nodes to avoid slivers.
   */
  Point FindZero(int insideNode, int outsideNode) const
  {
    const Point start = this->Nodes[insideNode];
    const Point direction = this->Nodes[outsideNode] - start;
    double inside = 0.0, outside = 1.0;
    for (int i = 0; i < 12; ++i)
    {
      const double middle = 0.5 * (inside + outside);
      (this->Solid(start + middle * direction) < 0.0 ? inside : outside) = middle;
    }
    return start + std::clamp(0.5 * (inside + outside), 0.1, 0.9) * direction;
  }

  const Implicit& Solid;
  std::array<int, 3> Cells;
  std::vector<Point> Nodes;
  std::vector<double> Values;
  std::map<std::pair<int, int>, int> Cuts;
  TriangleMesh Mesh;
};

} // namespace

TriangleMesh Isosurface(
  const Implicit& solid, const Point& lower, const Point& upper, const std::array<int, 3>& cells)
{
  return Marcher(solid, lower, upper, cells).March();
}

double SmoothMin(double a, double b, double width)
{
  const double overlap = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - 0.25 * width * overlap * overlap;
}

double SmoothMax(double a, double b, double width)
{
  return -SmoothMin(-a, -b, width);
}

double SegmentDistance(const Point& p, const Point& a, const Point& b)
{
  const Point direction = b - a;
  const double t = carving::Dot(p - a, direction) / carving::Dot(direction, direction);
  return Distance(p, a + std::clamp(t, 0.0, 1.0) * direction);
}

} // namespace models
