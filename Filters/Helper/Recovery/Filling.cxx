// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/Filling.h"

#include "Core/Mesh/Mesh.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

/** The same face with the smallest corner first. */
Triangle Rotated(const Triangle& t)
{
  Triangle rotated = t;
  std::rotate(rotated.begin(), std::min_element(rotated.begin(), rotated.end()), rotated.end());
  return rotated;
}

std::uint64_t KeyOf(Filling::Tetrahedron cell)
{
  std::sort(cell.begin(), cell.end());
  std::uint64_t key = 0;
  for (const int corner : cell)
  {
    key = key << 16 | static_cast<std::uint64_t>(corner);
  }
  return key;
}

/** Face f of a cell, from behind: the cell belongs there. */
Triangle InwardFace(const Filling::Tetrahedron& cell, int f)
{
  const auto& [a, b, c] = FaceCorners[f];
  return Rotated({ cell[a], cell[c], cell[b] });
}

bool HasCorners(const Filling::Tetrahedron& cell, const Triangle& face)
{
  return std::all_of(face.begin(), face.end(),
    [&](int corner) { return std::find(cell.begin(), cell.end(), corner) != cell.end(); });
}

bool Contains(const Corners4& k, const Inexact::Point_3& p)
{
  return std::all_of(std::begin(FaceCorners), std::end(FaceCorners),
    [&](const auto& f)
    { return CGAL::orientation(k[f[0]], k[f[1]], k[f[2]], p) != CGAL::POSITIVE; });
}

} // namespace

Filling::Filling(const Cavity& cavity)
  : Space(cavity)
{
  for (const Triangle& corners : cavity.Front)
  {
    this->AddFace(corners);
  }
}

int Filling::AddFace(const Triangle& corners)
{
  const auto& points = this->Space.Points;
  this->Faces.push_back(
    { Rotated(corners), Piercer({ points[corners[0]], points[corners[1]], points[corners[2]] }) });
  return static_cast<int>(this->Faces.size()) - 1;
}

Corners4 Filling::CornersOf(const Tetrahedron& cell) const
{
  const auto& points = this->Space.Points;
  return { points[cell[0]], points[cell[1]], points[cell[2]], points[cell[3]] };
}

bool Filling::Run(std::ptrdiff_t& steps)
{
  Front front;
  for (std::size_t i = 0; i < this->Space.Front.size(); ++i)
  {
    front.push_back({ static_cast<int>(i), {} });
    this->FindApexes(front.back(), {}, steps);
    if (front.back().Apexes.empty() || steps < 0)
    {
      return false;
    }
  }
  return this->Space.Edge[0] < 0 ? this->Place(front, steps) : this->PlaceAtEdge(front, steps);
}

std::vector<char> Filling::FindVisible(int point)
{
  std::ptrdiff_t steps = 0; // are few
  std::vector<char> visible;
  for (const Triangle& face : this->Space.Front)
  {
    visible.push_back(this->IsCandidate(face, point, steps));
  }
  return visible;
}

/** Whether a face neither pierces a cell nor covers a part of one of its faces. */
bool Filling::IsClear(const Tetrahedron& cell, const Face& face) const
{
  if (HasCorners(cell, face.Corners))
  {
    return true;
  }
  return !face.Shape.FindContact(this->CornersOf(cell)).Exists();
}

/** Whether a cell contains no other vertex, and no face of the given front is in its way. */
bool Filling::IsFree(const Tetrahedron& cell, std::ptrdiff_t& steps) const
{
  const Corners4 corners = this->CornersOf(cell);
  for (int p = 0; p < static_cast<int>(this->Space.Points.size()); ++p)
  {
    --steps;
    if (this->Space.Required[p] && std::find(cell.begin(), cell.end(), p) == cell.end() &&
      Contains(corners, this->Space.Points[p]))
    {
      return false;
    }
  }
  return std::all_of(this->Faces.begin(), this->Faces.begin() + this->Space.Front.size(),
    [&](const Face& face)
    {
      --steps;
      return this->IsClear(cell, face);
    });
}

bool Filling::IsCandidate(const Triangle& face, int apex, std::ptrdiff_t& steps)
{
  const Tetrahedron cell = { face[0], face[1], face[2], apex };
  if (std::find(face.begin(), face.end(), apex) != face.end())
  {
    return false;
  }
  const int infinite = this->Space.Infinite;
  if (infinite >= 0 && std::find(cell.begin(), cell.end(), infinite) != cell.end() &&
    !std::all_of(cell.begin(), cell.end(),
      [&](int corner) { return corner == infinite || this->Space.InPlane[corner]; }))
  {
    return false;
  }
  const Corners4 k = this->CornersOf(cell);
  --steps;
  if (CGAL::orientation(k[0], k[1], k[2], k[3]) != CGAL::POSITIVE)
  {
    return false;
  }
  const auto [known, isNew] = this->Known.try_emplace(KeyOf(cell), false);
  if (isNew)
  {
    known->second = this->IsFree(cell, steps);
  }
  return known->second;
}

/** Finds the candidates at a face that are clear of the faces that the search has added. */
void Filling::FindApexes(OpenFace& face, const Front& front, std::ptrdiff_t& steps)
{
  const Triangle corners = this->Faces[face.Index].Corners;
  for (int apex = 0; apex < static_cast<int>(this->Space.Points.size()); ++apex)
  {
    if (this->IsCandidate(corners, apex, steps) &&
      std::all_of(front.begin(), front.end(),
        [&](const OpenFace& other)
        {
          const bool added = other.Index >= static_cast<int>(this->Space.Front.size());
          steps -= added;
          return !added ||
            this->IsClear({ corners[0], corners[1], corners[2], apex }, this->Faces[other.Index]);
        }))
    {
      face.Apexes.push_back(apex);
    }
  }
  this->SortApexes(face);
}

/** An apex whose tetrahedron with the face has an empty sphere comes first. */
void Filling::SortApexes(OpenFace& face) const
{
  const auto& [a, b, c] = this->Faces[face.Index].Corners;
  const auto& points = this->Space.Points;
  std::stable_sort(face.Apexes.begin(), face.Apexes.end(),
    [&, a = a, b = b, c = c](int p, int q)
    {
      return p != q &&
        CGAL::side_of_oriented_sphere(points[a], points[b], points[c], points[q], points[p]) ==
        CGAL::ON_POSITIVE_SIDE;
    });
}

/** Removes candidates that are in the way of faces that have been made. */
void Filling::KeepApart(const std::vector<int>& made, Front& front, std::ptrdiff_t& steps) const
{
  for (OpenFace& face : front)
  {
    const Triangle& corners = this->Faces[face.Index].Corners;
    const auto isInTheWay = [&](int apex)
    {
      return std::any_of(made.begin(), made.end(),
        [&](int other)
        {
          --steps;
          return !this->IsClear({ corners[0], corners[1], corners[2], apex }, this->Faces[other]);
        });
    };
    face.Apexes.erase(
      std::remove_if(face.Apexes.begin(), face.Apexes.end(), isInTheWay), face.Apexes.end());
  }
}

/**
 * Puts a cell at a face. `rest` is the front without the faces of the cell, and `made` are the
 * further faces of the cell, from the other side. Returns false if one is already there.
 */
bool Filling::Close(
  const Front& front, const OpenFace& face, int apex, Front& rest, std::vector<int>& made)
{
  const Triangle& corners = this->Faces[face.Index].Corners;
  const Tetrahedron cell = { corners[0], corners[1], corners[2], apex };
  std::array<Triangle, 4> own;
  std::array<bool, 4> closed = {};
  for (int f = 0; f < 4; ++f)
  {
    own[f] = InwardFace(cell, f);
  }
  for (const OpenFace& open : front)
  {
    const Triangle& other = this->Faces[open.Index].Corners;
    const auto found = std::find(own.begin(), own.end(), other);
    if (found == own.end())
    {
      rest.push_back(open);
      continue;
    }
    closed[found - own.begin()] = true;
  }
  for (int f = 0; f < 4; ++f)
  {
    if (!closed[f])
    {
      made.push_back(this->AddFace(Flipped<3>(own[f])));
    }
  }
  const auto isOpen = [&](int made)
  {
    return std::any_of(rest.begin(), rest.end(),
      [&](const OpenFace& open)
      { return this->Faces[open.Index].Corners == this->Faces[made].Corners; });
  };
  return std::none_of(made.begin(), made.end(), isOpen);
}

void Filling::Open(const std::vector<int>& made, Front& front, std::ptrdiff_t& steps)
{
  for (const int index : made)
  {
    OpenFace face{ index, {} };
    this->FindApexes(face, front, steps);
    front.push_back(std::move(face));
  }
}

bool Filling::AllRequiredUsed() const
{
  std::vector<char> missing = this->Space.Required;
  for (const Tetrahedron& cell : this->Cells)
  {
    for (const int corner : cell)
    {
      missing[corner] = 0;
    }
  }
  return std::count(missing.begin(), missing.end(), 1) == 0;
}

bool Filling::Place(const Front& front, std::ptrdiff_t& steps)
{
  if (front.empty())
  {
    return this->AllRequiredUsed();
  }
  const OpenFace face = *std::min_element(front.begin(), front.end(),
    [](const OpenFace& a, const OpenFace& b) { return a.Apexes.size() < b.Apexes.size(); });
  return std::any_of(face.Apexes.begin(), face.Apexes.end(),
    [&](int apex) { return this->PlaceAt(front, face, apex, steps); });
}

/** Tries all tetrahedra that are at a face around one end of the edge and have the other end. */
bool Filling::PlaceAtEdge(const Front& front, std::ptrdiff_t& steps)
{
  const auto& [a, b] = this->Space.Edge;
  for (const OpenFace& face : front)
  {
    const Triangle& corners = this->Faces[face.Index].Corners;
    if (std::find(corners.begin(), corners.end(), a) != corners.end() &&
      std::find(face.Apexes.begin(), face.Apexes.end(), b) != face.Apexes.end() &&
      this->PlaceAt(front, face, b, steps))
    {
      return true;
    }
  }
  return false;
}

bool Filling::PlaceAt(const Front& front, const OpenFace& face, int apex, std::ptrdiff_t& steps)
{
  if (steps < 0)
  {
    return false;
  }
  const std::size_t numberOfFaces = this->Faces.size();
  const Triangle corners = this->Faces[face.Index].Corners;
  Front rest;
  std::vector<int> made;
  if (this->Close(front, face, apex, rest, made))
  {
    this->KeepApart(made, rest, steps);
    this->Open(made, rest, steps);
    this->Cells.push_back({ corners[0], corners[1], corners[2], apex });
    if (this->Place(rest, steps))
    {
      return true;
    }
    this->Cells.pop_back();
  }
  this->Faces.resize(numberOfFaces, this->Faces.front());
  return false;
}

} // namespace carving::helper
