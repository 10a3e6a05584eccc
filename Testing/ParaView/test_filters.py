# SPDX-License-Identifier: BSD-3-Clause
"""The filters of the plugin, through ParaView's Python."""
import math
import os
import subprocess
import unittest

import scene
from paraview import simple
from scene import ALL_LEVELS, LEVEL, PROFILE, STREAM, counts, fetch, numbers, open_model

# Eight geospheres of 642 points each, of 1280 triangles.
POINTS, TRIANGLES = 8 * 642, 8 * 1280


class TestFilters(unittest.TestCase):
    def setUp(self):
        self.addCleanup(simple.ResetSession)
        self.mesh = open_model("eight-spheres.ply")

    def carver(self, **properties):
        return simple.TopologyCarver(Input=self.mesh, **properties)

    def test_shows_one_level_and_keeps_the_rest_apart(self):
        """After Apply, the view shows the level, but not all levels, the stream and the profile."""
        carver = self.carver()
        view = simple.CreateRenderView()
        controller = simple.servermanager.ParaViewPipelineController()
        shown = [controller.ShowInPreferredView(carver.SMProxy, port, view.SMProxy) for port in range(4)]
        self.assertEqual([bool(found) for found in shown], [True, False, False, False])
        types = [simple.OutputPort(carver, i).GetDataInformation().GetDataSetTypeAsString() for i in range(4)]
        self.assertEqual(types, ["vtkPolyData", "vtkMultiBlockDataSet", "vtkUnstructuredGrid", "vtkTable"])

    def test_shows_a_level_in_the_middle(self):
        """After Apply, the level is between the hull and the mesh, at any time."""
        hull = counts(self.carver(LevelBy="Step", Step=0))[0]
        carver = self.carver()
        shown = counts(carver)
        self.assertEqual(numbers(carver, "ShownVertices"), [round(math.sqrt(hull * POINTS))])
        self.assertTrue(hull < shown[0] <= math.sqrt(hull * POINTS) + 1)
        self.assertEqual(counts(carver, LEVEL, 49), shown)

    def test_finds_the_middle_of_the_present_input(self):
        """Without a number of vertices, the level is in the middle of the input, whatever was shown before."""
        other = open_model("two-spheres.ply")
        expected = counts(simple.TopologyCarver(Input=other))
        carver = self.carver()
        counts(carver)
        carver.Input = other
        self.assertEqual(counts(carver), expected)

    def test_decimates_a_surface(self):
        """Enclosing Decimation has the coarsest surface on its first output and all on its second."""
        decimation = simple.EnclosingDecimation(Input=self.mesh, Targets=[1000, 400])
        self.assertEqual(counts(decimation)[0], 400)
        everything = simple.OutputPort(decimation, 1).GetDataInformation()
        self.assertEqual(everything.GetDataSetTypeAsString(), "vtkMultiBlockDataSet")
        self.assertEqual(everything.GetNumberOfPoints(), 1400)

    def test_time_moves_from_the_hull_to_the_mesh(self):
        """Time steps exist before anything is carved; the first is the hull, the last is the mesh."""
        carver = self.carver(FollowTime=1)
        carver.UpdatePipelineInformation()
        times = list(carver.TimestepValues)
        self.assertEqual(times, list(range(50)))
        self.assertLess(counts(carver, LEVEL, times[0])[0], 1000)
        self.assertEqual(counts(carver, LEVEL, times[-1]), (POINTS, TRIANGLES))
        steps = [counts(carver, LEVEL, time)[0] for time in times]
        self.assertGreater(len(set(steps)), 40)

    def test_properties_pick_the_level(self):
        """Without Follow Time, each Level By property picks the level, and time steps are there to be used."""
        carver = self.carver(FollowTime=0, LevelBy="Step", Step=0)
        hull = counts(carver)
        self.assertEqual(list(carver.TimestepValues), list(range(50)))
        self.assertEqual(numbers(carver, "VertexRange"), [hull[0], POINTS])
        least, greatest = numbers(carver, "TriangleRange")
        self.assertEqual(least, hull[1])
        self.assertGreaterEqual(greatest, TRIANGLES)  # a level before the last may have more
        carver.Step = numbers(carver, "StepRange")[1]
        self.assertEqual(counts(carver), (POINTS, TRIANGLES))
        carver.LevelBy, carver.Triangles = "Triangles", 6000
        self.assertLessEqual(counts(carver)[1], 6000)
        carver.LevelBy, carver.FeatureSize = "Feature Size", 2 * numbers(carver, "FeatureSizeRange")[1]
        self.assertEqual(counts(carver), hull)
        carver.LevelBy, carver.Components = "Components", 8
        self.assertEqual(numbers(carver, "ComponentsRange"), [1, 8])
        self.assertEqual(counts(carver), (POINTS, TRIANGLES))
        carver.LevelBy, carver.Tunnels = "Tunnels", 0
        self.assertGreaterEqual(numbers(carver, "TunnelsRange")[1], 5)
        self.assertLess(counts(carver)[0], POINTS)
        carver.ComputeError, carver.LevelBy = 1, "Error Bound"
        carver.ErrorBound = 0.0
        self.assertEqual(counts(carver), (POINTS, TRIANGLES))
        carver.ErrorBound = numbers(carver, "ErrorBoundRange")[1]
        self.assertEqual(counts(carver), hull)

    def test_choosing_a_level_does_not_carve_again(self):
        """Choosing another level runs the helper program neither in the carver nor in an extractor."""
        carver = self.carver(FollowTime=1)
        hull = counts(carver)
        extract = simple.ExtractCarvedLOD(Input=simple.OutputPort(carver, STREAM), FollowTime=1)
        self.assertEqual(counts(extract), hull)
        os.environ["TOPOLOGYCARVING_HELPER"] = "/bin/false"
        self.addCleanup(os.environ.pop, "TOPOLOGYCARVING_HELPER")
        self.assertEqual(counts(carver, LEVEL, 49), (POINTS, TRIANGLES))
        self.assertEqual(counts(extract, 0, 49), (POINTS, TRIANGLES))
        carver.FollowTime, carver.Vertices = 0, 3000
        self.assertLess(counts(carver)[0], POINTS)

    def test_simplified_levels_are_picked_from_the_stream(self):
        """With Level Simplification, the slider gives any number of vertices, also in a filter on the stream."""
        carver = self.carver(LevelSimplification="Enclosing Collapse", LevelsBy="Vertices",
                             LevelTargets=[64, 600], FollowTime=0, LevelBy="Vertices")
        extractor = simple.ExtractCarvedLOD(Input=simple.OutputPort(carver, STREAM), FollowTime=0,
                                            LevelSimplification="Enclosing Collapse", LevelBy="Vertices")
        for number in (64, 300, 600, 2500):
            carver.Vertices = extractor.Vertices = number
            self.assertEqual(counts(carver)[0], number)
            self.assertEqual(counts(extractor), counts(carver))
        carver.UpdatePropertyInformation()
        self.assertEqual(numbers(carver, "VertexRange"), [64, POINTS])

    def test_extractor_agrees_with_the_carver(self):
        """Carver and extractor give the same level at the same time step."""
        carver = self.carver(FollowTime=1)
        extract = simple.ExtractCarvedLOD(Input=simple.OutputPort(carver, STREAM), FollowTime=1)
        for time in (0, 7, 23, 49):
            self.assertEqual(counts(extract, 0, time), counts(carver, LEVEL, time))

    def test_extractor_knows_its_range_at_once(self):
        """If the stream exists already, the slider has its range, and a level in the middle is shown."""
        carver = self.carver(LevelBy="Step", Step=0)
        least = counts(carver)[0]
        extract = simple.ExtractCarvedLOD(Input=simple.OutputPort(carver, STREAM))
        self.assertEqual(numbers(extract, "VertexRange"), [least, POINTS])
        self.assertTrue(least < extract.Vertices < POINTS)

    def test_level_targets_replace_the_number_of_levels(self):
        """With level targets, All Levels has one level per target."""
        carver = self.carver(LevelTargets=[1000, 2000, 4000])
        carver.UpdatePipeline()
        levels = fetch(carver, ALL_LEVELS)
        self.assertEqual(levels.GetNumberOfBlocks(), 3)

    def test_starts_from_a_box_or_a_given_mesh(self):
        """Carving starts from the eight corners of the bounding box, or from a given mesh."""
        carver = self.carver(InitialApproximation="Bounding Box", LevelBy="Step", Step=0)
        self.assertEqual(counts(carver), (8, 12))
        box = simple.Box(XLength=3, YLength=3, ZLength=3, Center=[0.5, 0.5, 0.5])
        triangles = simple.Triangulate(Input=box)
        carver = self.carver(
            InitialApproximation="Custom", CustomApproximation=triangles, LevelBy="Step", Step=0)
        self.assertEqual(counts(carver), (8, 12))

    def test_time_of_the_input_wins(self):
        """The time steps of an input are kept, and properties pick the level."""
        mesh = simple.GenerateTimeSteps(Input=self.mesh, TimeStepValues=[0.0, 1.0, 2.0])
        carver = simple.TopologyCarver(Input=mesh, FollowTime=1, Vertices=2000)
        carver.UpdatePipelineInformation()
        self.assertEqual(list(carver.TimestepValues), [0.0, 1.0, 2.0])
        points = counts(carver, LEVEL, 1.0)[0]
        self.assertTrue(1500 < points < 2500)
        self.assertEqual(counts(carver, LEVEL, 2.0)[0], points)

    def test_property_can_be_animated(self):
        """An animation track for the number of vertices moves through the levels."""
        carver = self.carver(FollowTime=0)
        simple.Show(carver, simple.CreateRenderView())
        track = simple.GetAnimationTrack("Vertices", proxy=carver)
        track.KeyFrames = [
            simple.CompositeKeyFrame(KeyTime=0.0, KeyValues=[900]),
            simple.CompositeKeyFrame(KeyTime=1.0, KeyValues=[5136])]
        scene_ = simple.GetAnimationScene()
        scene_.PlayMode, scene_.NumberOfFrames = "Sequence", 5
        scene_.GoToLast()
        self.assertEqual(counts(carver)[0], POINTS)
        scene_.GoToFirst()
        self.assertLess(counts(carver)[0], 1000)

    def test_scene_keeps_its_tree(self):
        """Each object of a collection is carved on its own, and an extractor works on all of them."""
        parts = [self.mesh, open_model("two-spheres.ply")]
        group = simple.GroupDatasets(Input=parts)
        group.BlockNames = ["eight", "two"]
        carver = simple.TopologyCarver(Input=group, FollowTime=1)
        carver.UpdatePipeline(49)
        for port, children in ((LEVEL, 0), (ALL_LEVELS, 8), (STREAM, 0), (PROFILE, 0)):
            tree = fetch(carver, port)
            names = [tree.GetMetaData(i).Get(tree.NAME()) for i in range(tree.GetNumberOfBlocks())]
            self.assertEqual(names, ["eight", "two"])
            if children:
                self.assertEqual(tree.GetBlock(0).GetNumberOfBlocks(), children)
        extract = simple.ExtractCarvedLOD(Input=simple.OutputPort(carver, STREAM), FollowTime=1)
        self.assertEqual(counts(extract, 0, 49), (POINTS + 2 * 642, TRIANGLES + 2 * 1280))

    def test_carves_contours(self):
        """The last level of the Contour Carver is the input."""
        figure = open_model("carved-figure.vtk")
        lines = counts(figure)[1]
        carver = simple.ContourCarver(Input=figure, FollowTime=1)
        self.assertLess(counts(carver)[1], lines)
        self.assertEqual(counts(carver, LEVEL, 49)[1], lines)

    def test_errors_are_words_and_not_the_end(self):
        """A mesh without volume gives an error and an empty level, and the next mesh is carved."""
        script = os.path.join(os.path.dirname(scene.__file__), "flat_mesh.py")
        run = subprocess.run(
            [os.environ["PVBATCH"], "--dr", script], capture_output=True, text=True,
            timeout=float(os.environ["PATIENCE"]))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("lie in one plane", run.stdout + run.stderr)
        self.assertIn("carved the next mesh", run.stdout)


scene.run_tests(unittest)
