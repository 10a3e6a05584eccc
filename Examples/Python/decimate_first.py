#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Decimates a mesh without changing its topology, then carves it: coarse first in geometry, then in topology.

usage: decimate_first.py MESH.(ply|stl|obj|vtp) [SHARE]

SHARE of the triangles is removed first (default 0.8). This is what section 7 of the paper proposes for meshes
whose hull has much of their detail. It costs the guarantee: levels enclose the decimated mesh, and the hull of
that need not bound the given one. How far the given mesh sticks out is printed.
"""
import sys
import time

from topologycarving import vtkTopologyCarver
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkDecimatePro, vtkImplicitPolyDataDistance, vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

READERS = {"ply": vtkPLYReader, "stl": vtkSTLReader, "obj": vtkOBJReader, "vtp": vtkXMLPolyDataReader}


def read(name):
    reader = READERS[name.rsplit(".", 1)[-1].lower()]()
    reader.SetFileName(name)
    triangulate = vtkTriangleFilter()
    triangulate.SetInputConnection(reader.GetOutputPort())
    clean = vtkCleanPolyData()
    clean.SetInputConnection(triangulate.GetOutputPort())
    clean.Update()
    return clean.GetOutput()


def decimate(mesh, share):
    decimation = vtkDecimatePro()
    decimation.SetInputData(mesh)
    decimation.SetTargetReduction(share)
    decimation.PreserveTopologyOn()
    decimation.SplittingOff()
    decimation.BoundaryVertexDeletionOff()
    decimation.Update()
    return decimation.GetOutput()


def carve(mesh):
    carver = vtkTopologyCarver()
    carver.SetInputData(mesh)
    carver.Update()
    return carver


def greatest_distance_outside(mesh, level):
    """Of the mesh's vertices from the level, as a share of the mesh's diagonal."""
    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(level)
    points = mesh.GetPoints()
    farthest = max(distance.EvaluateFunction(points.GetPoint(i)) for i in range(points.GetNumberOfPoints()))
    return max(0.0, farthest) / mesh.GetLength()


def report(name, mesh, given, seconds):
    start = time.perf_counter()
    carver = carve(mesh)
    seconds += time.perf_counter() - start
    levels = carver.GetOutput()
    hull = levels.GetBlock(0)
    if levels.GetNumberOfBlocks() == 0 or hull is None:
        sys.exit(1)  # the carver has said why
    print(f"{name:17}{mesh.GetNumberOfPolys():10,}{hull.GetFieldData().GetArray('Vertices').GetValue(0):10,}"
          f"{carver.GetOutputDataObject(1).GetNumberOfCells() - mesh.GetNumberOfPolys():12,}{seconds:9.2f}"
          f"{100 * greatest_distance_outside(given, hull):12.3f} %")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    given = read(sys.argv[1])
    share = float(sys.argv[2]) if len(sys.argv) == 3 else 0.8
    print(f"{'':17}{'triangles':>10}{'hull':>10}{'tetrahedra':>12}{'seconds':>9}{'sticks out':>14}")
    report("carved", given, given, 0.0)
    start = time.perf_counter()
    decimated = decimate(given, share)
    report("decimated first", decimated, given, time.perf_counter() - start)
    print("Sticks out: the greatest distance of a given vertex from the outside of the hull level, in percent of\n"
          "the diagonal. After decimation it need not be 0: the decimated mesh's hull need not bound the given one.")


if __name__ == "__main__":
    main()
