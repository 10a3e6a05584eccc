# SPDX-License-Identifier: BSD-3-Clause
"""Carving gives the same result in any number of processes.

The expected numbers are those of a single process that reads the same files. With one process, the script is
therefore its own reference.
"""
import os
import unittest

import scene
from paraview import simple
from scene import ALL_LEVELS, LEVEL, MODELS, PROFILE, STREAM, counts, numbers

POINTS, TRIANGLES = 8 * 642, 8 * 1280

# Gives each process its part of a mesh, or its blocks.
SPREAD = """
import os
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
count, rank = controller.GetNumberOfProcesses(), controller.GetLocalProcessId()

def read(name):
    reader = vtkPLYReader()
    reader.SetFileName(os.path.join({folder!r}, name))
    reader.Update()
    return reader.GetOutput()

def part(mesh):
    result, polys = vtkPolyData(), vtkCellArray()
    result.SetPoints(mesh.GetPoints())
    total = mesh.GetNumberOfCells()
    for i in range(total * rank // count, total * (rank + 1) // count):
        polys.InsertNextCell(mesh.GetCell(i).GetPointIds())
    result.SetPolys(polys)
    return result

output = self.GetOutputDataObject(0)
"""
MESH_IN_PARTS = SPREAD + """
output.ShallowCopy(part(read("eight-spheres.ply")))
"""
BLOCKS = SPREAD + """
names = ["eight-spheres.ply", "two-spheres.ply", "eight-spheres.ply"]
output.SetNumberOfBlocks(len(names))
for i, name in enumerate(names):
    if i % count == rank:
        output.SetBlock(i, read(name))
    output.GetMetaData(i).Set(output.NAME(), "block %d" % i)
"""

MESH_ON_LAST = SPREAD + """
if rank == count - 1:
    output.ShallowCopy(read("two-spheres.ply"))
"""
# Outputs one point on each process that knows the range of the stream's vertices.
CHECK_RANGES = """
from vtkmodules.vtkCommonCore import vtkPoints
ranges = self.GetInputDataObject(0, 0).GetFieldData().GetArray("TargetRanges")
points = vtkPoints()
if ranges and ranges.GetNumberOfTuples() == 7 and ranges.GetTuple(0)[:2] == ({least}, {greatest}):
    points.InsertNextPoint(0, 0, 0)
self.GetOutputDataObject(0).SetPoints(points)
"""


def make_source(script, kind):
    return simple.ProgrammableSource(
        Script=script.format(folder=MODELS), OutputDataSetType=kind)


class TestParallel(unittest.TestCase):
    def setUp(self):
        self.addCleanup(simple.ResetSession)

    def expect_whole(self, carver, points=POINTS, triangles=TRIANGLES):
        carver.FollowTime = 1
        first = counts(carver, LEVEL, 0)
        self.assertLess(first[0], points)
        self.assertEqual(counts(carver, LEVEL, 49), (points, triangles))
        return first

    def test_mesh_on_one_process(self):
        """A mesh that a serial reader leaves on one process is carved there, without messages from the others."""
        carver = simple.TopologyCarver(Input=scene.open_model("eight-spheres.ply"))
        first = self.expect_whole(carver)
        self.assertEqual(numbers(carver, "VertexRange"), [first[0], POINTS])
        rows = simple.OutputPort(carver, PROFILE).GetDataInformation().GetNumberOfRows()
        self.assertEqual(rows, numbers(carver, "StepRange")[1] + 1)

    def test_spread_mesh_is_carved_whole(self):
        """A mesh that is spread over all processes gives the same levels, without seams."""
        whole = simple.TopologyCarver(Input=scene.open_model("eight-spheres.ply"), FollowTime=1)
        parts = simple.TopologyCarver(Input=make_source(MESH_IN_PARTS, "vtkPolyData"), FollowTime=1)
        for time in (0, 11, 33, 49):
            self.assertEqual(counts(parts, LEVEL, time), counts(whole, LEVEL, time))

    def test_blocks_are_carved_whole(self):
        """Each block is carved whole by one process, and all processes have the same tree."""
        carver = simple.TopologyCarver(Input=make_source(BLOCKS, "vtkMultiblockDataSet"))
        self.expect_whole(carver, 2 * POINTS + 2 * 642, 2 * TRIANGLES + 2 * 1280)
        names = ["block 0", "block 1", "block 2"]
        for port in range(4):
            information = simple.OutputPort(carver, port).GetDataInformation()
            hierarchy = information.GetHierarchy()
            children = hierarchy.GetChildNodes(hierarchy.GetRootNode(), False)
            found = [hierarchy.GetAttributeOrDefault(child, "label", "") for child in children]
            self.assertEqual(found, names)
            if port == ALL_LEVELS:
                for child in children:
                    self.assertEqual(hierarchy.GetNumberOfChildren(child), 8)
        extract = simple.ExtractCarvedLOD(Input=simple.OutputPort(carver, STREAM), FollowTime=1)
        for time in (0, 20, 49):
            self.assertEqual(counts(extract, 0, time), counts(carver, LEVEL, time))

    def test_ranges_reach_all_processes(self):
        """Processes without the stream know the ranges of its targets."""
        carver = simple.TopologyCarver(Input=make_source(MESH_ON_LAST, "vtkPolyData"), FollowTime=1)
        least, greatest = counts(carver, LEVEL, 0)[0], 2 * 642
        check = simple.ProgrammableFilter(
            Input=simple.OutputPort(carver, STREAM), Script=CHECK_RANGES.format(least=least, greatest=greatest),
            OutputDataSetType="vtkPolyData")
        processes = simple.servermanager.ActiveConnection.GetNumberOfDataPartitions()
        self.assertEqual(counts(check)[0], processes)
        self.assertEqual(numbers(carver, "VertexRange"), [least, greatest])

    def test_changing_the_level_does_not_gather_again(self):
        """Choosing another level of a mesh in parts does not run the helper program."""
        carver = simple.TopologyCarver(Input=make_source(MESH_IN_PARTS, "vtkPolyData"))
        self.expect_whole(carver)
        os.environ["TOPOLOGYCARVING_HELPER"] = "/bin/false"
        self.addCleanup(os.environ.pop, "TOPOLOGYCARVING_HELPER")
        carver.FollowTime, carver.LevelBy, carver.Step = 0, "Step", 0
        self.assertLess(counts(carver)[0], POINTS)


scene.run_tests(unittest)
