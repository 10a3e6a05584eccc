// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/BoxTree.h"

#include "Core/Mesh/MedianSplit.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace carving::helper
{
namespace
{

constexpr int LeafSize = 4;

} // namespace

Box::Box()
{
  this->Lower.fill(std::numeric_limits<double>::infinity());
  this->Upper.fill(-std::numeric_limits<double>::infinity());
}

Box::Box(std::initializer_list<Point> points)
  : Box()
{
  for (const Point& p : points)
  {
    this->Add(p);
  }
}

void Box::Add(const Point& p)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Lower[i] = std::min(this->Lower[i], p[i]);
    this->Upper[i] = std::max(this->Upper[i], p[i]);
  }
}

void Box::Add(const Box& other)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Lower[i] = std::min(this->Lower[i], other.Lower[i]);
    this->Upper[i] = std::max(this->Upper[i], other.Upper[i]);
  }
}

BoxTree::BoxTree(const std::vector<Box>& boxes)
  : Boxes(boxes)
  , LeafOf(boxes.size(), -1)
{
  std::vector<Point> centers(boxes.size());
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
  {
    if (boxes[i].Lower[0] <= boxes[i].Upper[0])
    {
      centers[i] = Between(boxes[i].Lower, boxes[i].Upper, 0.5);
      this->Order.push_back(i);
    }
  }
  if (!this->Order.empty())
  {
    this->Build(centers, 0, static_cast<int>(this->Order.size()), -1);
  }
}

void BoxTree::Build(const std::vector<Point>& centers, int first, int last, int parent)
{
  const int index = static_cast<int>(this->Nodes.size());
  Node node = { {}, first, last, 0, parent };
  for (int i = first; i < last; ++i)
  {
    node.Bounds.Add(this->Boxes[this->Order[i]]);
  }
  this->Nodes.push_back(node);
  if (last - first <= LeafSize)
  {
    for (int i = first; i < last; ++i)
    {
      this->LeafOf[this->Order[i]] = index;
    }
    return;
  }
  const auto begin = this->Order.begin();
  const int middle =
    static_cast<int>(SplitAtMedian(
                       begin + first, begin + last, node.Bounds.Upper - node.Bounds.Lower,
                       [&](int i) -> const Point& { return centers[i]; }, [](int i) { return i; }) -
      begin);
  this->Build(centers, first, middle, index);
  this->Nodes[index].Second = static_cast<int>(this->Nodes.size());
  this->Build(centers, middle, last, index);
}

void BoxTree::Update(int index, const Box& box)
{
  this->Boxes[index] = box;
  for (int at = this->LeafOf[index]; at >= 0; at = this->Nodes[at].Parent)
  {
    Node& node = this->Nodes[at];
    Box bounds;
    if (node.Second > 0)
    {
      bounds = this->Nodes[at + 1].Bounds;
      bounds.Add(this->Nodes[node.Second].Bounds);
    }
    else
    {
      for (int i = node.First; i < node.Last; ++i)
      {
        bounds.Add(this->Boxes[this->Order[i]]);
      }
    }
    if (bounds.Lower == node.Bounds.Lower && bounds.Upper == node.Bounds.Upper)
    {
      return;
    }
    node.Bounds = bounds;
  }
}

} // namespace carving::helper
