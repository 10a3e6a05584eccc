// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"
#include "Helper/Resolve/Intersections.h"
#include "Shapes.h"

#include <gtest/gtest.h>

using namespace carving::helper;
using namespace models;

// Any two triangles of a figure meet only in shared vertices and edges.
TEST(FigureModels, DoNotCrossThemselves)
{
  for (const TriangleMesh& mesh :
    { TwoSpheres(), EightSpheres(), YuccaLeaves(), Scone(), Ribs(), Tree(300), Tree() })
  {
    EXPECT_TRUE(FindIntersections(mesh.Points, mesh.Triangles).empty());
  }
}

// Bumps do not make a torus cross itself, however coarse it is.
TEST(ShapeModels, BumpyTorusDoesNotCrossItself)
{
  for (const int points : { 300, 1000, 3000, 30000 })
  {
    const TriangleMesh mesh = BumpyTorus(points);
    EXPECT_TRUE(FindIntersections(mesh.Points, mesh.Triangles).empty());
  }
}
