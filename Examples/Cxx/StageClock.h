// SPDX-License-Identifier: BSD-3-Clause
#ifndef StageClock_h
#define StageClock_h

#include <chrono>
#include <string>
#include <utility>
#include <vector>

/** Measures the stages of a run. */
class StageClock
{
public:
  /** Starts a stage. */
  void Start()
  {
    this->Last = std::chrono::steady_clock::now();
  }

  /** Ends a stage and starts the next one. */
  void Record(const std::string& stage)
  {
    const auto last = this->Last;
    this->Start();
    this->Add(stage, std::chrono::duration<double>(this->Last - last).count());
  }

  /** Adds a stage that was measured elsewhere. */
  void Add(const std::string& stage, double seconds)
  {
    this->Seconds.emplace_back(stage, seconds);
  }

  const std::vector<std::pair<std::string, double>>& GetSeconds() const
  {
    return this->Seconds;
  }

private:
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
  std::vector<std::pair<std::string, double>> Seconds;
};

#endif
