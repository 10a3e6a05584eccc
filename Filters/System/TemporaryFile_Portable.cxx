// SPDX-License-Identifier: BSD-3-Clause
#include "System/TemporaryFile.h"

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

namespace files = std::filesystem;

namespace
{

/** Makes a folder that only this user can enter. Returns an empty path if that is impossible. */
files::path MakeFolder(const std::string& name)
{
  std::error_code failure;
  const files::path parent = files::temp_directory_path(failure);
  auto number = std::chrono::steady_clock::now().time_since_epoch().count();
  while (!failure)
  {
    const files::path folder = parent / (name + "-" + std::to_string(number++));
    if (files::create_directory(folder, failure)) // not if another process has made the folder
    {
      files::permissions(folder, files::perms::owner_all, failure);
      if (!failure)
      {
        return folder;
      }
      std::error_code ignored;
      files::remove(folder, ignored);
    }
  }
  return {};
}

} // namespace

struct TemporaryFile::File
{
  ~File()
  {
    std::error_code failure;
    files::remove_all(this->Path.parent_path(), failure);
  }

  files::path Path;
};

TemporaryFile::TemporaryFile(const std::string& name)
{
  const files::path folder = MakeFolder(name);
  if (folder.empty())
  {
    return;
  }
  const files::path file = folder / name;
  if (std::ofstream(file))
  {
    this->Opened = std::make_unique<File>();
    this->Opened->Path = file;
    return;
  }
  const int reason = errno;
  std::error_code failure;
  files::remove(folder, failure);
  errno = reason;
}

TemporaryFile::~TemporaryFile() = default;

bool TemporaryFile::IsOpen() const
{
  return this->Opened != nullptr;
}

std::string TemporaryFile::GetPath() const
{
  return this->Opened->Path.string();
}

void TemporaryFile::Read(const std::function<void(const char*, std::size_t)>& read) const
{
  std::ifstream in(this->Opened->Path, std::ios::binary | std::ios::ate);
  const std::streamoff size = in ? std::streamoff(in.tellg()) : 0;
  std::vector<char> data(size > 0 ? static_cast<std::size_t>(size) : 0);
  in.seekg(0);
  in.read(data.data(), static_cast<std::streamsize>(data.size()));
  read(data.data(), data.size());
}

std::string TemporaryFile::GetPlace()
{
  std::error_code failure;
  return "the folder " + files::temp_directory_path(failure).string();
}
