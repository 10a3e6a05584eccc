// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Messages.h"

#include "Helper/Attempts/ProgramRun.h"

#include <cstdio>
#include <fstream>
#include <iterator>

namespace carving::helper
{

/** In a file that the first process makes and removes. */
struct Messages::Text
{
  explicit Text(const std::string& fileName)
    : FileName(fileName)
  {
    if (!IsChildProcess())
    {
      this->Clear();
    }
  }
  ~Text()
  {
    if (!IsChildProcess())
    {
      std::remove(this->FileName.c_str());
    }
  }

  void Clear() const
  {
    std::ofstream empty(this->FileName);
  }

  const std::string FileName;
};

Messages::Messages(const std::string& name)
  : Shared(std::make_unique<Text>(NameOfSharedFile(name)))
{
}

Messages::~Messages() = default;

void Messages::Add(const std::string& line)
{
  std::ofstream(this->Shared->FileName, std::ios::app) << line << '\n';
}

void Messages::Clear()
{
  this->Shared->Clear();
}

std::string Messages::Get() const
{
  std::ifstream in(this->Shared->FileName);
  return { std::istreambuf_iterator<char>(in), {} };
}

} // namespace carving::helper
