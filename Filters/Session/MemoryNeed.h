// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The memory that carving a mesh takes.
 */
#ifndef MemoryNeed_h
#define MemoryNeed_h

#include "Core/Protocol/Protocol.h"

#include <string>

/** Bytes that a mesh takes at the peak, estimated from its size. */
struct MemoryNeed
{
  double Host = 0.0;   ///< of the process of the filter, with the stream and eight levels
  double Helper = 0.0; ///< of the helper program

  /**
   * By measurements of closed meshes and of foliage, from 20,000 vertices on: the need of the
   * helper and of the host within a tenth. Meshes whose triangles cross take more. `vertices` are
   * distinct.
   */
  static MemoryNeed Estimate(
    double vertices, double triangles, const carving::HelperOptions& options);
};

/**
 * Bytes that this machine has for a helper program: at most what PV_HOST_MEMORY_LIMIT allows. 0 if
 * the system does not tell.
 */
double GetMemoryOfMachine();

/**
 * Returns an empty string, or an error if the mesh needs more memory than the machine has. A job
 * with a MemoryLimit is never refused.
 */
std::string CheckMemory(const carving::Job& job);

#endif
