// SPDX-License-Identifier: BSD-3-Clause
#include "Level.h"

#include "Faces.h"

namespace carving
{

Level ExtractLevel(const Tetrahedralization& mesh, const Stream& stream, int step)
{
  Level level;
  ForEachFace(mesh, stream,
    [&](const FaceLife& face)
    {
      if (step < face.Birth || step >= face.Death)
      {
        return;
      }
      Triangle triangle;
      int behind = -1;
      if (stream.Step[face.Cell] > step)
      {
        behind = face.Cell;
        triangle = mesh.OutwardFace(face.Cell, face.Corner);
      }
      else if (face.Neighbor >= 0 && stream.Step[face.Neighbor] > step)
      {
        behind = face.Neighbor;
        triangle = mesh.OutwardFace(face.Cell, face.Corner);
        std::swap(triangle[1], triangle[2]);
      }
      else
      {
        triangle = mesh.Surface.Triangles[face.Constraint];
      }
      level.Triangles.push_back(triangle);
      level.Constraints.push_back(face.Constraint);
      level.CellsBehind.push_back(behind);
    });
  return level;
}

} // namespace carving
