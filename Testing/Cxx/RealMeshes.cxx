// SPDX-License-Identifier: BSD-3-Clause
#include "RealMeshes.h"

#include "OffReader.h"

#include <gtest/gtest.h>

carving::TriangleMesh ReadRealMesh(const std::string& name)
{
  OffMesh off;
  EXPECT_EQ(ReadOff(TOPOLOGYCARVING_MESHES "/" + name, off), "");
  carving::TriangleMesh mesh = { off.Points, {} };
  for (const std::vector<int>& face : off.Faces)
  {
    EXPECT_EQ(face.size(), 3u);
    mesh.Triangles.push_back({ face.at(0), face.at(1), face.at(2) });
  }
  return mesh;
}
