# SPDX-License-Identifier: BSD-3-Clause
"""Meshes that several Python tests use."""
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource


def two_cubes():
    """A filter whose output is two unit cubes with a unit gap between them."""
    append = vtkAppendPolyData()
    for x in (0, 2):
        cube = vtkCubeSource()
        cube.SetCenter(x, 0, 0)
        append.AddInputConnection(cube.GetOutputPort())
    return append
