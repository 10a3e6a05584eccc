// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/DelaunayFaces.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Resolve/FacetNeighbors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace carving::helper
{
namespace
{

using Edge = std::array<int, 2>; ///< in the direction of a triangle
using Delaunay = PiercedMesh::Delaunay;

/** A flat part of M. */
struct FlatPart
{
  std::vector<int> Facets;
  Point Normal = {}; ///< the sum of their normals
};

/** Twice the area long. */
Point NormalOf(const FacetCorners<3>& t)
{
  return Cross(t[1] - t[0], t[2] - t[0]);
}

/** The distance of a point from the plane of a triangle, which has an area. */
double DistanceFromPlane(const FacetCorners<3>& t, const Point& p)
{
  const Point normal = NormalOf(t);
  return std::abs(Dot(normal, p - t[0])) / Length(normal);
}

/** The parts of more than one triangle. */
std::vector<FlatPart> FindFlatParts(const ResolvedMesh& mesh, double tolerance)
{
  const int count = static_cast<int>(mesh.Facets.size());
  const auto cornersOf = [&](int facet)
  { return carving::CornersOf<3>(mesh.Points, mesh.Facets[facet]); };
  const auto normalOf = [&](int facet) { return NormalOf(cornersOf(facet)); };
  const std::vector<FacetNeighbors> neighbors = FindFacetNeighbors(mesh);
  DisjointSets sets(mesh.Facets.size());
  for (int facet = 0; facet < count; ++facet)
  {
    for (const FacetNeighbor& neighbor : neighbors[facet])
    {
      const int other = neighbor.Facet;
      if (other < facet || neighbor.Flipped ||
        mesh.SignedMultiplicities[other] != mesh.SignedMultiplicities[facet] ||
        mesh.Multiplicities[other] != mesh.Multiplicities[facet] ||
        Dot(normalOf(facet), normalOf(other)) <= 0.0)
      {
        continue;
      }
      double height = 0.0;
      for (const int p : mesh.Facets[other])
      {
        height = std::max(height, DistanceFromPlane(cornersOf(facet), mesh.Points[p]));
      }
      if (height <= tolerance)
      {
        sets.Unite(facet, other);
      }
    }
  }
  std::map<int, FlatPart> bySet;
  for (int facet = 0; facet < count; ++facet)
  {
    FlatPart& part = bySet[sets.Find(facet)];
    part.Facets.push_back(facet);
    part.Normal = part.Normal + normalOf(facet);
  }
  std::vector<FlatPart> parts;
  for (auto& [set, part] : bySet)
  {
    if (part.Facets.size() > 1)
    {
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

/** The faces of a Delaunay tetrahedralization at the points of flat parts. */
class PartFaces
{
public:
  PartFaces(const ResolvedMesh& mesh, const std::vector<FlatPart>& parts, const Delaunay& cells)
    : Mesh(mesh)
    , PartsAt(mesh.Points.size())
    , Parts(parts)
    , Faces(parts.size())
  {
    for (int part = 0; part < static_cast<int>(parts.size()); ++part)
    {
      for (const int facet : parts[part].Facets)
      {
        for (const int p : mesh.Facets[facet])
        {
          if (this->PartsAt[p].empty() || this->PartsAt[p].back() != part)
          {
            this->PartsAt[p].push_back(part);
          }
        }
      }
    }
    for (auto facet = cells.finite_facets_begin(); facet != cells.finite_facets_end(); ++facet)
    {
      this->Add(cells, *facet);
    }
  }

  /** Those on the outermost layer of a part, oriented alike. */
  const std::vector<Triangle>& Get(int part) const
  {
    return this->Faces[part];
  }

private:
  bool IsOf(int point, int part) const
  {
    return point < static_cast<int>(this->PartsAt.size()) &&
      std::binary_search(this->PartsAt[point].begin(), this->PartsAt[point].end(), part);
  }

  void Add(const Delaunay& cells, const Delaunay::Facet& facet)
  {
    Triangle t;
    for (int i = 0; i < 3; ++i)
    {
      t[i] = facet.first->vertex(Delaunay::vertex_triple_index(facet.second, i))->info().Index;
    }
    if (*std::max_element(t.begin(), t.end()) >= static_cast<int>(this->PartsAt.size()))
    {
      return;
    }
    for (const int part : this->PartsAt[t[0]])
    {
      if (!this->IsOf(t[1], part) || !this->IsOf(t[2], part))
      {
        continue;
      }
      // vertex_triple_index orders the corners so that the normal points away from the cell.
      const double along =
        Dot(NormalOf(carving::CornersOf<3>(this->Mesh.Points, t)), this->Parts[part].Normal);
      const Delaunay::Facet mirror = cells.mirror_facet(facet);
      const auto& [cell, i] = along > 0.0 ? mirror : facet;
      const auto beyond = cell->vertex(i);
      if (along == 0.0 || (!cells.is_infinite(beyond) && this->IsOf(beyond->info().Index, part)))
      {
        continue; // of no area, or below a flat tetrahedron
      }
      this->Faces[part].push_back(along > 0.0 ? t : carving::Flipped<3>(t));
    }
  }

  const ResolvedMesh& Mesh;
  std::vector<std::vector<int>> PartsAt; ///< per point, ascending
  const std::vector<FlatPart>& Parts;
  std::vector<std::vector<Triangle>> Faces;
};

/** The edges of triangles that no other has in the opposite direction. */
std::set<Edge> FindBorder(const std::vector<Triangle>& triangles)
{
  std::set<Edge> border;
  for (const Triangle& t : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Edge edge = { t[i], t[(i + 1) % 3] };
      if (border.erase({ edge[1], edge[0] }) == 0)
      {
        border.insert(edge);
      }
    }
  }
  return border;
}

/** The faces within a border: those beside the border, and those that they are connected to. */
std::vector<Triangle> FillBorder(const std::vector<Triangle>& faces, const std::set<Edge>& border)
{
  std::map<Edge, int> faceAt;
  for (int face = 0; face < static_cast<int>(faces.size()); ++face)
  {
    for (int i = 0; i < 3; ++i)
    {
      faceAt[{ faces[face][i], faces[face][(i + 1) % 3] }] = face;
    }
  }
  std::vector<char> isInside(faces.size(), 0);
  std::vector<int> open;
  const auto add = [&](const Edge& edge)
  {
    const auto face = faceAt.find(edge);
    if (face != faceAt.end() && !isInside[face->second])
    {
      isInside[face->second] = 1;
      open.push_back(face->second);
    }
  };
  std::for_each(border.begin(), border.end(), add);
  std::vector<Triangle> filling;
  while (!open.empty())
  {
    const Triangle face = faces[open.back()];
    open.pop_back();
    filling.push_back(face);
    for (int i = 0; i < 3; ++i)
    {
      if (border.count({ face[i], face[(i + 1) % 3] }) == 0)
      {
        add({ face[(i + 1) % 3], face[i] });
      }
    }
  }
  return filling;
}

std::vector<Triangle> TrianglesOf(const ResolvedMesh& mesh, const FlatPart& part)
{
  std::vector<Triangle> triangles;
  for (const int facet : part.Facets)
  {
    triangles.push_back(mesh.Facets[facet]);
  }
  return triangles;
}

std::set<Triangle> AsSets(const std::vector<Triangle>& triangles)
{
  std::set<Triangle> sets;
  for (Triangle t : triangles)
  {
    std::sort(t.begin(), t.end());
    sets.insert(t);
  }
  return sets;
}

/** For each new triangle of a part, the closest old one that shares a corner with it. */
std::vector<int> FindSources(
  const ResolvedMesh& mesh, const FlatPart& part, const std::vector<Triangle>& triangles)
{
  std::map<int, std::vector<int>> facetsAt;
  for (const int facet : part.Facets)
  {
    for (const int p : mesh.Facets[facet])
    {
      facetsAt[p].push_back(facet);
    }
  }
  std::vector<int> sources;
  for (const Triangle& t : triangles)
  {
    const FacetCorners<3> corners = carving::CornersOf<3>(mesh.Points, t);
    const Point center = 1.0 / 3.0 * (corners[0] + corners[1] + corners[2]);
    double least = HUGE_VAL;
    int source = part.Facets.front();
    for (const int p : t)
    {
      for (const int facet : facetsAt[p])
      {
        const double distance =
          DistanceTo(carving::CornersOf<3>(mesh.Points, mesh.Facets[facet]), center);
        if (distance < least)
        {
          least = distance;
          source = facet;
        }
      }
    }
    sources.push_back(source);
  }
  return sources;
}

/** An upper bound of the distance of triangles from their sources. */
double FarthestFromSources(
  const ResolvedMesh& mesh, const std::vector<Triangle>& triangles, const std::vector<int>& sources)
{
  double farthest = 0.0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const FacetCorners<3> source = carving::CornersOf<3>(mesh.Points, mesh.Facets[sources[i]]);
    for (const int p : triangles[i])
    {
      farthest = std::max(farthest, DistanceFromPlane(source, mesh.Points[p]));
    }
  }
  return farthest;
}

} // namespace

RetriangulatedMesh AdoptFacesOf(const Delaunay& delaunay, const ResolvedMesh& mesh,
  double tolerance, const std::vector<char>& isMissing)
{
  constexpr double least = 1e-16; // of the diagonal: other triangles differ by a rounding at least
  RetriangulatedMesh result;
  result.Distance = least * Diagonal(mesh.Points);
  std::vector<FlatPart> parts = FindFlatParts(mesh, tolerance);
  const auto isWhole = [&isMissing](const FlatPart& part)
  {
    return std::none_of(
      part.Facets.begin(), part.Facets.end(), [&](int facet) { return isMissing[facet] != 0; });
  };
  parts.erase(std::remove_if(parts.begin(), parts.end(), isWhole), parts.end());
  if (parts.empty())
  {
    return result;
  }
  const PartFaces faces(mesh, parts, delaunay);
  result.Mesh = mesh;
  for (int i = 0; i < static_cast<int>(parts.size()); ++i)
  {
    const std::vector<int>& facets = parts[i].Facets;
    const std::vector<Triangle> old = TrianglesOf(mesh, parts[i]);
    const std::set<Edge> border = FindBorder(old);
    const std::vector<Triangle> filling = FillBorder(faces.Get(i), border);
    // With fewer triangles, vertices would be lost: all of them where a part has no border.
    if (filling.size() != old.size() || FindBorder(filling) != border ||
      AsSets(filling) == AsSets(old))
    {
      continue;
    }
    const std::vector<int> sources = FindSources(mesh, parts[i], filling);
    const double distance = FarthestFromSources(mesh, filling, sources);
    if (distance > tolerance)
    {
      continue;
    }
    ++result.Changed;
    result.Distance = std::max(result.Distance, distance);
    for (std::size_t k = 0; k < filling.size(); ++k)
    {
      result.Mesh.Facets[facets[k]] = filling[k];
      result.Mesh.FacetSources[facets[k]] = mesh.FacetSources[sources[k]];
    }
  }
  return result;
}

RetriangulatedMesh AdoptDelaunayFaces(
  const ResolvedMesh& mesh, const std::vector<Point>& further, double tolerance)
{
  return AdoptFacesOf(PiercedMesh::Tetrahedralize(mesh.Points, further), mesh, tolerance,
    std::vector<char>(mesh.Facets.size(), 1));
}

} // namespace carving::helper
