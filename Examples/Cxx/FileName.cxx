// SPDX-License-Identifier: BSD-3-Clause
#include "FileName.h"

#include "vtksys/SystemTools.hxx"

using vtksys::SystemTools;

std::string FileName::GetExtension(const std::string& name)
{
  return SystemTools::LowerCase(SystemTools::GetFilenameLastExtension(name));
}

std::string FileName::GetStem(const std::string& name)
{
  const std::string last = SystemTools::GetFilenameName(name);
  return WithoutExtension(GetExtension(last) == ".gz" ? WithoutExtension(last) : last);
}

std::string FileName::WithoutExtension(const std::string& name)
{
  return name.substr(0, name.size() - GetExtension(name).size());
}
