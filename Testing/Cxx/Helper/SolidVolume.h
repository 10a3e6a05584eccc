// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The volume of a solid.
 */
#ifndef SolidVolume_h
#define SolidVolume_h

#include "Core/Mesh/CellGeometry.h"
#include "Core/Solid/Classification.h"

/** The volume of the cells that are solid or kept. */
inline double VolumeOfSolid(
  const carving::Tetrahedralization& mesh, const carving::Classification& regions)
{
  double volume = 0.0;
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    const carving::RegionKind kind = regions.Kind(cell);
    const bool isInside = kind == carving::RegionKind::Solid || kind == carving::RegionKind::Kept;
    volume += isInside ? carving::Size(CornersOfCell(mesh, cell)) : 0.0;
  }
  return volume;
}

#endif
