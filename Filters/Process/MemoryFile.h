// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files in memory.
 */
#ifndef MemoryFile_h
#define MemoryFile_h

#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

/** A file in memory, without a name. It vanishes with this object, and needs no disk. */
class MemoryFile
{
public:
  explicit MemoryFile(const char* name)
    : Descriptor(memfd_create(name, MFD_CLOEXEC))
  {
  }
  ~MemoryFile()
  {
    if (this->Descriptor >= 0)
    {
      close(this->Descriptor);
    }
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  bool IsOpen() const
  {
    return this->Descriptor >= 0;
  }

  /** A path by which this process can open the file. */
  std::string GetPath() const
  {
    return "/proc/self/fd/" + std::to_string(this->Descriptor);
  }

  /** Calls `read(data, size)` with the whole content. */
  template <class Function>
  void Read(Function&& read) const
  {
    struct stat status = {};
    fstat(this->Descriptor, &status);
    const std::size_t size = static_cast<std::size_t>(status.st_size);
    void* data = size > 0
      ? mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, this->Descriptor, 0)
      : MAP_FAILED;
    if (data == MAP_FAILED)
    {
      read("", 0);
      return;
    }
    read(static_cast<const char*>(data), size);
    munmap(data, size);
  }

private:
  int Descriptor;
};

#endif
