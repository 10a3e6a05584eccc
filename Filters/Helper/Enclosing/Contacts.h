// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The parts of M that meet a tetrahedron.
 */
#ifndef carving_Contacts_h
#define carving_Contacts_h

#include "Helper/Enclosing/Pierce.h"

#include <vector>

/** How a part of M lies to a tetrahedron that it meets. */
struct PartContact
{
  int Part;
  Contact How;
};

/** What a tetrahedron knows. */
struct CellContacts
{
  std::vector<PartContact> All;
  int NumberOfPiercing = 0;
  std::array<bool, 4> Near = {}; ///< faces found to be near enough to M
  unsigned LastWalk = 0;         ///< that came by
  int Index = -1;

  void Add(const PartContact& contact);
  /** Returns whether there was a contact with the part. */
  bool Remove(int part);
  bool IsPierced() const
  {
    return this->NumberOfPiercing > 0;
  }
  /** The first part on a face; -1: none. */
  int PartOn(int f) const;
};

#endif
