// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/Cracks.h"

#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/FacetTree.h"
#include "Core/Solid/ThinFaces.h"
#include "Core/Solid/Winding.h"

#include <algorithm>
#include <array>
#include <utility>

namespace carving
{
namespace
{

/** A face that closes the solid. */
struct Seal
{
  CellFace OfSolid;       ///< of the cell of the solid
  int SignedMultiplicity; ///< -1 if the solid is inside out there
};

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

/**
 * Leaves the mark Void only on regions that the rule decides: thick ones that thin faces enclose,
 * but M does not. The other enclosed regions are marked Kept. Returns whether the rule decides any.
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

/**
 * The regions of a mesh that thin faces divide, and those among them that are solid. Regions on
 * both sides of a thin face are one set, unless one of them is thick and solid.
 */
class DividedRegions
{
public:
  DividedRegions(const Tetrahedralization& mesh, const Classification& regions,
    const std::vector<char>& thick, const std::vector<CellFace>& thinFaces)
    : Regions(regions)
    , Thick(thick)
    , Sets(thick.size() + 1)
    , Open(thick.size() + 1, 0)
  {
    for (const auto& [cell, f] : thinFaces)
    {
      const int a = this->RegionOf(cell), b = this->RegionOf(mesh.Neighbors[cell][f]);
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

  const Classification& Regions;
  const std::vector<char>& Thick;
  DisjointSets Sets;
  std::vector<char> Open; ///< per first region of a set: whether anything but the solid touches it
};

/** Removes the facets from `count` on. */
void Truncate(std::size_t count, ResolvedMesh& surface)
{
  const auto resize = [count](auto&... arrays) { (arrays.resize(count), ...); };
  resize(
    surface.Facets, surface.FacetSources, surface.SignedMultiplicities, surface.Multiplicities);
}

/** Gives the facets from `first` on the sources of facets that they touch, or else another one. */
void CopySources(std::size_t first, int otherSource, ResolvedMesh& surface)
{
  constexpr int none = -1;
  std::vector<int> facetAt(surface.Points.size(), none);
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
    const int touched = std::max({ facetAt[a], facetAt[b], facetAt[c] });
    surface.FacetSources[facet] = touched == none ? otherSource : surface.FacetSources[touched];
  }
}

/**
 * Per seal: whether its patch is wider than a crack on average. Across a hole whose rim has edges
 * shorter than a crack is wide, every face may be thin. A patch without a rim, around a pocket,
 * closes no hole.
 */
std::vector<char> FindWideSeals(
  const Tetrahedralization& mesh, const std::vector<Seal>& seals, double width)
{
  std::vector<std::array<int, 3>> edges; // the ends, the seal
  std::vector<double> areas(seals.size(), 0.0), rims(seals.size(), 0.0);
  for (int i = 0; i < static_cast<int>(seals.size()); ++i)
  {
    const auto& [cell, f] = seals[i].OfSolid;
    const Triangle face = mesh.OutwardFace(cell, f);
    areas[i] = Size(carving::CornersOf<3>(mesh.Surface.Points, face));
    for (int k = 0; k < 3; ++k)
    {
      const auto [lower, upper] = std::minmax(face[k], face[(k + 1) % 3]);
      edges.push_back({ lower, upper, i });
    }
  }
  std::sort(edges.begin(), edges.end());
  DisjointSets patches(seals.size());
  for (auto first = edges.begin(), last = first; first != edges.end(); first = last)
  {
    const auto [lower, upper, seal] = *first;
    last = std::find_if(first, edges.end(),
      [a = lower, b = upper](const std::array<int, 3>& edge)
      { return edge[0] != a || edge[1] != b; });
    if (last - first == 1)
    {
      rims[seal] += Length(mesh.Surface.Points[upper] - mesh.Surface.Points[lower]);
    }
    std::for_each(first, last,
      [&patches, seal = seal](const std::array<int, 3>& edge) { patches.Unite(seal, edge[2]); });
  }
  for (int i = static_cast<int>(seals.size()) - 1; i >= 0; --i) // a patch has its least number
  {
    const int patch = patches.Find(i);
    areas[patch] += patch != i ? areas[i] : 0.0;
    rims[patch] += patch != i ? rims[i] : 0.0;
  }
  constexpr double overlap = 4.0; // faces of a patch may lie on each other, and all count
  std::vector<char> wide(seals.size());
  for (int i = 0; i < static_cast<int>(seals.size()); ++i)
  {
    const int patch = patches.Find(i);
    wide[i] = rims[patch] > 0.0 && areas[patch] > overlap * width * rims[patch] / 2.0;
  }
  return wide;
}

/** The faces that separate the solid from other regions, with the solid behind. */
std::vector<Seal> CollectSeals(const Tetrahedralization& mesh, const Classification& regions,
  const std::vector<char>& thick, const std::vector<CellFace>& thin)
{
  DividedRegions divided(mesh, regions, thick, thin);
  std::vector<Seal> seals;
  for (const CellFace& face : thin)
  {
    const CellFace other = OtherSide(mesh, face);
    const bool isSolid = divided.IsSolid(face.Cell);
    if (isSolid != divided.IsSolid(other.Cell))
    {
      const CellFace& ofSolid = isSolid ? face : other;
      const double winding = regions.Regions[regions.RegionOfCell[ofSolid.Cell]].Winding;
      seals.push_back({ ofSolid, winding < 0.0 ? -1 : 1 });
    }
  }
  return seals;
}

/** The faces through which the solid would be connected to the outside. */
std::vector<Seal> FindSeals(Tetrahedralization& mesh, SolidRule rule, int threads)
{
  const Classification undivided = FindRegions(mesh);
  const double width = MostCrackWidth * Diagonal(mesh.GetInput());
  const std::vector<CellFace> thin = FindThinFaces(mesh, undivided, width);
  if (thin.empty())
  {
    return {};
  }
  const std::size_t own = mesh.Surface.Facets.size();
  FaceConstraints<3> constraints = mesh.Constraints;
  AddFacets(mesh, thin);
  Classification regions = FindRegions(mesh);
  std::vector<char> thick = FindThickRegions(mesh, regions, width);
  const bool isAsked = MarkAsked(undivided, thick, regions);
  if (isAsked)
  {
    ClassifyRegions(mesh, rule, threads, regions);
  }
  mesh.Constraints = std::move(constraints);
  Truncate(own, mesh.Surface);
  if (!isAsked)
  {
    return {};
  }
  for (;;) // fewer regions are solid each time
  {
    std::vector<Seal> seals = CollectSeals(mesh, regions, thick, thin);
    const std::vector<char> wide = FindWideSeals(mesh, seals, width);
    if (std::find(wide.begin(), wide.end(), 1) == wide.end())
    {
      return seals;
    }
    for (std::size_t i = 0; i < seals.size(); ++i)
    {
      if (wide[i])
      {
        const int region = regions.RegionOfCell[seals[i].OfSolid.Cell];
        regions.Regions[region].Kind = RegionKind::Void;
        thick[region] = 1; // no pocket of the solid, either
      }
    }
  }
}

} // namespace

int SealCracks(Tetrahedralization& mesh, SolidRule rule, int threads)
{
  if (rule == SolidRule::SurfaceOnly || IsClosed(mesh.GetInput()))
  {
    return 0;
  }
  const std::vector<Seal> seals = FindSeals(mesh, rule, threads);
  if (seals.empty())
  {
    return 0;
  }
  const std::size_t own = mesh.Surface.Facets.size();
  const int anySource = mesh.GetInput().FacetSources.front();
  std::vector<CellFace> faces;
  for (const Seal& seal : seals)
  {
    faces.push_back(seal.OfSolid);
  }
  AddFacets(mesh, faces);
  CopySources(own, anySource, mesh.Surface);
  for (std::size_t i = 0; i < seals.size(); ++i)
  {
    mesh.Surface.Multiplicities[own + i] = 1;
    mesh.Surface.SignedMultiplicities[own + i] = seals[i].SignedMultiplicity;
  }
  return static_cast<int>(seals.size());
}

} // namespace carving
