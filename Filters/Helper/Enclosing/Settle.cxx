// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Finds the tetrahedra of a PiercedMesh that parts meet.
 */
#include "Core/Mesh/ForEach.h"
#include "Helper/Base/BoxPairs.h"
#include "Helper/Enclosing/HullFace.h"
#include "Helper/Enclosing/Walk.h"

#include <algorithm>
#include <atomic>

namespace carving::helper
{

/** Finds the contacts of a part that is a face, as most parts are, without a search. */
bool PiercedMesh::SettleOnFace(int part)
{
  const std::optional<Delaunay::Facet> found = this->FindFace(part);
  if (!found)
  {
    return false;
  }
  const auto& [cell, f] = *found;
  const Cell other = cell->neighbor(f);
  for (const auto& [side, face] : { std::pair(cell, f), std::pair(other, other->index(cell)) })
  {
    if (!this->Mesh.is_infinite(side))
    {
      side->info().Add({ part, { false, face } });
    }
  }
  return true;
}

void PiercedMesh::Push(const Cell& cell, std::vector<Cell>& stack)
{
  if (cell->info().LastWalk != this->NumberOfWalks && !this->Mesh.is_infinite(cell))
  {
    cell->info().LastWalk = this->NumberOfWalks;
    stack.push_back(cell);
  }
}

void PiercedMesh::PushStar(const Vertex& v, std::vector<Cell>& stack)
{
  this->Star.clear();
  this->Mesh.finite_incident_cells(v, std::back_inserter(this->Star));
  for (const Cell& cell : this->Star)
  {
    this->Push(cell, stack);
  }
}

/** The contact with a cell. A part that is beyond a hull face of the cell counts as piercing it. */
Contact PiercedMesh::FindContact(const Piercer& piercer, const Cell& cell) const
{
  Contact contact = piercer.FindContact(helper::CornersOf(cell));
  for (int f = 0; f < 4 && !contact.Exists(); ++f)
  {
    if (this->Mesh.is_infinite(cell->neighbor(f)))
    {
      const HullFace face(this->Mesh, cell, f);
      contact.Pierces = piercer.FindContact(face.GetPyramid()).Pierces;
    }
  }
  return contact;
}

/** Records the contact of a part with a cell, if there is one. */
void PiercedMesh::Meet(int part, const Piercer& piercer, const Cell& cell)
{
  const Contact contact = this->FindContact(piercer, cell);
  if (contact.Exists())
  {
    cell->info().Add({ part, contact });
  }
}

/** Settles a part that is a face, or without area. Returns whether it was one. */
bool PiercedMesh::SettleSimply(int part)
{
  if (this->SettleOnFace(part))
  {
    return true;
  }
  const auto [a, b, c] = this->CornersOf(part);
  const bool isFlat = CGAL::collinear(a, b, c);
  if (isFlat)
  {
    this->Parts.Take(part); // rounding leaves it without area: its neighbors are enough
  }
  return isFlat;
}

/** Finds the contacts of a part, cell by cell. */
template <class Marks>
void PiercedMesh::FindContacts(int part, Marks& marks, CellContactList& contacts) const
{
  const Piercer piercer(this->CornersOf(part));
  contacts.clear();
  marks.Begin();
  this->Walk(part, piercer, marks,
    [&](const Cell& cell)
    {
      const Contact contact = this->FindContact(piercer, cell);
      if (contact.Exists())
      {
        contacts.emplace_back(cell, contact);
      }
      return contact.Exists();
    });
}

void PiercedMesh::AddContacts(int part, const CellContactList& contacts)
{
  for (const auto& [cell, contact] : contacts)
  {
    cell->info().Add({ part, contact });
  }
}

/** Finds the tetrahedra that a part meets. */
void PiercedMesh::Settle(int part)
{
  if (!this->SettleSimply(part))
  {
    MeshMarks marks(*this);
    CellContactList contacts;
    this->FindContacts(part, marks, contacts);
    this->AddContacts(part, contacts);
  }
}

/** Finds the tetrahedra that parts meet, as Settle does for each of them, on several threads. */
void PiercedMesh::SettleAll(
  std::vector<int> parts, int threads, const std::function<bool(double)>& progress)
{
  parts.erase(std::remove_if(
                parts.begin(), parts.end(), [this](int part) { return this->SettleSimply(part); }),
    parts.end());
  int cells = 0;
  for (const Cell cell : this->Mesh.all_cell_handles())
  {
    cell->info().Index = cells++;
  }
  constexpr int most = 8; // since the marks of each take eight bytes for a tetrahedron
  threads = std::clamp(threads, 1, most);
  std::vector<OwnMarks> marks(threads, OwnMarks(*this));
  constexpr std::size_t batch = 2000; // whose contacts are held twice
  std::vector<CellContactList> contacts(batch);
  for (std::size_t first = 0; first < parts.size(); first += batch)
  {
    progress(static_cast<double>(first) / static_cast<double>(parts.size()));
    const std::size_t count = std::min(batch, parts.size() - first);
    std::atomic<std::size_t> next{ 0 };
    ForEach(threads, threads,
      [&](int thread)
      {
        for (std::size_t i = next++; i < count; i = next++)
        {
          this->FindContacts(parts[first + i], marks[thread], contacts[i]);
        }
      });
    for (std::size_t i = 0; i < count; ++i)
    {
      this->AddContacts(parts[first + i], contacts[i]);
    }
  }
}

std::vector<PiercedMesh::Cell> PiercedMesh::FindCells(int part)
{
  MeshMarks marks(*this);
  CellContactList contacts;
  this->FindContacts(part, marks, contacts);
  std::vector<Cell> cells;
  for (const auto& [cell, contact] : contacts)
  {
    cells.push_back(cell);
  }
  return cells;
}

void PiercedMesh::Forget(int part)
{
  MeshMarks marks(*this);
  marks.Begin();
  this->Walk(part, Piercer(this->CornersOf(part)), marks,
    [&](const Cell& cell) { return cell->info().Remove(part); });
}

/**
 * Records the contacts of parts with cells. Where points in a plane are off it by a rounding, both
 * are numerous and few of them meet.
 */
void PiercedMesh::MeetAll(const std::vector<int>& parts, const std::vector<Cell>& cells)
{
  std::vector<IndexedBox> partBoxes, cellBoxes;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    partBoxes.emplace_back(BoundsOf(this->CornersOf(parts[i])), static_cast<int>(i));
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    CGAL::Bbox_3 bounds = BoundsOf(helper::CornersOf(cells[i]));
    for (int f = 0; f < 4; ++f)
    {
      if (this->Mesh.is_infinite(cells[i]->neighbor(f)))
      {
        bounds += HullFace(this->Mesh, cells[i], f).GetBounds();
      }
    }
    cellBoxes.emplace_back(bounds, static_cast<int>(i));
  }
  std::vector<std::pair<int, int>> pairs;
  VisitPairs(std::move(partBoxes), std::move(cellBoxes),
    [&](int part, int cell) { pairs.emplace_back(part, cell); });
  std::sort(pairs.begin(), pairs.end());
  for (auto pair = pairs.begin(); pair != pairs.end();)
  {
    const int part = pair->first;
    const Piercer piercer(this->CornersOf(parts[part]));
    for (; pair != pairs.end() && pair->first == part; ++pair)
    {
      this->Meet(parts[part], piercer, cells[pair->second]);
    }
  }
}

} // namespace carving::helper
