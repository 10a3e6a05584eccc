// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Demand.h"

#include "Core/Protocol/SecondsSince.h"

#include <chrono>
#include <thread>

namespace carving::helper
{

void Demand::Raise()
{
  this->Text.Add("wanted");
}

bool Demand::IsRaised() const
{
  return !this->Text.Get().empty();
}

void Demand::Await(double seconds) const
{
  const auto start = std::chrono::steady_clock::now();
  while (!this->IsRaised() && SecondsSince(start) < seconds)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

} // namespace carving::helper
