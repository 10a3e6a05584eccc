// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * When the helper program has to run again.
 */
#ifndef HelperReuse_h
#define HelperReuse_h

#include "Core/Protocol/Protocol.h"

/** All settings that the helper program's answer can depend on. */
struct HelperSettings : carving::HelperOptions
{
  carving::SolidRule Solid = carving::SolidRule::NonzeroWinding;
};

/**
 * Whether the helper program would give the same answer for the same mesh with other settings. False where
 * this is not certain. The dimension is 3 for meshes, 2 for contours.
 */
bool WouldAnswerAlike(const carving::Reply& reply, const HelperSettings& before,
  const HelperSettings& now, int dimension);

#endif
