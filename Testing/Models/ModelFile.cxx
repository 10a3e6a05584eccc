// SPDX-License-Identifier: BSD-3-Clause
#include "ModelFile.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>

namespace models
{
namespace
{

bool EndsWith(const std::string& name, const std::string& end)
{
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

template <class Value>
void WriteBytes(std::ostream& out, const Value& value)
{
  out.write(reinterpret_cast<const char*>(&value), sizeof value);
}

/** Writes text from which every coordinate can be read again without loss. */
void WritePoints(std::ostream& out, const std::vector<carving::Point>& points)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  for (const carving::Point& p : points)
  {
    out << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
}

void WriteOff(std::ostream& out, const carving::TriangleMesh& mesh)
{
  out << "OFF\n" << mesh.Points.size() << " " << mesh.Triangles.size() << " 0\n";
  WritePoints(out, mesh.Points);
  for (const carving::Triangle& t : mesh.Triangles)
  {
    out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  }
}

void WritePly(std::ostream& out, const carving::TriangleMesh& mesh)
{
  const int one = 1;
  const bool isLittle = *reinterpret_cast<const char*>(&one) == 1;
  out << "ply\nformat binary_" << (isLittle ? "little" : "big") << "_endian 1.0\n"
      << "element vertex " << mesh.Points.size() << "\n"
      << "property double x\nproperty double y\nproperty double z\n"
      << "element face " << mesh.Triangles.size() << "\n"
      << "property list uchar int vertex_indices\nend_header\n";
  for (const carving::Point& p : mesh.Points)
  {
    WriteBytes(out, p);
  }
  for (const carving::Triangle& t : mesh.Triangles)
  {
    WriteBytes(out, static_cast<unsigned char>(t.size()));
    WriteBytes(out, t);
  }
}

void WriteVtk(std::ostream& out, const ContourModel& contour)
{
  out << "# vtk DataFile Version 3.0\ncontour\nASCII\nDATASET POLYDATA\nPOINTS "
      << contour.Points.size() << " double\n";
  WritePoints(out, contour.Points);
  out << "LINES " << contour.Edges.size() << " " << 3 * contour.Edges.size() << "\n";
  for (const auto& [a, b] : contour.Edges)
  {
    out << "2 " << a << " " << b << "\n";
  }
}

template <class Model>
std::string WriteWith(
  void (*write)(std::ostream&, const Model&), const std::string& fileName, const Model& model)
{
  errno = 0;
  std::ofstream out(fileName, std::ios::binary);
  if (out)
  {
    write(out, model);
    out.close();
  }
  return out ? "" : "cannot write " + fileName + ": " + std::strerror(errno);
}

} // namespace

std::string Write(const std::string& fileName, const carving::TriangleMesh& mesh)
{
  if (EndsWith(fileName, ".off"))
  {
    return WriteWith(WriteOff, fileName, mesh);
  }
  if (EndsWith(fileName, ".ply"))
  {
    return WriteWith(WritePly, fileName, mesh);
  }
  return "cannot write a mesh to " + fileName + ": its name must end in .ply or .off";
}

std::string Write(const std::string& fileName, const ContourModel& contour)
{
  if (EndsWith(fileName, ".vtk"))
  {
    return WriteWith(WriteVtk, fileName, contour);
  }
  return "cannot write a contour to " + fileName + ": its name must end in .vtk";
}

} // namespace models
