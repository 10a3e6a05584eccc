// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/Cracks.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/FacetTree.h"
#include "Core/Solid/Winding.h"

#include <algorithm>
#include <utility>

namespace carving
{
namespace
{

/** Face f of a cell. */
struct CellFace
{
  int Cell, Face;
};

double AreaOf(const FacetCorners<3>& face)
{
  return Length(Cross(face[1] - face[0], face[2] - face[0])) / 2.0;
}

/** Whether the least height of a face is at most the width of a crack. */
bool IsThin(const FacetCorners<3>& face, double width)
{
  const Point sides[] = { face[1] - face[0], face[2] - face[1], face[0] - face[2] };
  const Point normal = Cross(sides[0], sides[1]); // twice the area long
  const double longest =
    std::max({ Dot(sides[0], sides[0]), Dot(sides[1], sides[1]), Dot(sides[2], sides[2]) });
  return Dot(normal, normal) <= width * width * longest;
}

/**
 * The faces that are no wider than a crack and lie on no facet, in regions that are connected to
 * the outside, each once.
 */
std::vector<CellFace> FindThinFaces(
  const Tetrahedralization& mesh, const Classification& regions, double width)
{
  std::vector<CellFace> faces;
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; regions.Kind(cell) == RegionKind::Outside && f < 4; ++f)
    {
      const int neighbor = mesh.Neighbors[cell][f];
      const bool isOfOther = neighbor >= 0 && (neighbor < cell || mesh.IsKept(neighbor));
      if (isOfOther || mesh.Constraints.Has(cell, f))
      {
        continue;
      }
      if (IsThin(CornersOf<3>(mesh.Surface.Points, mesh.OutwardFace(cell, f)), width))
      {
        faces.push_back({ cell, f });
      }
    }
  }
  return faces;
}

/** Whether no height of a cell is less than the width of a crack. */
bool IsThick(const Tetrahedralization& mesh, int cell, double width)
{
  double largest = 0.0;
  for (int f = 0; f < 4; ++f)
  {
    largest =
      std::max(largest, AreaOf(CornersOf<3>(mesh.Surface.Points, mesh.OutwardFace(cell, f))));
  }
  return 3.0 * Size(CornersOfCell(mesh, cell)) > width * largest;
}

/** The same face, of the cell on the other side; of the exterior if there is none. */
CellFace OtherSide(const Tetrahedralization& mesh, const CellFace& face)
{
  const int other = mesh.Neighbors[face.Cell][face.Face];
  if (other < 0)
  {
    return { other, 0 };
  }
  const auto& back = mesh.Neighbors[other];
  return { other, static_cast<int>(std::find(back.begin(), back.end(), face.Cell) - back.begin()) };
}

/** A face of a cell, numbered, and the facet on which the face lies. */
using FaceOnFacet = std::pair<int, int>;

/** Adds facets to M, each with the cell of a face behind it, without a multiplicity or source. */
void AddFacets(Tetrahedralization& mesh, const std::vector<CellFace>& faces)
{
  std::vector<FaceOnFacet> added;
  for (const CellFace& face : faces)
  {
    const int facet = static_cast<int>(mesh.Surface.Facets.size());
    mesh.Surface.Facets.push_back(mesh.OutwardFace(face.Cell, face.Face));
    mesh.Surface.FacetSources.push_back(-1);
    mesh.Surface.SignedMultiplicities.push_back(0);
    mesh.Surface.Multiplicities.push_back(0);
    for (const auto& [cell, f] : { face, OtherSide(mesh, face) })
    {
      if (cell >= 0)
      {
        added.emplace_back(4 * cell + f, facet);
      }
    }
  }
  std::sort(added.begin(), added.end());
  FaceConstraints<3> constraints;
  auto next = added.begin();
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    auto facets = mesh.Constraints.Get(cell);
    for (; next != added.end() && next->first / 4 == cell; ++next)
    {
      facets[next->first % 4] = next->second;
    }
    constraints.Append(facets);
  }
  mesh.Constraints = std::move(constraints);
}

/** Per region: whether not all its cells are thinner than a crack. */
std::vector<char> FindThickRegions(
  const Tetrahedralization& mesh, const Classification& regions, double width)
{
  std::vector<char> thick(regions.Regions.size(), 0);
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    char& isThick = thick[regions.RegionOfCell[cell]];
    isThick = isThick || IsThick(mesh, cell, width);
  }
  return thick;
}

/**
 * Leaves those regions marked as Void for which the rule is asked: thick parts of regions that are
 * connected to the outside as long as nothing divides them. Returns whether there are any.
 */
bool MarkAsked(
  const Classification& undivided, const std::vector<char>& thick, Classification& regions)
{
  std::vector<char> isAsked(regions.Regions.size(), 0);
  for (int cell = 0; cell < static_cast<int>(regions.RegionOfCell.size()); ++cell)
  {
    const int region = regions.RegionOfCell[cell];
    isAsked[region] = thick[region] && regions.Kind(cell) == RegionKind::Void &&
      undivided.Kind(cell) == RegionKind::Outside;
  }
  for (std::size_t region = 0; region < isAsked.size(); ++region)
  {
    RegionKind& kind = regions.Regions[region].Kind;
    kind = kind == RegionKind::Void && !isAsked[region] ? RegionKind::Kept : kind;
  }
  return std::find(isAsked.begin(), isAsked.end(), 1) != isAsked.end();
}

/** The regions of a mesh that thin faces divide, and those among them that are solid. */
class DividedRegions
{
public:
  DividedRegions(
    const Tetrahedralization& mesh, const Classification& regions, const std::vector<char>& thick)
    : Mesh(mesh)
    , Regions(regions)
    , Thick(thick)
    , Sets(thick.size() + 1)
    , Open(thick.size() + 1, 0)
  {
  }

  /** Unites the regions on both sides of faces, unless one is thick and solid. */
  void Unite(const std::vector<CellFace>& faces)
  {
    for (const auto& [cell, f] : faces)
    {
      const int a = this->RegionOf(cell), b = this->RegionOf(this->Mesh.Neighbors[cell][f]);
      if (!this->IsThickSolid(a) && !this->IsThickSolid(b))
      {
        this->Sets.Unite(a, b);
      }
    }
    this->Open[this->Sets.Find(this->RegionOf(Outside))] = 1;
    for (std::size_t r = 0; r < this->Thick.size(); ++r)
    {
      const int region = static_cast<int>(r);
      if (!this->IsThickSolid(region) &&
        (this->Thick[r] || this->Regions.Regions[r].Kind == RegionKind::Outside))
      {
        this->Open[this->Sets.Find(region)] = 1;
      }
    }
  }

  /** Whether a cell is in the solid, or in a pocket that only the solid touches. */
  bool IsSolid(int cell)
  {
    const int region = this->RegionOf(cell);
    return this->IsThickSolid(region) || !this->Open[this->Sets.Find(region)];
  }

private:
  /** The last region is the exterior. */
  int RegionOf(int cell) const
  {
    return cell < 0 ? static_cast<int>(this->Thick.size()) : this->Regions.RegionOfCell[cell];
  }

  bool IsThickSolid(int region) const
  {
    return region < static_cast<int>(this->Thick.size()) && this->Thick[region] &&
      this->Regions.Regions[region].Kind == RegionKind::Solid;
  }

  const Tetrahedralization& Mesh;
  const Classification& Regions;
  const std::vector<char>& Thick;
  DisjointSets Sets;
  std::vector<char> Open; ///< per first region of a set: whether not only the solid touches it
};

/** Removes the facets from `count` on. */
void Truncate(std::size_t count, ResolvedMesh& surface)
{
  const auto resize = [count](auto&... arrays) { (arrays.resize(count), ...); };
  resize(
    surface.Facets, surface.FacetSources, surface.SignedMultiplicities, surface.Multiplicities);
}

/** Gives the facets from `first` on the sources of facets that they touch. */
void CopySources(std::size_t first, ResolvedMesh& surface)
{
  std::vector<int> facetAt(surface.Points.size(), 0);
  for (std::size_t facet = 0; facet < first; ++facet)
  {
    for (const int point : surface.Facets[facet])
    {
      facetAt[point] = static_cast<int>(facet);
    }
  }
  for (std::size_t facet = first; facet < surface.Facets.size(); ++facet)
  {
    const auto& [a, b, c] = surface.Facets[facet];
    surface.FacetSources[facet] =
      surface.FacetSources[std::max({ facetAt[a], facetAt[b], facetAt[c] })];
  }
}

} // namespace

int SealCracks(Tetrahedralization& mesh, SolidRule rule, int threads)
{
  if (rule == SolidRule::SurfaceOnly || IsClosed(mesh.GetInput()))
  {
    return 0;
  }
  const Classification undivided = FindRegions(mesh);
  const double width = MostCrackWidth * Diagonal(mesh.GetInput().Points);
  const std::vector<CellFace> thin = FindThinFaces(mesh, undivided, width);
  if (thin.empty())
  {
    return 0;
  }
  const std::size_t own = mesh.Surface.Facets.size();
  FaceConstraints<3> constraints = mesh.Constraints;
  AddFacets(mesh, thin);
  Classification regions = FindRegions(mesh);
  const std::vector<char> thick = FindThickRegions(mesh, regions, width);
  if (MarkAsked(undivided, thick, regions))
  {
    ClassifyRegions(mesh, rule, threads, regions);
  }
  mesh.Constraints = std::move(constraints);
  Truncate(own, mesh.Surface);
  DividedRegions divided(mesh, regions, thick);
  divided.Unite(thin);
  std::vector<CellFace> seals; // with the solid behind them
  for (const CellFace& face : thin)
  {
    const CellFace other = OtherSide(mesh, face);
    const bool isSolid = divided.IsSolid(face.Cell);
    if (isSolid != divided.IsSolid(other.Cell))
    {
      seals.push_back(isSolid ? face : other);
    }
  }
  if (!seals.empty())
  {
    AddFacets(mesh, seals);
    CopySources(own, mesh.Surface);
    for (std::size_t i = 0; i < seals.size(); ++i)
    {
      const Region& region = regions.Regions[regions.RegionOfCell[seals[i].Cell]];
      mesh.Surface.Multiplicities[own + i] = 1;
      mesh.Surface.SignedMultiplicities[own + i] = region.Winding < 0.0 ? -1 : 1; // inside out
    }
  }
  return static_cast<int>(seals.size());
}

} // namespace carving
