# SPDX-License-Identifier: BSD-3-Clause
"""Reading, measuring and decimating surfaces, for the scripts that render pictures."""
import os
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import (
    vtkPolyDataConnectivityFilter,
    vtkQuadricClustering,
    vtkQuadricDecimation,
)
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOPLY import vtkPLYReader

READERS = {".ply": vtkPLYReader, ".obj": vtkOBJReader, ".stl": vtkSTLReader, ".vtk": vtkPolyDataReader}


def read_off(path):
    """Reads a mesh of triangles from an OFF file, which VTK 9.1 cannot read."""
    with open(path, encoding="ascii") as file:
        lines = (line.split("#")[0] for line in file)
        words = " ".join(lines).split()
    if words[0] != "OFF":
        sys.exit(f"{path} is not an OFF file")
    point_count, face_count = int(words[1]), int(words[2])
    split = 4 + 3 * point_count
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(numpy.array(words[4:split], float).reshape(-1, 3), deep=True))
    faces = numpy.array(words[split:split + 4 * face_count], numpy.int64)
    if len(faces) != 4 * face_count or (faces[::4] != 3).any():
        sys.exit(f"{path} has faces that are not triangles")
    cells = vtkCellArray()
    cells.SetCells(face_count, numpy_to_vtkIdTypeArray(faces, deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    return mesh


def read(path):
    extension = os.path.splitext(path)[1].lower()
    if extension == ".off":
        return read_off(path)
    if extension not in READERS:
        sys.exit(f"{path} has none of the extensions .off {' '.join(READERS)}")
    reader = READERS[extension]()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def topology(surface):
    """The components and the genus of a surface, by its point ids. The genus is None if the surface is not closed."""
    connectivity = vtkPolyDataConnectivityFilter()
    connectivity.SetInputData(surface)
    connectivity.SetExtractionModeToAllRegions()
    connectivity.Update()
    components = connectivity.GetNumberOfExtractedRegions()
    faces = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    ends = numpy.sort(numpy.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    edges, uses = numpy.unique(ends, axis=0, return_counts=True)
    if (uses != 2).any():
        return components, None
    characteristic = len(numpy.unique(faces)) - len(edges) + len(faces)
    return components, (2 * components - characteristic) // 2


def decimated(mesh, triangles):
    filter_ = vtkQuadricDecimation()
    filter_.SetInputData(mesh)
    filter_.SetTargetReduction(1 - triangles / mesh.GetNumberOfPolys())
    filter_.Update()
    return filter_.GetOutput()


def clustered(mesh, triangles):
    """Clusters vertices in cubes of a size for which the number of triangles is closest to the given one."""
    bounds = numpy.array(mesh.GetBounds()).reshape(3, 2)
    size = bounds[:, 1] - bounds[:, 0]
    best = None
    for divisions in range(4, 100):
        filter_ = vtkQuadricClustering()
        filter_.SetInputData(mesh)
        filter_.AutoAdjustNumberOfDivisionsOff()
        filter_.SetNumberOfDivisions(*[int(n) for n in numpy.ceil(size / max(size) * divisions)])
        filter_.Update()
        result = filter_.GetOutput()
        if best is None or (abs(result.GetNumberOfPolys() - triangles)
                            < abs(best.GetNumberOfPolys() - triangles)):
            best = result
        if result.GetNumberOfPolys() > 2 * triangles:
            break
    return best
