// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Temporary files, in memory if possible.
 */
#ifndef TemporaryFile_h
#define TemporaryFile_h

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

/**
 * A file that vanishes with this object. On Linux, the file is in memory: it needs no disk, and
 * vanishes with the process in any case. Elsewhere, the file is in a folder of its own among the
 * system's temporary files.
 */
class TemporaryFile
{
public:
  /** If no file can be made, errno tells the reason. */
  explicit TemporaryFile(const std::string& name);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  bool IsOpen() const;

  /**
   * A path by which this process can open the file. Without memory files, other processes can open
   * the file, too, and files made in its folder vanish with it.
   */
  std::string GetPath() const;

  /** Calls `read(data, size)` with the whole content. */
  void Read(const std::function<void(const char*, std::size_t)>& read) const;

  /** Where such files are, for messages: "memory", or the folder. */
  static std::string GetPlace();

private:
  struct File;
  std::unique_ptr<File> Opened;
};

#endif
