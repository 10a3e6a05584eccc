// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileName_h
#define FileName_h

#include <string>

namespace FileName
{

/** The end of a name from its last dot on, in lower case: ".ply"; empty if there is no dot. */
std::string GetExtension(const std::string& name);

/** The name without its folder, its extension and .gz: "scan" for "data/scan.ply.gz". */
std::string GetStem(const std::string& name);

/** The name without its extension: "data/scan" for "data/scan.ply". */
std::string WithoutExtension(const std::string& name);

} // namespace FileName

#endif
