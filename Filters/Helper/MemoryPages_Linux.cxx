// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/MemoryPages.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include <unistd.h>

namespace carving::helper
{

void UseLargePagesForAll(char* argv[])
{
  constexpr const char *variable = "GLIBC_TUNABLES", *name = "glibc.malloc.hugetlb";
  const char* given = std::getenv(variable);
  std::string settings = given ? given : "";
  if (settings.find(name) != std::string::npos) // by this function, or by the user
  {
    return;
  }
  settings += settings.empty() ? "" : ":";
  settings += std::string(name) + "=1";
  // By its path, so that the process keeps its name.
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error && setenv(variable, settings.c_str(), 1) == 0)
  {
    execv(program.c_str(), argv);
  }
  // The program also works with small pages.
}

} // namespace carving::helper
