// SPDX-License-Identifier: BSD-3-Clause
#include "OffReader.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

namespace
{

/**
 * Finds the next line with content other than white space and a comment. Returns false at the end.
 */
bool NextLine(std::istream& in, std::istringstream& line)
{
  for (std::string text; std::getline(in, text);)
  {
    text.erase(std::min(text.find('#'), text.size()));
    if (text.find_first_not_of(" \t\r") != std::string::npos)
    {
      line.clear();
      line.str(text);
      return true;
    }
  }
  return false;
}

} // namespace

std::string ReadOff(const std::string& fileName, OffMesh& mesh)
{
  mesh = {};
  std::ifstream in(fileName);
  std::istringstream line;
  std::string header;
  // Texture coordinates, colors and normals, which the letters announce, follow the coordinates.
  if (!NextLine(in, line) || !(line >> header) ||
    !std::regex_match(header, std::regex("(\xEF\xBB\xBF)?(ST)?C?N?OFF")))
  {
    return "it does not begin with OFF, or is not in space";
  }
  if (line.str().find("BINARY") != std::string::npos)
  {
    return "it is binary: save it as text";
  }
  // The counts may follow on the header's line.
  long long numberOfPoints = -1, numberOfFaces = -1;
  if (!(line >> numberOfPoints) && !(NextLine(in, line) && line >> numberOfPoints))
  {
    return "the number of points is missing";
  }
  if (!(line >> numberOfFaces) || numberOfPoints < 0 || numberOfFaces < 0)
  {
    return "the numbers of points and faces are missing or negative";
  }
  for (long long i = 0; i < numberOfPoints; ++i)
  {
    std::array<double, 3> p;
    if (!NextLine(in, line) || !(line >> p[0] >> p[1] >> p[2]))
    {
      return "point " + std::to_string(i) + " is missing or not three numbers";
    }
    mesh.Points.push_back(p);
  }
  for (long long i = 0; i < numberOfFaces; ++i)
  {
    int size = 0;
    if (!NextLine(in, line) || !(line >> size) || size < 0)
    {
      return "face " + std::to_string(i) + " is missing";
    }
    std::vector<int>& face = mesh.Faces.emplace_back();
    for (int k = 0; k < size; ++k)
    {
      long long corner = -1;
      if (!(line >> corner))
      {
        return "face " + std::to_string(i) + " has fewer corners than its first number says";
      }
      if (corner < 0 || corner >= numberOfPoints)
      {
        return "face " + std::to_string(i) + " refers to point " + std::to_string(corner) +
          ", which does not exist";
      }
      face.push_back(static_cast<int>(corner));
    }
  }
  return {};
}
