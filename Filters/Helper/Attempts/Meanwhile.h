// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * What a process does beside its child process, on every system.
 */
#ifndef carving_Meanwhile_h
#define carving_Meanwhile_h

#include <exception>
#include <functional>

namespace carving::helper
{

/** Work beside a child process, done on construction. The child must be killed unless wanted. */
class Meanwhile
{
public:
  explicit Meanwhile(const std::function<bool()>& work)
  {
    try
    {
      this->Wanted = !work || work();
    }
    catch (...)
    {
      this->Failure = std::current_exception();
    }
  }

  bool WantsChild() const
  {
    return this->Wanted;
  }

  /** Throws the exception of the work, if there was one. To be called when the child has ended. */
  void ThrowFailure() const
  {
    if (this->Failure)
    {
      std::rethrow_exception(this->Failure);
    }
  }

private:
  bool Wanted = false;
  std::exception_ptr Failure;
};

} // namespace carving::helper

#endif
