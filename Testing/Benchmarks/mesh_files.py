# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as files that all compared programs read alike."""
import gzip
import os
import shutil

import numpy as np
from surfaces import read
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOPLY import vtkPLYWriter


def to_arrays(data):
    """The coordinates and the triangles."""
    return vtk_to_numpy(data.GetPoints().GetData()), vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def write_off(path, points, triangles):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        np.savetxt(file, points, "%.17g")
        np.savetxt(file, np.insert(triangles, 0, 3, axis=1), "%d")


def read_packed(path, folder):
    """Reads a surface, which can be gzipped."""
    if not path.endswith(".gz"):
        return read(path)
    unpacked = os.path.join(folder, os.path.basename(path)[:-len(".gz")])
    with gzip.open(path) as packed, open(unpacked, "wb") as file:
        shutil.copyfileobj(packed, file)
    return read(unpacked)


def write_plain(path, folder):
    """Writes the triangles of a surface, without arrays, as binary PLY and as OFF. Returns the names and the surface.

    The coordinates have single precision, as in VTK's PLY files, so that all programs get the same numbers.
    """
    triangles = vtkTriangleFilter()
    triangles.SetInputData(read_packed(path, folder))
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    triangles.Update()
    bare = vtkPolyData()
    bare.SetPoints(triangles.GetOutput().GetPoints())
    bare.SetPolys(triangles.GetOutput().GetPolys())
    ply, off = os.path.join(folder, "plain.ply"), os.path.join(folder, "plain.off")
    writer = vtkPLYWriter()
    writer.SetInputData(bare)
    writer.SetFileName(ply)
    writer.Write()
    surface = read(ply)
    write_off(off, *to_arrays(surface))
    return ply, off, surface
