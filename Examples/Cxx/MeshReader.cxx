// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReader.h"

#include "ErrorLog.h"
#include "FileName.h"
#include "ObjFile.h"
#include "OffReader.h"
#include "PlyFile.h"
#include "ReadCarefully.h"
#include "StlFile.h"
#include "System/TemporaryFile.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataReader.h"
#include "vtkSTLReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <fstream>
#include <map>
#include <vector>
#include <zlib.h>

namespace
{

template <class Reader>
std::string ReadWith(const std::string& fileName, ErrorLog* log, vtkPolyData* mesh)
{
  const std::size_t errorsBefore = log->Errors.size();
  vtkNew<Reader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  mesh->ShallowCopy(reader->GetOutput());
  return log->GetErrorSince(errorsBefore);
}

/** For readers that crash on many broken files. */
template <class Reader>
std::string ReadCarefullyWith(const std::string& fileName, ErrorLog* log, vtkPolyData* mesh)
{
  return ReadCarefully([&] { return ReadWith<Reader>(fileName, log, mesh); });
}

/** Reads a copy of a file, which `write` fills and `read` reads. */
template <class Write, class Read>
std::string ReadCopy(const Write& write, const Read& read)
{
  const TemporaryFile copy("carve-input");
  if (!copy.IsOpen())
  {
    return "no file for a copy could be opened in " + TemporaryFile::GetPlace();
  }
  std::ofstream out(copy.GetPath(), std::ios::binary);
  write(out);
  out.close();
  return out ? read(copy.GetPath())
             : "there is not enough room for a copy in " + TemporaryFile::GetPlace();
}

std::string ReadObj(const std::string& fileName, ErrorLog* log, vtkPolyData* mesh)
{
  const auto [mistake, isUnusual] = ObjFile::Check(fileName);
  if (mistake.empty() && !isUnusual)
  {
    return ReadWith<vtkOBJReader>(fileName, log, mesh);
  }
  if (!mistake.empty())
  {
    log->Warnings.push_back("Texture coordinates, normals and faces of fewer than three corners "
                            "are left out: " +
      mistake + ".");
  }
  const auto copyTo = mistake.empty() ? &ObjFile::Copy : &ObjFile::CopyWithoutAttributes;
  return ReadCopy([&](std::ostream& out) { copyTo(fileName, out); },
    [&](const std::string& copy) { return ReadWith<vtkOBJReader>(copy, log, mesh); });
}

std::string ReadPly(const std::string& fileName, ErrorLog* log, vtkPolyData* mesh)
{
  const std::string mistake = PlyFile::FindMistake(fileName);
  if (!mistake.empty())
  {
    return mistake;
  }
  const auto read = [&](const std::string& name)
  { return ReadCarefullyWith<vtkPLYReader>(name, log, mesh); };
  return PlyFile::EndsWithinALine(fileName)
    ? ReadCopy([&](std::ostream& out)
        { out << std::ifstream(fileName, std::ios::binary).rdbuf() << '\n'; },
        read)
    : read(fileName);
}

std::string ReadStl(const std::string& fileName, ErrorLog* log, vtkPolyData* mesh)
{
  const std::string mistake = StlFile::FindMistake(fileName);
  if (!mistake.empty())
  {
    // Some programs write wrong counts.
    log->Warnings.push_back("The file may end early: " + mistake + ".");
  }
  return ReadWith<vtkSTLReader>(fileName, log, mesh);
}

std::string ReadOffAsPolyData(const std::string& fileName, ErrorLog*, vtkPolyData* mesh)
{
  OffMesh off;
  const std::string error = ReadOff(fileName, off);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : off.Points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> faces;
  for (const std::vector<int>& face : off.Faces)
  {
    faces->InsertNextCell(static_cast<int>(face.size()));
    for (const int corner : face)
    {
      faces->InsertCellPoint(corner);
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(faces);
  return error;
}

std::string ReadFormat(
  const std::string& fileName, const std::string& extension, ErrorLog* log, vtkPolyData* mesh)
{
  using Read = std::string (*)(const std::string& fileName, ErrorLog* log, vtkPolyData* mesh);
  const std::map<std::string, Read> formats = { { ".obj", &ReadObj },
    { ".off", &ReadOffAsPolyData }, { ".ply", &ReadPly }, { ".stl", &ReadStl },
    { ".vtp", &ReadWith<vtkXMLPolyDataReader> },
    { ".vtk", &ReadCarefullyWith<vtkPolyDataReader> } };
  const auto format = formats.find(extension);
  if (format == formats.end())
  {
    return "the format " + (extension.empty() ? "without an ending" : extension) +
      " is not known; known are .obj, .ply, .stl, .off, .vtp and .vtk, each also with .gz, "
      "and .vtm, .vtpc, .glb and .gltf";
  }
  return format->second(fileName, log, mesh);
}

/** Replaces all characters beyond ASCII, since names can have any encoding, but XML needs UTF-8. */
void MakeNamesReadable(vtkFieldData* arrays)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    std::string name = array->GetName() ? array->GetName() : "";
    const std::string given = name;
    std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '_');
    if (name != given)
    {
      array->SetName(name.c_str());
    }
  }
}

/** Unpacks a gzipped file; a plain file stays as it is. */
std::string Unpack(const std::string& fileName, const std::string& unpacked)
{
  gzFile in = gzopen(fileName.c_str(), "rb");
  std::ofstream out(unpacked, std::ios::binary);
  std::vector<char> chunk(1 << 20);
  int length = 0;
  while (in && (length = gzread(in, chunk.data(), static_cast<unsigned int>(chunk.size()))) > 0)
  {
    out.write(chunk.data(), length);
  }
  const bool good = in && gzclose(in) == Z_OK && length == 0;
  out.close();
  return !good ? "it is not a whole gzip file"
    : !out     ? "there is not enough room for it in " + TemporaryFile::GetPlace()
               : "";
}

/** Reads a gzipped file. VTK's readers need the name of a plain file, a temporary one here. */
std::string ReadPacked(
  const std::string& fileName, const std::string& extension, ErrorLog* log, vtkPolyData* mesh)
{
  const TemporaryFile unpacked("carve-input");
  if (!unpacked.IsOpen())
  {
    return "no file could be opened in " + TemporaryFile::GetPlace();
  }
  const std::string error = Unpack(fileName, unpacked.GetPath());
  return error.empty() ? ReadFormat(unpacked.GetPath(), extension, log, mesh) : error;
}

} // namespace

std::string CheckFile(const std::string& fileName)
{
  using vtksys::SystemTools;
  if (!SystemTools::FileExists(fileName))
  {
    return "there is no such file";
  }
  return SystemTools::FileExists(fileName, true) &&
      SystemTools::TestFileAccess(fileName, vtksys::TEST_FILE_READ)
    ? ""
    : "it is not a readable file";
}

std::string CheckCells(const std::vector<vtkPolyData*>& meshes, Wanted wanted)
{
  const auto any = [&meshes](const auto& predicate)
  { return std::any_of(meshes.begin(), meshes.end(), predicate); };
  const bool hasLines = any([](vtkPolyData* mesh) { return mesh->GetNumberOfLines() > 0; });
  const bool hasPolygons = any([](vtkPolyData* mesh)
    { return mesh->GetNumberOfPolys() > 0 || mesh->GetNumberOfStrips() > 0; });
  if (hasPolygons || (hasLines && wanted == Wanted::Contours))
  {
    return {};
  }
  return hasLines ? "it holds lines and no polygon; for contours in a plane there is --contours"
                  : "it contains no polygon, or is not of the format that its name says";
}

std::string ReadMesh(const std::string& fileName, Wanted wanted, ErrorLog* log, vtkPolyData* mesh)
{
  std::string error = CheckFile(fileName);
  if (!error.empty())
  {
    return error;
  }
  const std::size_t warningsBefore = log->Warnings.size();
  const std::string extension = FileName::GetExtension(fileName);
  error = extension == ".gz"
    ? ReadPacked(fileName, FileName::GetExtension(FileName::WithoutExtension(fileName)), log, mesh)
    : ReadFormat(fileName, extension, log, mesh);
  std::for_each(log->Warnings.begin() + warningsBefore, log->Warnings.end(),
    [&](std::string& warning) { warning = fileName + ": " + warning; });
  MakeNamesReadable(mesh->GetPointData());
  MakeNamesReadable(mesh->GetCellData());
  MakeNamesReadable(mesh->GetFieldData());
  return error.empty() ? CheckCells({ mesh }, wanted) : error;
}
