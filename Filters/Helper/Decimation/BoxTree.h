// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * A search tree over boxes that may change.
 */
#ifndef carving_BoxTree_h
#define carving_BoxTree_h

#include "Core/Mesh/Mesh.h"

#include <initializer_list>
#include <utility>
#include <vector>

namespace carving::helper
{

/** An axis-aligned box, initially empty. */
struct Box
{
  Point Lower, Upper;

  Box();
  explicit Box(std::initializer_list<Point> points);
  void Add(const Point& p);
  void Add(const Box& other);
  bool Overlaps(const Box& other) const
  {
    return this->Lower[0] <= other.Upper[0] && other.Lower[0] <= this->Upper[0] &&
      this->Lower[1] <= other.Upper[1] && other.Lower[1] <= this->Upper[1] &&
      this->Lower[2] <= other.Upper[2] && other.Lower[2] <= this->Upper[2];
  }
};

/**
 * A bounding volume hierarchy whose boxes can be replaced one by one. Empty boxes are never found.
 */
class BoxTree
{
public:
  explicit BoxTree(const std::vector<Box>& boxes);

  /** Replaces a box, and those of the nodes that contain it. */
  void Update(int index, const Box& box);

  /** Calls `visit` with the index of each box that overlaps another one. */
  template <class Visitor>
  void ForEachOverlap(const Box& box, Visitor&& visit) const
  {
    this->ForEach([&box](const Box& other) { return other.Overlaps(box); }, visit);
  }

  /**
   * Calls `visit` with the index of each box that `meets` accepts, as it must all boxes around an
   * accepted one.
   */
  template <class Predicate, class Visitor>
  void ForEach(Predicate&& meets, Visitor&& visit) const
  {
    this->Walk(
      meets, [](const Box&, const Box&) { return false; }, visit);
  }

  /** The same, with boxes that reach farther up in a direction mostly first. */
  template <class Predicate, class Visitor>
  void ForEachFromTop(const Point& up, Predicate&& meets, Visitor&& visit) const
  {
    const auto top = [&up](const Box& box)
    {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        sum += up[k] * (up[k] > 0.0 ? box.Upper[k] : box.Lower[k]);
      }
      return sum;
    };
    this->Walk(
      meets, [&top](const Box& a, const Box& b) { return top(a) < top(b); }, visit);
  }

private:
  /** `isLater` says of two children whether the first one comes later. */
  template <class Predicate, class Order, class Visitor>
  void Walk(Predicate&& meets, Order&& isLater, Visitor&& visit) const
  {
    int open[64];
    int count = 0;
    if (!this->Nodes.empty())
    {
      open[count++] = 0;
    }
    while (count > 0)
    {
      const Node& node = this->Nodes[open[--count]];
      if (!meets(node.Bounds))
      {
        continue;
      }
      if (node.Second > 0)
      {
        int next = static_cast<int>(&node - this->Nodes.data()) + 1, last = node.Second;
        if (isLater(this->Nodes[next].Bounds, this->Nodes[last].Bounds))
        {
          std::swap(next, last);
        }
        open[count++] = last;
        open[count++] = next;
        continue;
      }
      for (int i = node.First; i < node.Last; ++i)
      {
        if (meets(this->Boxes[this->Order[i]]))
        {
          visit(this->Order[i]);
        }
      }
    }
  }

  struct Node
  {
    Box Bounds;
    int First, Last; ///< of Order
    int Second;      ///< the second child, the first is the next node; 0 for a leaf
    int Parent;
  };

  void Build(const std::vector<Point>& centers, int first, int last, int parent);

  std::vector<Box> Boxes;
  std::vector<int> Order;
  std::vector<int> LeafOf;
  std::vector<Node> Nodes;
};

} // namespace carving::helper

#endif
