// SPDX-License-Identifier: BSD-3-Clause
#include "StlFile.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>

namespace
{

constexpr std::size_t BytesOfTitle = 80, BytesOfCount = 4;
constexpr std::uint64_t BytesOfTriangle = 50;

using Head = std::array<unsigned char, BytesOfTitle + BytesOfCount>;

/** Whether a file is text: the zeros in numbers of a binary file are none. */
bool IsText(const Head& head)
{
  const std::string word = "solid";
  const auto begin = std::find_if(head.begin(), head.end() - static_cast<long>(word.size()),
    [](unsigned char c) { return std::isspace(c) == 0; });
  return std::equal(word.begin(), word.end(), begin,
           [](char expected, unsigned char c) { return std::tolower(c) == expected; }) &&
    std::find(head.begin(), head.end(), 0) == head.end();
}

} // namespace

std::string StlFile::FindMistake(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  Head head = {};
  file.read(reinterpret_cast<char*>(head.data()), head.size());
  if (!file || IsText(head))
  {
    return {};
  }
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < BytesOfCount; ++i) // the least byte comes first
  {
    count |= static_cast<std::uint64_t>(head[BytesOfTitle + i]) << 8 * i;
  }
  const std::uint64_t bytes = vtksys::SystemTools::FileLength(fileName) - head.size();
  const std::uint64_t whole = bytes / BytesOfTriangle;
  return count > whole ? "it holds " + std::to_string(whole) + " of the " + std::to_string(count) +
      " triangles that its head counts"
                       : "";
}
