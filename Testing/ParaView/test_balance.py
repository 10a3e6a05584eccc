# SPDX-License-Identifier: BSD-3-Clause
"""The objects of a scene are spread over the processes, wherever a reader has left them."""
import math
import unittest

import scene
from paraview import simple
from scene import ALL_LEVELS, LEVEL, PROFILE, STREAM, counts

# A scene of pairs of spheres. OWNER is the process that has an object at first.
SCENE = """
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
count, rank = controller.GetNumberOfProcesses(), controller.GetLocalProcessId()

def pair(resolution):
    append = vtkAppendPolyData()
    for x in (0, 2):
        sphere = vtkSphereSource()
        sphere.SetCenter(x, 0.1 * x, 0)
        sphere.SetThetaResolution(resolution)
        sphere.SetPhiResolution(resolution)
        append.AddInputConnection(sphere.GetOutputPort())
    append.Update()
    return append.GetOutput()

output = self.GetOutputDataObject(0)
output.SetNumberOfBlocks({number})
for i in range({number}):
    if rank == {owner}:
        mesh = pair(5 + i % 8)
        mark = vtkDoubleArray()
        mark.SetName("Mark")
        mark.InsertNextValue(i)
        mesh.GetFieldData().AddArray(mark)
        output.SetBlock(i, mesh)
    output.GetMetaData(i).Set(output.NAME(), "object %d" % i)
"""

# Outputs one point on each process whose tree has all names, whose streams are those of the objects that their field data
# name, and whose objects have its share of the cells of the scene.
CHECK = """
import math
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkParallelCore import vtkMultiProcessController
count = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
tree = self.GetInputDataObject(0, 0)
names = [tree.GetMetaData(i).Get(tree.NAME()) for i in range(tree.GetNumberOfBlocks())]
cells = [4 * n * (n - 2) for n in (5 + i % 8 for i in range({number}))]
here = [tree.GetBlock(i) for i in range(len(names))]
mine = [i for i, grid in enumerate(here) if grid and grid.GetNumberOfCells() > 0]
marked = [i for i in mine if here[i].GetFieldData().GetArray("Mark").GetTuple1(0) == i]
share = math.fsum(cells[i] for i in mine) * count / math.fsum(cells)
points = vtkPoints()
if names == ["object %d" % i for i in range({number})] and marked == mine and math.fabs(share - 1.0) <= {slack}:
    points.InsertNextPoint(share, 0, 0)
self.GetOutputDataObject(0).SetPoints(points)
"""


def carve_scene(number, owner):
    source = simple.ProgrammableSource(
        Script=SCENE.format(number=number, owner=owner), OutputDataSetType="vtkMultiblockDataSet")
    return simple.TopologyCarver(Input=source, FollowTime=1)


def expected_counts(number):
    """Points and triangles of all spheres: closed surfaces of n columns and n rows, two of which are poles."""
    sizes = [5 + i % 8 for i in range(number)]
    # Programmable filters replace the builtin functions sum and abs.
    return math.fsum(2 * (n * (n - 2) + 2) for n in sizes), math.fsum(4 * n * (n - 2) for n in sizes)


class TestBalance(unittest.TestCase):
    def setUp(self):
        self.addCleanup(simple.ResetSession)

    def test_scene_of_one_process_is_spread(self):
        """All processes carve about as many cells, of the right objects, and have the same tree."""
        number = 200
        carver = carve_scene(number, owner="0")
        self.assertEqual(counts(carver, LEVEL, 49), expected_counts(number))
        check = simple.ProgrammableFilter(
            Input=simple.OutputPort(carver, STREAM), Script=CHECK.format(number=number, slack=0.15),
            OutputDataSetType="vtkPolyData")
        processes = simple.servermanager.ActiveConnection.GetNumberOfDataPartitions()
        self.assertEqual(counts(check)[0], processes)
        for port in (ALL_LEVELS, STREAM, PROFILE):
            hierarchy = simple.OutputPort(carver, port).GetDataInformation().GetHierarchy()
            self.assertEqual(hierarchy.GetNumberOfChildren(hierarchy.GetRootNode()), number)

    def test_levels_do_not_depend_on_the_owner(self):
        """A scene of the last process, and one that is spread already, have the same levels."""
        one, spread = carve_scene(20, owner="count - 1"), carve_scene(20, owner="i % count")
        for time in (0, 20, 49):
            self.assertEqual(counts(one, LEVEL, time), counts(spread, LEVEL, time))


scene.run_tests(unittest)
