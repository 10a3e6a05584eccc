// SPDX-License-Identifier: BSD-3-Clause
#include "System/TemporaryFile.h"

#include <memory>
#include <new>

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

struct TemporaryFile::File
{
  explicit File(int descriptor)
    : Descriptor(descriptor)
  {
  }
  ~File()
  {
    close(this->Descriptor);
  }

  const int Descriptor;
};

TemporaryFile::TemporaryFile(const std::string& name)
{
  const int descriptor = memfd_create(name.c_str(), MFD_CLOEXEC);
  if (descriptor >= 0)
  {
    this->Opened = std::make_unique<File>(descriptor);
  }
}

TemporaryFile::~TemporaryFile() = default;

bool TemporaryFile::IsOpen() const
{
  return this->Opened != nullptr;
}

std::string TemporaryFile::GetPath() const
{
  return "/proc/self/fd/" + std::to_string(this->Opened->Descriptor);
}

void TemporaryFile::Read(const std::function<void(const char*, std::size_t)>& read) const
{
  struct stat status = {};
  fstat(this->Opened->Descriptor, &status);
  const std::size_t size = static_cast<std::size_t>(status.st_size);
  if (size == 0)
  {
    read("", 0);
    return;
  }
  void* data =
    mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, this->Opened->Descriptor, 0);
  if (data == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
  const auto unmap = [size](void* mapped) { munmap(mapped, size); };
  const std::unique_ptr<void, decltype(unmap)> guard(data, unmap);
  read(static_cast<const char*>(data), size);
}

std::string TemporaryFile::GetPlace()
{
  return "memory";
}
