// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The files by which the helper program exchanges data with its host.
 */
#ifndef carving_HostLink_h
#define carving_HostLink_h

#include <string>

namespace carving::helper
{

/** Paths of files that this process and its child processes can open. */
struct HostLink
{
  std::string JobPath;
  std::string ReplyPath;
};

/**
 * The files of the host, from the arguments of the function main. On Linux, these are standard
 * input and output, and all other output goes to standard error from then on. Elsewhere, the
 * arguments name them; without arguments, both paths are empty.
 */
HostLink ConnectToHost(int argc, char* argv[]);

} // namespace carving::helper

#endif
