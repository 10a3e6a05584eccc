// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * What a run of a program knows about itself if its child processes are further runs.
 */
#ifndef carving_ProgramRun_h
#define carving_ProgramRun_h

#include <string>

namespace carving::helper
{

/** The name of a file that this process shares with its parent and its child processes. */
std::string NameOfSharedFile(const std::string& name);

bool IsChildProcess();

} // namespace carving::helper

#endif
