// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The parts of M that meet a tetrahedron.
 */
#ifndef carving_Contacts_h
#define carving_Contacts_h

#include "Helper/Enclosing/Pierce.h"

#include <vector>

namespace carving::helper
{

/** A part of M, and how it meets a tetrahedron. */
struct PartContact
{
  int Part;
  Contact How;
};

/** The data of a tetrahedron. */
struct CellContacts
{
  std::vector<PartContact> All;
  int NumberOfPiercing = 0;
  std::array<bool, 4> Near = {}; ///< whether each face is known to be within the tolerance of M
  unsigned LastWalk = 0;         ///< the last walk that visited the tetrahedron
  int Index = -1;

  void Add(const PartContact& contact);
  /** Returns whether there was a contact with the part. */
  bool Remove(int part);
  bool IsPierced() const
  {
    return this->NumberOfPiercing > 0;
  }
  /** The part of the lowest index on a face; -1: none. */
  int PartOn(int f) const;
};

} // namespace carving::helper

#endif
