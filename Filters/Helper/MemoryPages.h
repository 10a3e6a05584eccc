// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The size of the memory pages of this program.
 */
#ifndef carving_MemoryPages_h
#define carving_MemoryPages_h

#include <filesystem>

namespace carving::helper
{

/**
 * Has all memory come in large pages, which makes TetGen and CGAL faster: their data structures are
 * large, and are visited in any order. On Linux, the C library reads this setting when a program
 * starts, so that this function starts the program anew with `argv`, once. A setting in the
 * environment has precedence. The function has no effect on virtual machines that return free pages
 * to their host, and on other systems.
 */
void UseLargePagesForAll(char* argv[]);

/**
 * Whether a virtual machine returns its free pages to its host. If so, large pages are often among
 * the returned ones, and the host has to provide them anew. `balloons` is the folder in which Linux
 * lists the devices that negotiate memory with the host; it exists on virtual machines alone.
 */
bool ReturnsFreePages(const std::filesystem::path& balloons);

} // namespace carving::helper

#endif
