# SPDX-License-Identifier: BSD-3-Clause
"""State files and Python traces reproduce a session."""
import os
import tempfile
import unittest

import scene
from paraview import simple, smtrace
from scene import LEVEL, STREAM, counts, open_model


class TestReplay(unittest.TestCase):
    def setUp(self):
        self.addCleanup(simple.ResetSession)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def make(self):
        mesh = open_model("eight-spheres.ply")
        # A trace records the properties that are set when a filter is created, as Apply does.
        carver = simple.TopologyCarver(
            registrationName="Carver", Input=mesh, DepthExponent=2, FollowTime=0, Vertices=2500)
        simple.ExtractCarvedLOD(
            registrationName="Extract", Input=simple.OutputPort(carver, STREAM), FollowTime=0, LevelBy="Step",
            Step=700)
        view = simple.GetActiveViewOrCreate("RenderView")
        view.ViewSize = [200, 200]
        display = simple.Show(simple.OutputPort(carver, LEVEL), view)
        simple.ColorBy(display, ("CELLS", "Depth"))
        view.ResetCamera()
        simple.Render(view)

    def results(self):
        return [counts(simple.FindSource(name)) for name in ("Carver", "Extract")]

    def picture(self, name):
        path = os.path.join(self.folder, name)
        simple.SaveScreenshot(path, simple.GetActiveView(), ImageResolution=[200, 200])
        with open(path, "rb") as file:
            return file.read()

    def test_a_trace_gives_the_same_picture(self):
        """Running a Python trace of a session gives the same levels and the same picture.

        This test has to run first: ParaView 5.11 traces nothing after a session has been reset.
        """
        smtrace.start_trace()
        self.make()
        trace = smtrace.stop_trace()
        expected, picture = self.results(), self.picture("before.png")
        simple.ResetSession()
        self.assertIn("TopologyCarver(", trace)
        exec(compile(trace, "trace", "exec"), {"__name__": "trace"})
        self.assertEqual(self.results(), expected)
        self.assertEqual(self.picture("after.png"), picture)

    def test_state_file_gives_the_same_picture(self):
        """Loading a state file of a session gives the same levels and the same picture."""
        self.make()
        expected, picture = self.results(), self.picture("before.png")
        path = os.path.join(self.folder, "session.pvsm")
        simple.SaveState(path)
        simple.ResetSession()
        simple.LoadState(path)
        simple.SetActiveView(simple.GetRenderView())
        self.assertEqual(self.results(), expected)
        self.assertEqual(self.picture("after.png"), picture)


scene.run_tests(unittest)
