// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/WindingTree.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/MedianSplit.h"
#include "Core/Mesh/Vector.h"
#include "Core/Solid/Winding.h"

#include <algorithm>

namespace carving
{
namespace
{

constexpr int LeafSize = 4;

/** A node is distant from a point if the distance of its center exceeds `Opening` radii. */
struct Accuracy
{
  double Opening;
  double Margin; ///< well above the largest error measured on soups and open shells
};
constexpr Accuracy Accuracies[] = { { 2.0, 8e-2 }, { 4.0, 2e-2 }, { 8.0, 5e-3 }, { 16.0, 5e-4 } };

/** The normal of a triangle with the length of its area. */
Point AreaVector(const ResolvedMesh& mesh, int t)
{
  const Triangle& corner = mesh.Facets[t];
  const Point& a = mesh.Points[corner[0]];
  return 0.5 * Cross(mesh.Points[corner[1]] - a, mesh.Points[corner[2]] - a);
}

} // namespace

WindingTree::WindingTree(const ResolvedMesh& mesh)
  : Mesh(mesh)
{
  std::vector<Item> items;
  for (std::size_t t = 0; t < mesh.Facets.size(); ++t)
  {
    if (mesh.SignedMultiplicities[t] != 0)
    {
      const auto& [a, b, c] = mesh.Facets[t];
      items.push_back({ mesh.Points[a] / 3.0 + mesh.Points[b] / 3.0 + mesh.Points[c] / 3.0,
        static_cast<int>(t) });
    }
  }
  if (!items.empty())
  {
    this->Build(items, 0, static_cast<int>(items.size()));
  }
  for (const Item& item : items)
  {
    this->Triangles.push_back(item.Triangle);
  }
}

void WindingTree::Build(std::vector<Item>& items, int first, int last)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.push_back(this->Summarize(items, first, last));
  if (last - first <= LeafSize)
  {
    return;
  }
  const auto begin = items.begin() + first, end = items.begin() + last;
  Box bounds;
  for (auto item = begin; item != end; ++item)
  {
    bounds.Add(item->Centroid);
  }
  const int middle =
    static_cast<int>(SplitAtMedian(
                       begin, end, bounds.Upper - bounds.Lower,
                       [](const Item& item) -> const Point& { return item.Centroid; },
                       [](const Item& item) { return item.Triangle; }) -
      items.begin());
  this->Build(items, first, middle);
  this->Nodes[index].Second = static_cast<int>(this->Nodes.size());
  this->Build(items, middle, last);
}

WindingTree::Node WindingTree::Summarize(const std::vector<Item>& items, int first, int last) const
{
  Node node = { first, last, -1, {}, 0.0, {}, {} };
  double total = 0.0;
  for (int i = first; i < last; ++i)
  {
    const double area = Length(AreaVector(this->Mesh, items[i].Triangle));
    total += area;
    node.Center = node.Center + area * items[i].Centroid;
  }
  node.Center = node.Center / total;
  for (int i = first; i < last; ++i)
  {
    const int t = items[i].Triangle;
    const Point area = AreaVector(this->Mesh, t);
    const Point offset = items[i].Centroid - node.Center;
    for (int k = 0; k < 3; ++k)
    {
      node.Area[k] += this->Mesh.SignedMultiplicities[t] * area[k];
      for (int l = 0; l < 3; ++l)
      {
        node.Skew[k][l] += this->Mesh.SignedMultiplicities[t] * area[k] * offset[l];
      }
      node.Radius =
        std::max(node.Radius, Length(this->Mesh.Points[this->Mesh.Facets[t][k]] - node.Center));
    }
  }
  return node;
}

double WindingTree::Approximate(const Point& point, double opening) const
{
  double angles = 0.0;
  std::vector<int> stack(this->Nodes.empty() ? 0 : 1, 0);
  while (!stack.empty())
  {
    const int index = stack.back();
    stack.pop_back();
    const Node& node = this->Nodes[index];
    const Point r = node.Center - point;
    const double square = Dot(r, r);
    if (square > opening * opening * node.Radius * node.Radius)
    {
      // The integral of n . x / |x|^3, expanded around the center.
      double trace = 0.0, twice = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        trace += node.Skew[k][k];
        twice += r[k] * Dot(node.Skew[k], r);
      }
      const double cube = square * std::sqrt(square);
      angles += (Dot(node.Area, r) + trace - 3.0 * twice / square) / cube;
    }
    else if (node.Second >= 0)
    {
      stack.push_back(node.Second);
      stack.push_back(index + 1);
    }
    else
    {
      for (int i = node.First; i < node.Last; ++i)
      {
        const int t = this->Triangles[i];
        angles += this->Mesh.SignedMultiplicities[t] * SolidAngle(this->Mesh, t, point);
      }
    }
  }
  return angles / (4.0 * std::acos(-1.0));
}

double WindingTree::Measure(const Point& point, const std::vector<double>& thresholds) const
{
  for (const auto& [opening, margin] : Accuracies)
  {
    const double winding = this->Approximate(point, opening);
    const double off = std::abs(winding - std::round(winding));
    if (std::none_of(thresholds.begin(), thresholds.end(),
          [off, margin = margin](double t) { return std::abs(off - t) < margin; }))
    {
      return winding;
    }
  }
  return WindingNumber(this->Mesh, point);
}

} // namespace carving
