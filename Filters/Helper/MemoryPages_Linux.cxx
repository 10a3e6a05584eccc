// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/MemoryPages.h"

#include <cstdlib>
#include <fstream>
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
  if (ReturnsFreePages("/sys/bus/virtio/drivers/virtio_balloon"))
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

bool ReturnsFreePages(const std::filesystem::path& balloons)
{
  constexpr std::size_t reporting = 5; // VIRTIO_BALLOON_F_REPORTING of the virtio standard
  std::error_code none;                // a folder that is missing or unreadable has no devices
  const std::filesystem::directory_iterator end;
  for (std::filesystem::directory_iterator device(balloons, none); device != end;
       device.increment(none))
  {
    // The features that the machine and its host agreed on: a digit each, the first one first.
    std::string features;
    std::ifstream(device->path() / "features") >> features;
    if (features.size() > reporting && features[reporting] == '1')
    {
      return true;
    }
  }
  return false;
}

} // namespace carving::helper
