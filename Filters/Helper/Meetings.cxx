// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Meetings.h"

#include <algorithm>

using carving::FaceCorners;

namespace
{

/** Whether a part may meet a cell as far as their bounding boxes can tell. */
bool Close(const Corners3& corners, const Corners4& k)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto [least, most] = std::minmax({ corners[0][i], corners[1][i], corners[2][i] });
    const auto [lower, upper] = std::minmax({ k[0][i], k[1][i], k[2][i], k[3][i] });
    const bool apart =
      least == most ? least > upper || most < lower : least >= upper || most <= lower;
    if (apart)
    {
      return false;
    }
  }
  return true;
}

} // namespace

bool Meet(const Corners3& corners, const Corners4& k, Meeting& meeting)
{
  meeting.OnFace = {};
  if (!Close(corners, k))
  {
    return false;
  }
  meeting.Pierces = Pierces(corners, k);
  bool lies = false;
  for (int f = 0; f < 4 && !meeting.Pierces; ++f)
  {
    meeting.OnFace[f] =
      OverlapInPlane(corners, { k[FaceCorners[f][0]], k[FaceCorners[f][1]], k[FaceCorners[f][2]] });
    lies = lies || meeting.OnFace[f];
  }
  return meeting.Pierces || lies;
}

void Meetings::Add(const Meeting& meeting)
{
  this->All.push_back(meeting);
  this->NumberOfPiercing += meeting.Pierces;
}

bool Meetings::Remove(int part)
{
  const auto found = std::find_if(this->All.begin(), this->All.end(),
    [&](const Meeting& meeting) { return meeting.Part == part; });
  const bool met = found != this->All.end();
  if (met)
  {
    this->NumberOfPiercing -= found->Pierces;
    this->All.erase(found);
  }
  return met;
}

int Meetings::PartOn(int f) const
{
  int first = -1;
  for (const Meeting& meeting : this->All)
  {
    if (meeting.OnFace[f] && (first < 0 || meeting.Part < first))
    {
      first = meeting.Part;
    }
  }
  return first;
}
