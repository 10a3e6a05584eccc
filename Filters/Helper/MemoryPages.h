// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The size of the memory pages of this program.
 */
#ifndef carving_MemoryPages_h
#define carving_MemoryPages_h

namespace carving::helper
{

/**
 * Has all memory come in large pages, which makes TetGen and CGAL faster: their data structures are
 * large, and are visited in any order. On Linux, the C library reads this setting when a program
 * starts, so that this function starts the program anew with `argv`, once. Elsewhere, it has no
 * effect.
 */
void UseLargePagesForAll(char* argv[]);

} // namespace carving::helper

#endif
