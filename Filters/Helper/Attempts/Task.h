// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The parts of the strategies that run in child processes, and their state as bytes.
 */
#ifndef carving_Task_h
#define carving_Task_h

#include "Core/Protocol/Protocol.h"
#include "Helper/Exact/Tetrahedralize.h"

#include <iosfwd>

namespace carving::helper
{

/** What a child process does. */
struct Task
{
  enum class Goal : int
  {
    Exact,            ///< all attempts at M
    Snapped,          ///< all attempts at M with its points moved
    Enclosing,        ///< the enclosing tetrahedralization
    QuicklyRecovered, ///< recovery on the resolved mesh with little effort
    Recovered,        ///< the same with much effort
    Ordered           ///< TetGen on the resolved mesh in one order
  };

  Goal What = Goal::Exact;
  int Order = 0;
  SurfacePoints Points = SurfacePoints::None;
};

/**
 * Writes a task with all that it depends on. The reply has a surface and no tetrahedra yet, and is
 * the same afterwards.
 */
void WriteTask(std::ostream& out, const Task& task, const Job& job, Reply& reply);

/** Reads the output of WriteTask. Throws std::runtime_error if that is impossible. */
void ReadTask(std::istream& in, Task& task, Job& job, Reply& reply);

} // namespace carving::helper

#endif
