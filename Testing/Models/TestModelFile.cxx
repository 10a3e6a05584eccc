// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"
#include "ModelFile.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <unistd.h>

using namespace models;

namespace
{

/** The bytes of a file with the given extension. */
template <class Model>
std::string Written(const std::string& end, const Model& model)
{
  const std::string name = testing::TempDir() + "carving-model-" + std::to_string(getpid()) + end;
  EXPECT_EQ(Write(name, model), "");
  std::ifstream in(name, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(in), {} };
  std::remove(name.c_str());
  return bytes;
}

const TriangleMesh Mesh = { { { 0.1, 1.0 / 3.0, 0 }, { 1, 0, 0 }, { 0, 1, 1e-300 } },
  { { 0, 1, 2 } } };

} // namespace

// OFF has enough digits to read the same numbers again.
TEST(ModelFile, Off)
{
  EXPECT_EQ(Written(".off", Mesh),
    "OFF\n3 1 0\n0.10000000000000001 0.33333333333333331 0\n1 0 0\n0 1 1e-300\n"
    "3 0 1 2\n");
}

// Binary PLY ends with the bytes of the points and triangles.
TEST(ModelFile, Ply)
{
  const std::string bytes = Written(".ply", Mesh);
  const std::size_t headerSize = bytes.find("end_header\n") + std::strlen("end_header\n");
  ASSERT_EQ(bytes.size(), headerSize + sizeof(carving::Point) * 3 + 1 + sizeof(carving::Triangle));
  EXPECT_EQ(
    std::memcmp(bytes.data() + headerSize, Mesh.Points.data(), 3 * sizeof(carving::Point)), 0);
  EXPECT_NE(bytes.find("property double x\n"), std::string::npos);
}

// A contour is written as lines.
TEST(ModelFile, Vtk)
{
  const ContourModel contour = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0.5, 0 } },
    { { 0, 1 }, { 1, 2 }, { 2, 0 } } };
  EXPECT_EQ(Written(".vtk", contour),
    "# vtk DataFile Version 3.0\ncontour\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n"
    "0 0 0\n1 0 0\n0 0.5 0\nLINES 3 9\n2 0 1\n2 1 2\n2 2 0\n");
}

// Errors name the file.
TEST(ModelFile, Errors)
{
  EXPECT_EQ(
    Write("mesh.vtk", Mesh), "cannot write a mesh to mesh.vtk: its name must end in .ply or .off");
  EXPECT_EQ(Write("contour.ply", ContourModel()),
    "cannot write a contour to contour.ply: its name must end in .vtk");
  EXPECT_EQ(
    Write("/nowhere/mesh.off", Mesh), "cannot write /nowhere/mesh.off: No such file or directory");
}
