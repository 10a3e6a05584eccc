#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Decimate a mesh without changing its topology, then carve the decimated mesh.

usage: decimate_first.py MESH.(ply|stl|obj|vtp) [SHARE]

The decimation removes SHARE of the triangles (default 0.8). Section 7 of the paper proposes this for meshes whose hull
has much of their detail. The price is the guarantee: levels enclose the decimated mesh, and its hull need not bound the
given mesh. The script prints how far the given mesh sticks out.
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
    """The greatest distance of a vertex of the mesh outside the level, as a share of the mesh's diagonal."""
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
        sys.exit(1)  # the carver has reported the reason
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
    print("Sticks out: the greatest distance of a given vertex outside the hull, in percent of the diagonal. After\n"
          "decimation, it may exceed 0: the hull of the decimated mesh need not bound the given mesh.")


if __name__ == "__main__":
    main()
