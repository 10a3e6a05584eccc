// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A search tree over boxes that may change.
 */
#ifndef carving_BoxTree_h
#define carving_BoxTree_h

#include "Core/Mesh/Box.h"
#include "Core/Mesh/MedianSplit.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace carving
{

/**
 * A bounding volume hierarchy over items with axis-aligned boxes. `Items` is cheap to copy and has
 * two functions: `GetNumberOfItems()`, and `BoxOf(i)`. The boxes themselves are not stored. Items
 * whose boxes are empty are never found.
 */
template <class Items>
class BoxTree
{
public:
  explicit BoxTree(const Items& items)
    : All(items)
  {
    this->Rebuild();
  }

  const Items& GetItems() const
  {
    return this->All;
  }

  /** Makes the tree anew, without the items whose boxes are empty now. */
  void Rebuild()
  {
    this->Order = {};
    this->Nodes = {};
    this->LeafOf = {};
    const int items = static_cast<int>(this->All.GetNumberOfItems());
    std::size_t count = 0;
    for (int i = 0; i < items; ++i)
    {
      count += !this->All.BoxOf(i).IsEmpty();
    }
    std::vector<Entry> entries;
    entries.reserve(count); // the collapses of edges need most memory while a tree is rebuilt
    for (int i = 0; i < items; ++i)
    {
      const Box box = this->All.BoxOf(i);
      if (!box.IsEmpty())
      {
        entries.push_back({ box, i });
      }
    }
    if (!entries.empty())
    {
      this->Build(entries, 0, static_cast<int>(entries.size()), -1);
    }
    this->Nodes.shrink_to_fit();
    this->Order.reserve(entries.size());
    for (const Entry& entry : entries)
    {
      this->Order.push_back(entry.Item);
    }
  }

  /** Updates the tree after the box of an item, which was not empty at first, has changed. */
  void Update(int item)
  {
    if (this->LeafOf.empty())
    {
      this->AssignLeaves();
    }
    for (int at = this->LeafOf[item]; at >= 0; at = this->Nodes[at].Parent)
    {
      const Box bounds = this->BoundsOf(at);
      Box& known = this->Nodes[at].Bounds;
      if (bounds.Lower == known.Lower && bounds.Upper == known.Upper)
      {
        return;
      }
      known = bounds;
    }
  }

  /** Whether `predicate` holds for any item whose box overlaps another one. Stops at the first. */
  template <class Predicate>
  bool AnyOverlap(const Box& box, Predicate&& predicate) const
  {
    return this->Any([&box](const Box& other) { return other.Overlaps(box); }, predicate);
  }

  /**
   * Whether `predicate` holds for any item whose box `meets` accepts. It has to accept all boxes
   * around an accepted one.
   */
  template <class BoxPredicate, class Predicate>
  bool Any(BoxPredicate&& meets, Predicate&& predicate) const
  {
    return this->Walk(
      meets, [](const Box&, const Box&) { return false; },
      [&](int item) { return meets(this->All.BoxOf(item)) && predicate(item); });
  }

  /**
   * Calls `visit` with each item whose box `meets` accepts, and with the other items of its leaf.
   * `meets` has to accept all boxes around an accepted one. Boxes that reach farther up in a
   * direction mostly come first.
   */
  template <class Predicate, class Visitor>
  void ForEachFromTop(const Point& up, Predicate&& meets, Visitor&& visit) const
  {
    this->Walk(
      meets,
      [&up](const Box& a, const Box& b) { return GreatestProduct(up, a) < GreatestProduct(up, b); },
      [&visit](int item)
      {
        visit(item);
        return false;
      });
  }

  /**
   * Calls `visit` with items, mostly nearest to p first. It returns the squared distance from which
   * on boxes are of no more interest, which is `limit` at first.
   */
  template <class Visitor>
  void ForEachNear(const Point& p, double limit, Visitor&& visit) const
  {
    std::array<std::pair<double, int>, MostLevels> open;
    int count = 0;
    if (!this->Nodes.empty())
    {
      open[count++] = { 0.0, 0 };
    }
    while (count > 0)
    {
      const auto [bound, index] = open[--count];
      if (bound >= limit)
      {
        continue;
      }
      const Node& node = this->Nodes[index];
      if (node.Second > 0)
      {
        std::pair<double, int> near = { this->Nodes[index + 1].Bounds.SquaredDistanceTo(p),
          index + 1 };
        std::pair<double, int> far = { this->Nodes[node.Second].Bounds.SquaredDistanceTo(p),
          node.Second };
        if (far < near)
        {
          std::swap(near, far);
        }
        open[count++] = far;
        open[count++] = near; // first
        continue;
      }
      for (int i = node.First; i < node.Last; ++i)
      {
        const int item = this->Order[i];
        if (this->All.BoxOf(item).SquaredDistanceTo(p) < limit)
        {
          limit = visit(item);
        }
      }
    }
  }

private:
  static constexpr int LeafSize = 8;
  static constexpr int MostLevels = 64; // 2^31 items have at most 31 levels

  /** The box of items First to Last - 1 of the order. The first child is the next node. */
  struct Node
  {
    Box Bounds;
    int First, Last;
    int Second; ///< the second child; 0 for a leaf
    int Parent;
  };

  struct Entry
  {
    Box Bounds;
    int Item;
  };

  /**
   * Visits the items of the leaves that `meets` accepts, until `visit` returns true. Returns
   * whether it has. `isLater` says of two children whether the first one comes later.
   */
  template <class Predicate, class IsLater, class Visitor>
  bool Walk(Predicate&& meets, IsLater&& isLater, Visitor&& visit) const
  {
    std::array<int, MostLevels> open;
    int count = 0;
    if (!this->Nodes.empty())
    {
      open[count++] = 0;
    }
    while (count > 0)
    {
      const int index = open[--count];
      const Node& node = this->Nodes[index];
      if (!meets(node.Bounds))
      {
        continue;
      }
      if (node.Second > 0)
      {
        int next = index + 1, last = node.Second;
        if (isLater(this->Nodes[next].Bounds, this->Nodes[last].Bounds))
        {
          std::swap(next, last);
        }
        open[count++] = last;
        open[count++] = next;
        continue;
      }
      if (std::any_of(this->Order.begin() + node.First, this->Order.begin() + node.Last, visit))
      {
        return true;
      }
    }
    return false;
  }

  void Build(std::vector<Entry>& entries, int first, int last, int parent)
  {
    const int index = static_cast<int>(this->Nodes.size());
    Node node = { {}, first, last, 0, parent };
    for (int i = first; i < last; ++i)
    {
      node.Bounds.Add(entries[i].Bounds);
    }
    this->Nodes.push_back(node);
    if (last - first <= LeafSize)
    {
      return;
    }
    const auto begin = entries.begin();
    const auto middle = SplitAtMedian(
      begin + first, begin + last, node.Bounds.Upper - node.Bounds.Lower,
      [](const Entry& entry) { return entry.Bounds.Lower + entry.Bounds.Upper; },
      [](const Entry& entry) { return entry.Item; });
    const int split = static_cast<int>(middle - begin);
    this->Build(entries, first, split, index);
    this->Nodes[index].Second = static_cast<int>(this->Nodes.size());
    this->Build(entries, split, last, index);
  }

  void AssignLeaves()
  {
    this->LeafOf.resize(this->All.GetNumberOfItems(), -1);
    for (std::size_t at = 0; at < this->Nodes.size(); ++at)
    {
      const Node& node = this->Nodes[at];
      for (int i = node.First; node.Second == 0 && i < node.Last; ++i)
      {
        this->LeafOf[this->Order[i]] = static_cast<int>(at);
      }
    }
  }

  /** The bounds of a node from those of its children, or of its items. */
  Box BoundsOf(int at) const
  {
    const Node& node = this->Nodes[at];
    if (node.Second > 0)
    {
      Box bounds = this->Nodes[at + 1].Bounds;
      bounds.Add(this->Nodes[node.Second].Bounds);
      return bounds;
    }
    Box bounds;
    for (int i = node.First; i < node.Last; ++i)
    {
      bounds.Add(this->All.BoxOf(this->Order[i]));
    }
    return bounds;
  }

  Items All;
  std::vector<int> Order;
  std::vector<Node> Nodes;
  std::vector<int> LeafOf; ///< per item; only if boxes have changed
};

} // namespace carving

#endif
