// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The strategies that meet M exactly.
 */
#ifndef carving_ExactAttempts_h
#define carving_ExactAttempts_h

#include "Helper/Attempts/Attempts.h"
#include "Helper/Resolve/Snap.h"

#include <functional>
#include <string>

namespace carving::helper
{

/** All attempts at M, and at M with its points moved. */
class ExactAttempts : public Attempts
{
public:
  using Attempts::Attempts;

protected:
  bool TryExact();
  bool TrySnapped();

private:
  bool MayRecover() const;
  bool TryFirst(const std::function<bool()>& isResolved = {});
  bool TryDelaunayFaces(const ResolvedMesh& given, double tolerance);
  bool TryWithoutInterior();
  bool TrySnapped(const ResolvedMesh& given, double tolerance, double coarsest, Snapping* snap,
    const std::string& what);
  std::string CheckSnapped(const SnappedMesh& snapped, double tolerance) const;
  bool TryMoved(SnappedMesh& snapped);

  Messages Resolved{ "resolved" }; ///< whether TryExact has resolved M; it runs in a child process
};

} // namespace carving::helper

#endif
