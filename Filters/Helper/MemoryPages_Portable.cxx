// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/MemoryPages.h"

namespace carving::helper
{

void UseLargePagesForAll(char*[])
{
}

bool ReturnsFreePages(const std::filesystem::path&)
{
  return false;
}

} // namespace carving::helper
