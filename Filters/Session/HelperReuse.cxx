// SPDX-License-Identifier: BSD-3-Clause
#include "Session/HelperReuse.h"

using carving::Conformity;

namespace
{

/** Whether every attempt would be made, fail and succeed as before. */
bool AttemptsAlike(
  const carving::Reply& reply, const HelperSettings& before, const HelperSettings& now)
{
  if (now.Strategy != before.Strategy)
  {
    return false;
  }
  const bool enclosed = !reply.Result.Kept.empty();
  const bool snapped = reply.SnapDistance > 0.0;
  const bool unlimited = reply.Limits.empty(); // no attempt has reached a limit
  if (now.Conformity != before.Conformity)
  {
    // EXACT makes the same attempts as AUTO, with higher limits: also on the number of crossings,
    // beyond which AUTO snaps the mesh.
    if (enclosed || snapped || !unlimited || before.Conformity == Conformity::Enclosing ||
      now.Conformity != Conformity::Exact)
    {
      return false;
    }
  }
  if (now.EnclosingTolerance != before.EnclosingTolerance && enclosed)
  {
    return false;
  }
  // Snapping follows all other exact attempts, and precedes enclosing, or is part of that.
  if (now.SnapTolerance != before.SnapTolerance && (snapped || enclosed))
  {
    return false;
  }
  if (now.Solid != before.Solid && reply.SolidMatters != 0)
  {
    return false;
  }
  // With a time limit of 0, the limit depends on the mesh.
  const bool moreTime = before.TimeLimit > 0.0 && now.TimeLimit > before.TimeLimit;
  return now.TimeLimit == before.TimeLimit || (moreTime && unlimited);
}

} // namespace

bool WouldAnswerAlike(const carving::Reply& reply, const HelperSettings& before,
  const HelperSettings& now, int dimension)
{
  const bool moreMemory =
    before.MemoryLimit > 0.0 && (now.MemoryLimit == 0.0 || now.MemoryLimit > before.MemoryLimit);
  const bool memoryAlike =
    now.MemoryLimit == before.MemoryLimit || (moreMemory && reply.Limits.empty());
  return now.Initial == before.Initial && memoryAlike &&
    (dimension == 2 || AttemptsAlike(reply, before, now));
}
