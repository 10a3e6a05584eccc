// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Text that several processes write.
 */
#ifndef carving_Messages_h
#define carving_Messages_h

#include <memory>
#include <string>

namespace carving::helper
{

/**
 * Text that this process shares with its child processes, and they with theirs; on Linux, at most 8
 * KiB.
 */
class Messages
{
public:
  /**
   * Child processes that are no forks find the text by its name, unique among those of a process.
   */
  explicit Messages(const std::string& name);
  ~Messages();
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  void Add(const std::string& line);
  void Clear();
  std::string Get() const;

private:
  struct Text;
  std::unique_ptr<Text> Shared;
};

} // namespace carving::helper

#endif
