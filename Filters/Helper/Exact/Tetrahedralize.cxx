// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Exact/Tetrahedralize.h"

#include "Core/Mesh/Buckets.h"
#include "Core/Protocol/Protocol.h"
#include "Helper/Base/Effort.h"
#include "Helper/Base/Kernels.h"
#include "Helper/Exact/FindConstraints.h"
#include "Helper/Exact/Hull.h"
#include "Helper/Exact/SplitFacets.h"

#include <tetgen.h>

#include <algorithm>
#include <new>

namespace carving::helper
{
namespace
{

/** Whether all points lie in the plane of the mesh's first triangle. */
bool AreInPlane(const std::vector<Point>& points, const ResolvedMesh& surface)
{
  const Triangle& t = surface.Facets.front();
  return std::all_of(points.begin(), points.end(),
    [&](const Point& p)
    {
      return CGAL::coplanar(ToInexact(surface.Points[t[0]]), ToInexact(surface.Points[t[1]]),
        ToInexact(surface.Points[t[2]]), ToInexact(p));
    });
}

/**
 * TetGen's input. The polygons and their corners lie in two arrays: allocating and releasing each
 * of them, as TetGen does, takes a fiftieth of TetGen's time.
 */
class TetGenInput
{
public:
  /** `classes` has the class of each facet, or is empty if every facet has to stay whole. */
  TetGenInput(
    const std::vector<Point>& points, const ResolvedMesh& surface, const std::vector<int>& classes);
  ~TetGenInput();
  TetGenInput(const TetGenInput&) = delete;
  TetGenInput& operator=(const TetGenInput&) = delete;

  tetgenio* Get()
  {
    return &this->Io;
  }

private:
  tetgenio Io;
  std::vector<Triangle> Corners;
  std::vector<tetgenio::polygon> Polygons;
};

TetGenInput::TetGenInput(
  const std::vector<Point>& points, const ResolvedMesh& surface, const std::vector<int>& classes)
  : Corners(surface.Facets)
  , Polygons(surface.Facets.size())
{
  this->Io.numberofpoints = static_cast<int>(points.size());
  this->Io.pointlist = new REAL[3 * points.size()];
  std::copy_n(points.front().data(), 3 * points.size(), this->Io.pointlist);
  this->Io.numberoffacets = static_cast<int>(surface.Facets.size());
  this->Io.facetlist = new tetgenio::facet[surface.Facets.size()];
  this->Io.facetmarkerlist = new int[surface.Facets.size()];
  for (int i = 0; i < this->Io.numberoffacets; ++i)
  {
    this->Polygons[i].numberofvertices = 3;
    this->Polygons[i].vertexlist = this->Corners[i].data();
    tetgenio::facet& facet = this->Io.facetlist[i];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = &this->Polygons[i];
    // TetGen merges coplanar facets of the same marker. 0 marks faces of the hull.
    this->Io.facetmarkerlist[i] = 1 + (classes.empty() ? i : classes[i]);
  }
}

TetGenInput::~TetGenInput()
{
  for (int i = 0; i < this->Io.numberoffacets; ++i)
  {
    tetgenio::init(&this->Io.facetlist[i]); // TetGen would release the polygons
  }
}

/** The rank of each tetrahedron in the order of least corners. */
std::vector<int> RankByLeastCorner(const tetgenio& out)
{
  const Buckets<int> cells(out.numberofpoints,
    [&](const auto& visit)
    {
      for (int i = 0; i < out.numberoftetrahedra; ++i)
      {
        const int* corners = out.tetrahedronlist + 4 * i;
        visit(*std::min_element(corners, corners + 4), i);
      }
    });
  std::vector<int> ranks(out.numberoftetrahedra);
  int rank = 0;
  for (const int cell : cells.GetItems())
  {
    ranks[cell] = rank++;
  }
  return ranks;
}

/**
 * Copies the tetrahedra in the order of their least corners. TetGen's flips leave neighbors far
 * apart in memory; in this order, walks from neighbor to neighbor take 10 to 25 % less time.
 */
void CopyCells(const tetgenio& out, Tetrahedralization& result)
{
  const std::vector<int> ranks = RankByLeastCorner(out);
  result.Cells.resize(ranks.size());
  result.Neighbors.resize(ranks.size());
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      const int neighbor = out.neighborlist[4 * i + k];
      result.Cells[ranks[i]][k] = out.tetrahedronlist[4 * i + k];
      result.Neighbors[ranks[i]][k] = neighbor < 0 ? Outside : ranks[neighbor];
    }
  }
}

/** The number of cells that are flat or inside out. Exact. If it is 0, no cells overlap. */
std::ptrdiff_t CountInvertedCells(const Tetrahedralization& result)
{
  const std::vector<Point>& points = result.Surface.Points;
  return std::count_if(result.Cells.begin(), result.Cells.end(),
    [&](const Tetrahedralization::Cell& cell)
    {
      return CGAL::orientation(ToInexact(points[cell[0]]), ToInexact(points[cell[1]]),
               ToInexact(points[cell[2]]), ToInexact(points[cell[3]])) != CGAL::POSITIVE;
    });
}

/** Returns how TetGen ended. */
Ending CallTetGen(const std::vector<Point>& points, const ResolvedMesh& surface,
  const std::vector<int>& classes, tetgenio& out)
{
  TetGenInput in(points, surface, classes);
  // p: constrained by the facets; c: keep the hull; Y: no Steiner points on the surface; O0/0: no
  // optimization, which takes ten times as long as the rest; T: the default tolerance merges close
  // vertices; n: output neighbors; J: keep the numbering of points; Q: quiet.
  char whole[] = "pcYO0/0T1e-14nJQ", split[] = "pcO0/0T1e-14nJQ";
  try
  {
    tetrahedralize(classes.empty() ? whole : split, in.Get(), &out);
  }
  catch (int code)
  {
    constexpr int outOfMemory = 1;
    if (code == outOfMemory)
    {
      throw std::bad_alloc();
    }
    return { "TetGen gave up with code " + std::to_string(code) };
  }
  if (out.numberoftetrahedra > MaximumCells)
  {
    return { "TetGen made more than " + std::to_string(MaximumCells) + " tetrahedra", true };
  }
  const std::size_t given = surface.Points.size();
  if (static_cast<std::size_t>(out.numberofpoints) > given + MaximumPointsAdded(given))
  {
    return { "TetGen needed " + std::to_string(out.numberofpoints) + " points for " +
        std::to_string(given),
      true };
  }
  return {};
}

void AppendNewPoints(const tetgenio& out, ResolvedMesh& surface)
{
  for (int i = static_cast<int>(surface.Points.size()); i < out.numberofpoints; ++i)
  {
    const REAL* p = out.pointlist + 3 * i;
    surface.Points.push_back({ p[0], p[1], p[2] });
    surface.PointSources.push_back(-1);
  }
}

/** The faces that cover the facets of each class. */
std::vector<FacetPart> GetParts(const tetgenio& out)
{
  std::vector<FacetPart> parts;
  for (int i = 0; i < out.numberoftrifaces; ++i)
  {
    const int* c = out.trifacelist + 3 * i;
    if (out.trifacemarkerlist[i] > 0)
    {
      parts.push_back({ { c[0], c[1], c[2] }, out.trifacemarkerlist[i] - 1 });
    }
  }
  return parts;
}

} // namespace

std::string CheckVolume(const ResolvedMesh& surface, const std::vector<Point>& further)
{
  if (surface.Facets.empty())
  {
    return NothingToCarve;
  }
  const bool flat = AreInPlane(surface.Points, surface) && AreInPlane(further, surface);
  return flat
    ? "All points lie in one plane, so that their convex hull has no volume to carve. Carve them "
      "as contours, with vtkContourCarver, or start from a bounding box."
    : "";
}

Ending Tetrahedralize(
  const std::vector<Point>& further, SurfacePoints surfacePoints, Tetrahedralization& result)
{
  ResolvedMesh& surface = result.Surface;
  std::vector<Point> points = surface.Points;
  points.insert(points.end(), further.begin(), further.end());
  tetgenio out;
  const std::vector<int> classes =
    surfacePoints == SurfacePoints::Allowed ? FindFacetClasses(surface) : std::vector<int>();
  const Ending ending = CallTetGen(points, surface, classes, out);
  if (!ending.Mistake.empty())
  {
    return ending;
  }
  AppendNewPoints(out, surface);
  if (surfacePoints == SurfacePoints::Allowed)
  {
    const std::string error = ReplaceByParts(GetParts(out), classes, surface);
    if (!error.empty())
    {
      return { "TetGen lost a triangle of the mesh: " + error };
    }
  }
  CopyCells(out, result);
  if (const std::ptrdiff_t inverted = CountInvertedCells(result))
  {
    return { "TetGen made " + std::to_string(inverted) +
      " tetrahedra that are flat or inside out" };
  }
  if (!FillsHull(result))
  {
    return { "TetGen left gaps between the tetrahedra" };
  }
  if (const std::size_t missing = FindConstraints(result))
  {
    return { "TetGen lost " + std::to_string(missing) + " of " +
      std::to_string(surface.Facets.size()) + " triangles of the mesh" };
  }
  return {};
}

} // namespace carving::helper
