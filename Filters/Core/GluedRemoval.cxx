// SPDX-License-Identifier: BSD-3-Clause
#include "GluedRemoval.h"

#include "LeftCells.h"

#include <algorithm>
#include <vector>

namespace carving
{
namespace
{

/** Calls `visit` with each pair of faces that have a label, and the number of the edge between them. */
template <class Visitor>
void ForEachPair(const std::array<int, 4>& labels, Visitor&& visit)
{
  for (int f = 0; f < 4; ++f)
  {
    for (int g = 0; g < f; ++g)
    {
      if (labels[f] >= 0 && labels[g] >= 0)
      {
        const auto [q, p] = OtherCorners(f, g);
        visit(f, g, EdgeIndex(p, q));
      }
    }
  }
}

void Unite(std::array<int, 4>& labels, int f, int g)
{
  std::replace(labels.begin(), labels.end(), int(labels[f]), int(labels[g]));
}

} // namespace

GluedRemoval Assess(unsigned held, unsigned touched, const std::array<unsigned, 4>& closed)
{
  GluedRemoval removal;
  std::array<int, 4> faces;
  for (int f = 0; f < 4; ++f)
  {
    faces[f] = held >> f & 1 ? f : -1;
  }
  const int numberHeld = CountLabels(faces);
  int numberTouched = 0;
  removal.Parts = faces;
  ForEachPair(faces,
    [&](int f, int g, int edge)
    {
      const bool isTouched = touched >> edge & 1;
      numberTouched += isTouched;
      if (!isTouched)
      {
        Unite(removal.Parts, f, g);
      }
    });
  removal.Voids = numberHeld == 4 && numberTouched == 0;
  // Without others it goes whole. Else other edges, faces and itself leave the characteristic as it is.
  removal.EulerCharacteristic = numberHeld == 0 ? -1 : (numberHeld == 4) - numberTouched;
  for (int corner = 0; corner < 4; ++corner)
  {
    std::array<int, 4> around = faces;
    around[corner] = -1;
    unsigned gaps = 0;
    for (int f = 0; f < 4; ++f)
    {
      if (f != corner && faces[f] < 0)
      {
        const int end = OtherCorners(corner, f)[0];
        gaps = 1u << EdgeIndex(std::max(corner, end), std::min(corner, end)); // one for all such
      }
    }
    ForEachPair(faces,
      [&](int f, int g, int edge)
      {
        if (f != corner && g != corner)
        {
          gaps |= (touched >> edge & 1) << edge;
          if (((touched & ~closed[corner]) >> edge & 1) == 0)
          {
            Unite(around, f, g);
          }
        }
      });
    removal.Gaps[corner] = static_cast<unsigned char>(gaps);
    removal.HasSeveralGaps = removal.HasSeveralGaps || (gaps & (gaps - 1)) != 0;
    removal.EulerCharacteristic += std::max(CountLabels(around) - 1, 0);
    ForEachPair(around,
      [&](int f, int g, int)
      {
        if (around[f] == around[g])
        {
          Unite(removal.Parts, f, g);
        }
      });
  }
  removal.Components = CountLabels(removal.Parts) - 1;
  return removal;
}

const GluedRemoval& AssessApart(unsigned held, unsigned touched)
{
  static const std::vector<GluedRemoval> known = []
  {
    std::vector<GluedRemoval> removals;
    for (unsigned index = 0; index < 16 * 64; ++index)
    {
      removals.push_back(Assess(index / 64, index % 64, {}));
    }
    return removals;
  }();
  return known[64 * held + touched];
}

} // namespace carving
