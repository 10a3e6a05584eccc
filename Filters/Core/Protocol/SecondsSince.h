// SPDX-License-Identifier: BSD-3-Clause
#ifndef carving_SecondsSince_h
#define carving_SecondsSince_h

#include <chrono>

namespace carving
{

/** Wall-clock seconds, as the stages of the work are measured. */
inline double SecondsSince(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace carving

#endif
