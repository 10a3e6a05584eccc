// SPDX-License-Identifier: BSD-3-Clause
#include "PlyFile.h"

#include <fstream>
#include <sstream>

std::string PlyFile::FindMistake(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  std::string line, keyword, name, count, found;
  while (std::getline(file, line) && line.compare(0, 10, "end_header") != 0)
  {
    std::istringstream words(line);
    words >> keyword >> name >> count;
    if (keyword != "element")
    {
      continue;
    }
    if (name == "face")
    {
      return found;
    }
    if (name != "vertex" && count != "0" && found.empty())
    {
      found = "its " + count + " elements \"" + name +
        "\" come before its faces, where VTK's reader does not expect them; write the faces first";
    }
  }
  return {};
}

bool PlyFile::EndsWithinALine(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  std::string line;
  while (std::getline(file, line) && line.compare(0, 6, "format") != 0)
  {
    if (line.compare(0, 10, "end_header") == 0)
    {
      return false;
    }
  }
  return line.find("ascii") != std::string::npos && file.seekg(-1, std::ios::end) &&
    file.peek() != '\n';
}
