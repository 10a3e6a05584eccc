// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Meetings.h"

#include <algorithm>

void Meetings::Add(const Meeting& meeting)
{
  this->All.push_back(meeting);
  this->NumberOfPiercing += meeting.How.Pierces;
}

bool Meetings::Remove(int part)
{
  const auto found = std::find_if(this->All.begin(), this->All.end(),
    [&](const Meeting& meeting) { return meeting.Part == part; });
  const bool met = found != this->All.end();
  if (met)
  {
    this->NumberOfPiercing -= found->How.Pierces;
    this->All.erase(found);
  }
  return met;
}

int Meetings::PartOn(int f) const
{
  int first = -1;
  for (const Meeting& meeting : this->All)
  {
    if (meeting.How.Face == f && (first < 0 || meeting.Part < first))
    {
      first = meeting.Part;
    }
  }
  return first;
}
