// SPDX-License-Identifier: BSD-3-Clause
#ifndef JsonFile_h
#define JsonFile_h

struct Options;
struct Report;

namespace JsonFile
{

/**
 * Writes a report to the file that the options name, or to standard output, in the form that the
 * manual page describes. Returns whether everything has been written.
 */
bool Write(const Options& options, const Report& report);

} // namespace JsonFile

#endif
