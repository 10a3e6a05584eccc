// SPDX-License-Identifier: BSD-3-Clause
#include "LevelWriter.h"

#include "ErrorLog.h"
#include "MeshReader.h"
#include "XmlFile.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkTopologyCarver.h"
#include "vtksys/SystemTools.hxx"

#include <fstream>

namespace
{

std::string GetExtension(const std::string& fileName)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(fileName));
}

template <class Writer>
bool WriteWith(const std::string& fileName, vtkDataObject* data)
{
  vtkNew<Writer> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(data);
  return writer->Write() != 0 && writer->GetErrorCode() == 0;
}

/** Checks the file's size, since the writer does not notice a full disk. */
bool WritePly(const std::string& fileName, vtkPolyData* level)
{
  if (!WriteWith<vtkPLYWriter>(fileName, level))
  {
    return false;
  }
  std::ifstream file(fileName, std::ios::binary | std::ios::ate);
  const vtkIdType size = static_cast<vtkIdType>(file.tellg());
  file.seekg(0);
  vtkIdType floatsOfPoint = 0;
  std::string line;
  while (size > 0 && std::getline(file, line) && line != "end_header")
  {
    floatsOfPoint += line.find("property float ") == 0;
  }
  constexpr vtkIdType sizeOfTriangle = 1 + 3 * 4;
  const vtkIdType expected = static_cast<vtkIdType>(file.tellg()) +
    4 * floatsOfPoint * level->GetNumberOfPoints() + sizeOfTriangle * level->GetNumberOfPolys();
  return file && size == expected;
}

/**
 * Counts the whole lines with a triangle, for the same reason. They are the last ones of the file.
 */
bool WriteObj(const std::string& fileName, vtkPolyData* level)
{
  if (!WriteWith<vtkOBJWriter>(fileName, level))
  {
    return false;
  }
  std::ifstream file(fileName, std::ios::binary | std::ios::ate);
  const bool hasContent = file.tellg() > 0; // a device can have no size, but endless content
  file.seekg(0);
  vtkIdType triangles = 0;
  for (std::string line; hasContent && std::getline(file, line);)
  {
    triangles += line.find("f ") == 0 && !file.eof();
  }
  return triangles == level->GetNumberOfPolys();
}

bool WriteLevel(const std::string& fileName, const std::string& extension, vtkPolyData* level)
{
  return extension == ".vtp" ? XmlFile::Write(fileName, level)
    : extension == ".ply"    ? WritePly(fileName, level)
    : extension == ".obj"    ? WriteObj(fileName, level)
                             : WriteWith<vtkSTLWriter>(fileName, level);
}

/**
 * Reads a written level again and counts the pairs of triangles that cross each other. `error` says
 * why that fails: then the level has not been written in full.
 */
int CountCrossings(const std::string& fileName, ErrorLog* log, std::string& error)
{
  vtkNew<vtkPolyData> mesh;
  error = ReadMesh(fileName, Wanted::Polygons, log, mesh);
  if (!error.empty())
  {
    return 0;
  }
  vtkNew<vtkTopologyCarver> carver;
  const int count = carver->CountIntersectingPairs(mesh);
  error = count < 0 ? log->Errors.back() : "";
  return count;
}

} // namespace

namespace LevelWriter
{

std::string CheckName(const std::string& fileName)
{
  const std::string extension = GetExtension(fileName);
  for (const char* known : { ".vtm", ".vtp", ".ply", ".obj", ".stl" })
  {
    if (extension == known)
    {
      return {};
    }
  }
  return "levels cannot be written to \"" + fileName +
    "\": its name must end in .vtm, .vtp, .ply, .obj or .stl";
}

std::string Write(const std::string& fileName, vtkMultiBlockDataSet* levels, ErrorLog* log,
  std::vector<std::string>& written, std::vector<std::string>& warnings)
{
  const std::string extension = GetExtension(fileName);
  const std::string failure = "cannot write ";
  if (extension == ".vtm")
  {
    written.push_back(fileName);
    return XmlFile::Write(fileName, levels) ? "" : failure + fileName;
  }
  const std::string stem = fileName.substr(0, fileName.size() - extension.size());
  for (unsigned int i = 0; i < levels->GetNumberOfBlocks(); ++i)
  {
    const std::string levelName = stem + "_" + std::to_string(i) + extension;
    auto* level = vtkPolyData::SafeDownCast(levels->GetBlock(i));
    if (!WriteLevel(levelName, extension, level))
    {
      return failure + levelName;
    }
    written.push_back(levelName);
    if (extension == ".vtp")
    {
      continue; // keeps doubles
    }
    std::string unreadable;
    const int crossings = CountCrossings(levelName, log, unreadable);
    if (!unreadable.empty())
    {
      return failure + levelName + " (read again: " + unreadable + ")";
    }
    if (crossings > 0)
    {
      warnings.push_back(levelName + ": rounding to the format's precision makes " +
        std::to_string(crossings) +
        " pairs of triangles cross each other; .vtp and .vtm keep doubles");
    }
  }
  return {};
}

} // namespace LevelWriter
