// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/Contacts.h"

#include <algorithm>

namespace carving::helper
{

void CellContacts::Add(const PartContact& contact)
{
  this->All.push_back(contact);
  this->NumberOfPiercing += contact.How.Pierces;
}

bool CellContacts::Remove(int part)
{
  const auto found = std::find_if(this->All.begin(), this->All.end(),
    [&](const PartContact& contact) { return contact.Part == part; });
  const bool met = found != this->All.end();
  if (met)
  {
    this->NumberOfPiercing -= found->How.Pierces;
    this->All.erase(found);
  }
  return met;
}

int CellContacts::PartOn(int f) const
{
  int first = -1;
  for (const PartContact& contact : this->All)
  {
    if (contact.How.Face == f && (first < 0 || contact.Part < first))
    {
      first = contact.Part;
    }
  }
  return first;
}

} // namespace carving::helper
