// SPDX-License-Identifier: BSD-3-Clause
#include "LevelWriter.h"

#include "ErrorLog.h"
#include "FileName.h"
#include "GltfReader.h"
#include "GltfWriter.h"
#include "MeshReader.h"
#include "Objects.h"
#include "XmlFile.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkTopologyCarver.h"

#include <algorithm>
#include <fstream>

namespace
{

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

/** Counts the pairs of triangles that cross each other. Returns an empty string, or an error. */
std::string CountCrossings(vtkPolyData* level, ErrorLog* log, int& count)
{
  vtkNew<vtkTopologyCarver> carver;
  count = carver->CountIntersectingPairs(level);
  return count < 0 ? log->Errors.back() : "";
}

std::string DescribeCrossings(const std::string& level, int count)
{
  return level + ": rounding to the format's precision makes " + std::to_string(count) +
    " pairs of triangles cross each other; .vtp, .vtm and .vtpc keep doubles";
}

/** Reads a written level again, since that shows whether it has been written in full. */
std::string CheckLevel(
  const std::string& fileName, ErrorLog* log, std::vector<std::string>& warnings)
{
  vtkNew<vtkPolyData> mesh;
  std::string error = ReadMesh(fileName, Wanted::Polygons, log, mesh);
  int count = 0;
  error = error.empty() ? CountCrossings(mesh, log, count) : error;
  if (count > 0)
  {
    warnings.push_back(DescribeCrossings(fileName, count));
  }
  return error;
}

/** Does the same for all levels of a glTF file. */
std::string CheckGltf(
  const std::string& fileName, ErrorLog* log, std::vector<std::string>& warnings)
{
  vtkNew<vtkMultiBlockDataSet> levels;
  std::string error = GltfReader::Read(fileName, log, levels);
  for (unsigned int i = 0; i < levels->GetNumberOfBlocks() && error.empty(); ++i)
  {
    int count = 0;
    error = CountCrossings(vtkPolyData::SafeDownCast(levels->GetBlock(i)), log, count);
    if (count > 0)
    {
      warnings.push_back(DescribeCrossings(fileName + ", " + GetBlockName(levels, i), count));
    }
  }
  return error;
}

std::string WriteGltf(const std::string& fileName, vtkMultiBlockDataSet* levels, ErrorLog* log,
  std::vector<std::string>& warnings)
{
  const std::string error = GltfWriter::Write(fileName, levels);
  return error.empty() ? CheckGltf(fileName, log, warnings) : error;
}

std::string WriteLevels(const std::string& fileName, vtkMultiBlockDataSet* levels, ErrorLog* log,
  std::vector<std::string>& written, std::vector<std::string>& warnings)
{
  const std::string extension = FileName::GetExtension(fileName);
  for (unsigned int i = 0; i < levels->GetNumberOfBlocks(); ++i)
  {
    const std::string levelName =
      FileName::WithoutExtension(fileName) + "_" + std::to_string(i) + extension;
    auto* level = vtkPolyData::SafeDownCast(levels->GetBlock(i));
    if (!WriteLevel(levelName, extension, level))
    {
      return levelName;
    }
    written.push_back(levelName);
    const std::string error =
      extension == ".vtp" ? "" : CheckLevel(levelName, log, warnings); // .vtp keeps doubles
    if (!error.empty())
    {
      return levelName + " (read again with the format's precision: " + error + ")";
    }
  }
  return {};
}

/** The formats, with what they hold. */
struct Format
{
  std::string Extension;
  bool SeveralMeshes;
  bool Lines;
};
const Format formats[] = { { ".vtm", true, true }, { ".vtpc", true, true }, { ".glb", true, false },
  { ".vtp", false, true }, { ".ply", false, false }, { ".obj", false, false },
  { ".stl", false, false } };

/** Null for an unknown format. */
const Format* FindFormat(const std::string& extension)
{
  const auto* found = std::find_if(std::begin(formats), std::end(formats),
    [&](const Format& format) { return format.Extension == extension; });
  return found != std::end(formats) ? found : nullptr;
}

} // namespace

std::string LevelWriter::CheckFormat(const std::string& extension, const std::string& where)
{
  if (extension == ".vtkhdf")
  {
    return "levels cannot be written to \"" + where +
      "\": VTK writes .vtkhdf from version 9.4 on only; .vtpc and .vtm have the same content";
  }
  return FindFormat(extension) ? ""
                               : "levels cannot be written to \"" + where +
      "\": the format must be .vtm, .vtpc, .glb, .vtp, .ply, .obj or .stl";
}

bool LevelWriter::HoldsSeveralMeshes(const std::string& extension)
{
  const Format* format = FindFormat(extension);
  return format && format->SeveralMeshes;
}

bool LevelWriter::HoldsLines(const std::string& extension)
{
  const Format* format = FindFormat(extension);
  return format && format->Lines;
}

std::string LevelWriter::Write(const std::string& fileName, vtkMultiBlockDataSet* levels,
  ErrorLog* log, std::vector<std::string>& written, std::vector<std::string>& warnings)
{
  const std::string extension = FileName::GetExtension(fileName);
  std::string failure;
  if (!HoldsSeveralMeshes(extension))
  {
    failure = WriteLevels(fileName, levels, log, written, warnings);
  }
  else if (extension == ".glb")
  {
    failure = WriteGltf(fileName, levels, log, warnings);
    failure = failure.empty() ? "" : fileName + " (" + failure + ")";
    written.push_back(fileName);
  }
  else
  {
    failure = XmlFile::Write(fileName, levels) ? "" : fileName;
    written.push_back(fileName);
  }
  return failure.empty() ? "" : "cannot write " + failure;
}
