// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether the helper program must run again.
 */
#ifndef HelperReuse_h
#define HelperReuse_h

#include "Core/Protocol/Protocol.h"

/** All settings on which the reply of the helper program can depend. */
struct HelperSettings : carving::HelperOptions
{
  carving::SolidRule Solid = carving::SolidRule::NonzeroWinding;
  bool Reuse = true;      ///< later updates may use the reply
  bool NeedsSolid = true; ///< carving needs the tetrahedra of the solid, even without reuse
};

/**
 * Whether the helper program would certainly give the same reply for the same mesh with other
 * settings. The dimension is 3 for meshes, 2 for contours.
 */
bool WouldAnswerAlike(const carving::Reply& reply, const HelperSettings& before,
  const HelperSettings& now, int dimension);

#endif
