// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Work and limits that the tests of child processes share.
 */
#ifndef ChildProcessTesting_h
#define ChildProcessTesting_h

#include "ChildWork.h"
#include "Helper/Attempts/Messages.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

/** The messages of a test and its child processes. */
extern std::unique_ptr<carving::helper::Messages> Added;

class ChildProcess : public testing::Test
{
protected:
  ChildProcess();
  ~ChildProcess() override;
};

carving::helper::Limits ByClock(double seconds);
carving::helper::Limits ByProcessor(double seconds);
carving::helper::Limits ByMemory(double mebibytes);

/** How work in a child process ended. */
std::string EndOf(const carving::helper::Limits& limits, const ChildWork& work);

/** Computes until this process has used so many seconds of processor time. */
bool Compute(double seconds);

extern const ChildWork Hang;
extern const ChildWork ComputeForever;

#endif
