// SPDX-License-Identifier: BSD-3-Clause
#include "ChildProcessTesting.h"

#include <chrono>
#include <cmath>
#include <ctime>
#include <map>
#include <thread>

using namespace carving::helper;

std::unique_ptr<Messages> Added;

namespace
{

std::unique_ptr<Messages> OpenMessages()
{
  return std::make_unique<Messages>("added");
}

/** All work by name. A function, since static objects of other files use it. */
std::map<std::string, std::function<bool()>>& AllWork()
{
  static std::map<std::string, std::function<bool()>> all;
  return all;
}

} // namespace

ChildWork::ChildWork(const std::string& name, const std::function<bool()>& work)
  : Handed{ work, [name](std::ostream& out) { out << name; } }
{
  AllWork()[name] = work;
}

bool ResumeChildWork(std::istream& in)
{
  std::string name;
  std::getline(in, name);
  Added = OpenMessages();
  return AllWork().at(name)();
}

const ChildWork Hang("hang",
  []
  {
    std::this_thread::sleep_for(std::chrono::hours(1));
    return true;
  });
const ChildWork ComputeForever("compute forever", [] { return Compute(HUGE_VAL); });

ChildProcess::ChildProcess()
{
  Added = OpenMessages();
}

ChildProcess::~ChildProcess()
{
  Added.reset();
}

Limits ByClock(double seconds)
{
  return { seconds, 0.0, 0.0 };
}

Limits ByProcessor(double seconds)
{
  return { 0.0, seconds, 0.0 };
}

Limits ByMemory(double mebibytes)
{
  return { 0.0, 0.0, mebibytes };
}

std::string EndOf(const Limits& limits, const ChildWork& work)
{
  return RunInChildProcess(limits, work.Get()).Mistake;
}

bool Compute(double seconds)
{
  while (static_cast<double>(std::clock()) < seconds * CLOCKS_PER_SEC)
  {
  }
  return true;
}
