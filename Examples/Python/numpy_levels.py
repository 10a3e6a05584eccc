#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Carve a mesh that is given as numpy arrays, and get the levels as numpy arrays.

usage: numpy_levels.py

The example carves two cubes of 16 vertices and prints the size of each level.
"""
import numpy as np
from topologycarving import vtkTopologyCarver
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def to_polydata(points, triangles):
    """A mesh of points (n x 3 floats) and triangles (m x 3 indices of points)."""
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles, np.int64).ravel(), deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    mesh.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    mesh.SetPolys(cells)
    return mesh


def to_arrays(mesh):
    """The points and triangles of a level, as copies."""
    points = vtk_to_numpy(mesh.GetPoints().GetData()).copy()
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3).copy()
    return points, triangles


def carve(points, triangles, number_of_levels=8):
    """The levels from the hull to the mesh, each as points and triangles."""
    carver = vtkTopologyCarver()
    carver.SetInputDataObject(0, to_polydata(points, triangles))
    carver.SetNumberOfLevels(number_of_levels)
    carver.Update()
    levels = carver.GetOutput()
    return [to_arrays(levels.GetBlock(i)) for i in range(levels.GetNumberOfBlocks())]


def two_cubes():
    """The points and triangles of two unit cubes with a unit gap."""
    cube = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    faces = np.array([(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
                      (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)])
    return np.vstack([cube, cube + (2, 0, 0)]), np.vstack([faces, faces + len(cube)])


if __name__ == "__main__":
    for level, (level_points, level_triangles) in enumerate(carve(*two_cubes())):
        print(f"level {level}: {len(level_points)} points, {len(level_triangles)} triangles")
