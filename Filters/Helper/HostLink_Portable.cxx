// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/HostLink.h"

namespace carving::helper
{

HostLink ConnectToHost(int argc, char* argv[])
{
  return argc > 2 ? HostLink{ argv[1], argv[2] } : HostLink{};
}

} // namespace carving::helper
