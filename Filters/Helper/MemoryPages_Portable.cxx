// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/MemoryPages.h"

namespace carving::helper
{

void UseLargePagesForAll(char*[])
{
}

} // namespace carving::helper
