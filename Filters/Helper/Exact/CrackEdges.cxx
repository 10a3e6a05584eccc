// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Exact/CrackEdges.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/SortUnique.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/Kernels.h"
#include "Helper/Base/SortedEdge.h"
#include "Helper/Resolve/NearPairs.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace carving::helper
{
namespace
{

using Edge = std::array<int, 2>;
using Edges = std::vector<Edge>; // in ascending order

/** A place at which an edge passes through a crack. */
struct Passage
{
  double Share;    ///< of the way from the lower end
  double Distance; ///< from an edge of the crack
};

using Passages = std::map<Edge, Passage>;

/** All edges of facets, once for each facet. */
Edges FindEdges(const ResolvedMesh& mesh)
{
  Edges edges;
  edges.reserve(3 * mesh.Facets.size());
  for (const Triangle& t : mesh.Facets)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.push_back(SortedEdge(t[i], t[(i + 1) % 3]));
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/** The edges that occur an odd number of times. */
Edges FindRims(const Edges& edges)
{
  Edges rims;
  for (auto first = edges.begin(), last = first; first != edges.end(); first = last)
  {
    last = std::upper_bound(first, edges.end(), *first);
    if ((last - first) % 2 != 0)
    {
      rims.push_back(*first);
    }
  }
  return rims;
}

/** The share of the way along an edge at which it is closest to a point. */
double ShareAt(const std::vector<Point>& points, const Edge& edge, const Point& p)
{
  const Point along = points[edge[1]] - points[edge[0]];
  return std::clamp(Dot(along, p - points[edge[0]]) / Dot(along, along), 0.0, 1.0);
}

Point PointAt(const std::vector<Point>& points, const Edge& edge, double share)
{
  return Between(points[edge[0]], points[edge[1]], share);
}

/** The rims that an end of another rim is close to. */
Edges FindCracks(const std::vector<Point>& points, const Edges& rims, double width)
{
  std::vector<std::array<int, 1>> ends;
  for (const auto& [a, b] : rims)
  {
    ends.push_back({ a });
    ends.push_back({ b });
  }
  SortUnique(ends);
  Edges cracks;
  VisitPairs(WidenedBoxes(points, ends, width), WidenedBoxes(points, rims, 0.0),
    [&](int i, int k)
    {
      const int end = ends[i][0];
      const Edge& rim = rims[k];
      const Point& p = points[end];
      if (end != rim[0] && end != rim[1] &&
        Length(PointAt(points, rim, ShareAt(points, rim, p)) - p) <= width)
      {
        cracks.push_back(rim);
      }
    });
  SortUnique(cracks);
  return cracks;
}

/** Where an edge passes an edge of a crack, more than a crack's width away from its own ends. */
std::optional<Passage> FindPassage(
  const std::vector<Point>& points, const Edge& edge, const Edge& crack, double width)
{
  const Point u = points[edge[1]] - points[edge[0]], v = points[crack[1]] - points[crack[0]];
  const Point between = points[crack[0]] - points[edge[0]];
  const Point normal = Cross(u, v);
  const double squared = Dot(normal, normal), length = Length(u);
  const double share = Dot(Cross(between, v), normal) / squared;
  if (!(share * length > 2.0 * width && (1.0 - share) * length > 2.0 * width)) // false for NaN
  {
    return std::nullopt;
  }
  const Point p = PointAt(points, edge, share);
  const double distance = Length(PointAt(points, crack, ShareAt(points, crack, p)) - p);
  return distance <= width ? std::optional<Passage>({ share, distance }) : std::nullopt;
}

/** Splits edges of a tetrahedralization. */
class EdgeSplitter
{
public:
  EdgeSplitter(Tetrahedralization& mesh, const Passages& passages, double width)
    : Mesh(mesh)
    , Width(width)
  {
    const int count = static_cast<int>(mesh.Cells.size());
    for (int cell = 0; cell < count; ++cell)
    {
      this->Constraints.push_back(mesh.Constraints.Get(cell));
      this->ForEachEdge(cell,
        [&](const Edge& edge)
        {
          if (passages.count(edge) != 0)
          {
            this->CellsAround[edge].push_back(cell);
          }
        });
    }
  }

  /** Splits an edge near a place. Returns whether that was possible. */
  bool Split(const Edge& edge, const Passage& passage);

  /** Hands the facets on which faces lie over to the mesh. */
  void Finish()
  {
    this->Mesh.Constraints = FaceConstraints<3>(this->Constraints);
  }

private:
  template <class Visit>
  void ForEachEdge(int cell, const Visit& visit) const
  {
    const auto& c = this->Mesh.Cells[cell];
    for (int i = 0; i < 3; ++i)
    {
      for (int k = i + 1; k < 4; ++k)
      {
        visit(SortedEdge(c[i], c[k]));
      }
    }
  }

  int CornerOf(int cell, int point) const
  {
    const auto& c = this->Mesh.Cells[cell];
    return static_cast<int>(std::find(c.begin(), c.end(), point) - c.begin());
  }

  bool MaySplitAt(const Edge& edge, const Point& p) const;
  void SplitAt(const Edge& edge, int point);

  Tetrahedralization& Mesh;
  double Width;
  std::vector<FaceConstraints<3>::Facets> Constraints; ///< per cell
  std::map<Edge, std::vector<int>> CellsAround;        ///< of the edges to be split
};

bool EdgeSplitter::Split(const Edge& edge, const Passage& passage)
{
  // Rounding turns flat tetrahedra over at about every other place.
  constexpr int places = 200;
  std::vector<Point>& points = this->Mesh.Surface.Points;
  const double room = 0.5 * this->Width / Length(points[edge[1]] - points[edge[0]]);
  for (int i = 0; i < places; ++i)
  {
    const double offset = (i % 2 == 0 ? 0.5 : -0.5) * i / places;
    const Point p = PointAt(points, edge, passage.Share + offset * room);
    if (this->MaySplitAt(edge, p))
    {
      points.push_back(p);
      this->Mesh.Surface.PointSources.push_back(-1);
      this->SplitAt(edge, static_cast<int>(points.size()) - 1);
      return true;
    }
  }
  return false;
}

/** Whether both parts of each tetrahedron around an edge are positively oriented. */
bool EdgeSplitter::MaySplitAt(const Edge& edge, const Point& p) const
{
  const std::vector<int>& ring = this->CellsAround.at(edge);
  return std::all_of(ring.begin(), ring.end(),
    [&](int cell)
    {
      return std::all_of(edge.begin(), edge.end(),
        [&](int end)
        {
          auto corners = CornersOfCell(this->Mesh, cell);
          corners[this->CornerOf(cell, end)] = p;
          return CGAL::orientation(ToInexact(corners[0]), ToInexact(corners[1]),
                   ToInexact(corners[2]), ToInexact(corners[3])) == CGAL::POSITIVE;
        });
    });
}

/** Each cell around an edge becomes the part at its lower end; the other parts are appended. */
void EdgeSplitter::SplitAt(const Edge& edge, int point)
{
  const auto [a, b] = edge;
  const std::vector<int> ring = this->CellsAround.at(edge);
  const int first = static_cast<int>(this->Mesh.Cells.size());
  const auto otherPart = [&](int cell)
  {
    const auto place = std::find(ring.begin(), ring.end(), cell);
    return place == ring.end() ? cell : first + static_cast<int>(place - ring.begin());
  };
  for (const int lower : ring)
  {
    const int upper = static_cast<int>(this->Mesh.Cells.size());
    const int atA = this->CornerOf(lower, a), atB = this->CornerOf(lower, b);
    this->ForEachEdge(lower,
      [&](const Edge& other)
      {
        const auto around = this->CellsAround.find(other);
        const bool isOfA = other[0] == a || other[1] == a;
        if (around == this->CellsAround.end() || isOfA)
        {
          return;
        }
        std::vector<int>& cells = around->second;
        if (other[0] == b || other[1] == b)
        {
          std::replace(cells.begin(), cells.end(), lower, upper);
        }
        else
        {
          cells.push_back(upper);
        }
      });
    this->Mesh.Cells.push_back(this->Mesh.Cells[lower]);
    this->Mesh.Neighbors.push_back(this->Mesh.Neighbors[lower]);
    this->Constraints.push_back(this->Constraints[lower]);
    this->Mesh.Cells[lower][atB] = point;
    this->Mesh.Cells[upper][atA] = point;
    // The face at a's corner is beyond the upper part, and the other way round.
    const int beyond = this->Mesh.Neighbors[lower][atA];
    if (beyond >= 0)
    {
      auto& back = this->Mesh.Neighbors[beyond];
      std::replace(back.begin(), back.end(), lower, upper);
    }
    this->Mesh.Neighbors[lower][atA] = upper;
    this->Constraints[lower][atA] = -1;
    this->Mesh.Neighbors[upper][atB] = lower;
    this->Constraints[upper][atB] = -1;
    for (int f = 0; f < 4; ++f)
    {
      int& neighbor = this->Mesh.Neighbors[upper][f];
      if (f != atA && f != atB && neighbor >= 0)
      {
        neighbor = otherPart(neighbor);
      }
    }
  }
  this->CellsAround.erase(edge);
}

/** The edges that pass through cracks and are no edges of M. */
Passages FindPassages(
  const Tetrahedralization& mesh, const Edges& edgesOfM, const Edges& cracks, double width)
{
  const std::vector<Point>& points = mesh.Surface.Points;
  const Point margin = { width, width, width };
  Box around;
  for (const Edge& crack : cracks)
  {
    for (const int end : crack)
    {
      around.Add(points[end] - margin);
      around.Add(points[end] + margin);
    }
  }
  Edges candidates;
  for (const auto& c : mesh.Cells)
  {
    for (int i = 0; i < 3; ++i)
    {
      for (int k = i + 1; k < 4; ++k)
      {
        const Edge edge = SortedEdge(c[i], c[k]);
        if (around.Overlaps(BoxAround(std::array{ points[edge[0]], points[edge[1]] })) &&
          !std::binary_search(edgesOfM.begin(), edgesOfM.end(), edge))
        {
          candidates.push_back(edge);
        }
      }
    }
  }
  SortUnique(candidates);
  Passages passages;
  VisitPairs(WidenedBoxes(points, candidates, 0.0), WidenedBoxes(points, cracks, width),
    [&](int i, int k)
    {
      const Edge& edge = candidates[i];
      if (const std::optional<Passage> passage = FindPassage(points, edge, cracks[k], width))
      {
        Passage& best = passages.try_emplace(edge, *passage).first->second;
        best = std::min(best, *passage,
          [](const Passage& a, const Passage& b) { return a.Distance < b.Distance; });
      }
    });
  return passages;
}

} // namespace

int SplitEdgesThroughCracks(const Tetrahedralization& mesh, double width, Tetrahedralization& split)
{
  constexpr int rounds = 4; // an edge may pass through several cracks
  const Edges edges = FindEdges(mesh.Surface);
  const Edges cracks = FindCracks(mesh.Surface.Points, FindRims(edges), width);
  if (cracks.empty())
  {
    return 0;
  }
  int added = 0;
  Passages passages = FindPassages(mesh, edges, cracks, width);
  for (int round = 0; round < rounds && !passages.empty(); ++round)
  {
    if (round == 0)
    {
      split = mesh;
    }
    EdgeSplitter splitter(split, passages, width);
    for (const auto& [edge, passage] : passages)
    {
      added += splitter.Split(edge, passage);
    }
    splitter.Finish();
    passages = FindPassages(split, edges, cracks, width);
  }
  return added;
}

} // namespace carving::helper
