// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the test program does as a child process, where that is not a fork but a further run of it.
 */
#ifndef ChildWork_h
#define ChildWork_h

#include "Helper/Attempts/ChildProcess.h"

#include <istream>
#include <string>

/** Work that a child process finds by its name. Objects of this class are static. */
class ChildWork
{
public:
  ChildWork(const std::string& name, const std::function<bool()>& work);

  const carving::helper::Work& Get() const
  {
    return this->Handed;
  }

private:
  carving::helper::Work Handed;
};

/** Does the work that a ChildWork has handed over. */
bool ResumeChildWork(std::istream& in);

/** Whether a test of the strategies has started this process. */
bool BelongsToStrategies();

/** Does the part of the strategies that a test of them has handed over. */
bool ResumeTestedStrategies(std::istream& in);

#endif
