# SPDX-License-Identifier: BSD-3-Clause
"""The Python package, used through its public interface only."""
import os
import pydoc
import sys
import unittest

import numpy as np
import topologycarving
from meshes import two_cubes
from topologycarving import vtkTopologyCarver
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkTable, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
import numpy_levels  # noqa: E402


def volume(mesh):
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    a, b, c = (points[column] for column in vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3).T)
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


class TestPackage(unittest.TestCase):
    def test_goes_from_the_hull_to_the_input(self):
        """Levels go from the hull to the input: two unit cubes with a unit gap have volume 2, their hull has 3."""
        cubes = two_cubes()
        carver = vtkTopologyCarver()
        carver.SetInputConnection(0, cubes.GetOutputPort())
        carver.Update()
        levels = carver.GetOutput()
        self.assertIsInstance(levels, vtkMultiBlockDataSet)
        self.assertAlmostEqual(volume(levels.GetBlock(0)), 3)
        self.assertAlmostEqual(volume(levels.GetBlock(levels.GetNumberOfBlocks() - 1)), 2)

    def test_has_three_outputs(self):
        """Port 1 is the stream and port 2 the profile; both have the same number of steps."""
        cubes = two_cubes()
        carver = vtkTopologyCarver()
        carver.SetInputConnection(cubes.GetOutputPort())
        carver.Update()
        stream, profile = carver.GetOutputDataObject(1), carver.GetOutputDataObject(2)
        self.assertIsInstance(stream, vtkUnstructuredGrid)
        self.assertIsInstance(profile, vtkTable)
        steps = vtk_to_numpy(stream.GetCellData().GetArray("Step"))
        self.assertEqual(steps.max(), profile.GetNumberOfRows() - 1)

    def test_takes_level_targets(self):
        """Targets replace the number of levels until they are cleared."""
        cubes = two_cubes()
        carver = vtkTopologyCarver()
        carver.SetInputConnection(cubes.GetOutputPort())
        carver.SetLevelTargetType(carver.TRIANGLES)
        carver.AddLevelTarget(1000)
        self.assertEqual(carver.GetNumberOfLevelTargets(), 1)
        self.assertEqual(carver.GetLevelTarget(0), 1000)
        carver.Update()
        self.assertEqual(carver.GetOutput().GetNumberOfBlocks(), 1)
        carver.ClearLevelTargets()
        carver.Update()
        self.assertGreater(carver.GetOutput().GetNumberOfBlocks(), 1)

    def test_reports_errors(self):
        """A flat mesh raises an error event, and its text names the reason."""
        errors = []
        carver = vtkTopologyCarver()

        def on_error(caller, event, text):
            errors.append(text)

        on_error.CallDataType = "string0"
        carver.AddObserver("ErrorEvent", on_error)
        carver.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        cube = vtkCubeSource()
        cube.SetZLength(0)
        carver.SetInputConnection(cube.GetOutputPort())
        carver.Update()
        self.assertEqual(len(errors), 1)
        self.assertIn("plane", errors[0])

    def test_works_in_a_pipeline(self):
        """A change upstream runs the helper program again, and the stages report its seconds."""
        sphere = vtkSphereSource()
        append = two_cubes()
        append.AddInputConnection(sphere.GetOutputPort())
        sphere.SetCenter(1, 3, 0)
        carver = vtkTopologyCarver()
        carver.SetInputConnection(append.GetOutputPort())
        carver.Update()
        first = volume(carver.GetOutput().GetBlock(0))
        sphere.SetCenter(1, 6, 0)
        carver.Update()
        self.assertGreater(volume(carver.GetOutput().GetBlock(0)), first)
        stages = {carver.GetStageName(i): carver.GetStageSeconds(i) for i in range(carver.GetNumberOfStages())}
        self.assertGreater(stages["tetrahedralize"], 0)

    def test_takes_and_gives_arrays(self):
        """The example with numpy goes from the hull of two cubes to the cubes, whose volumes are 3 and 2."""
        points, triangles = numpy_levels.two_cubes()
        levels = numpy_levels.carve(points, triangles, number_of_levels=2)
        volumes = [np.einsum("ij,ij->i", *(p[t[:, 0]], np.cross(p[t[:, 1]], p[t[:, 2]]))).sum() / 6 for p, t in levels]
        np.testing.assert_allclose(volumes, [3, 2])
        self.assertEqual({tuple(point) for point in levels[-1][0]}, {tuple(point) for point in points})

    def test_help_names_the_classes(self):
        """The help of the package lists its filters, and that of a filter explains its properties."""
        text = pydoc.plain(pydoc.render_doc(topologycarving))
        for name in ("vtkTopologyCarver", "vtkContourCarver", "vtkExtractCarvedLOD", "vtkEnclosingDecimation"):
            self.assertTrue(issubclass(getattr(topologycarving, name), object))
            self.assertIn(name, text)
        self.assertIn("NumberOfLevels", pydoc.plain(pydoc.render_doc(vtkTopologyCarver)))


if __name__ == "__main__":
    unittest.main()
