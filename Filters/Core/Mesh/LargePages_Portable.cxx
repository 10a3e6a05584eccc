// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/LargePages.h"

namespace carving
{

void UseLargePages(void*, std::size_t)
{
}

void ProvidePages(void*, std::size_t)
{
}

} // namespace carving
