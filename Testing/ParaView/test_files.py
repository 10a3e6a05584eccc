# SPDX-License-Identifier: BSD-3-Clause
"""Levels and streams survive ParaView's writers and readers."""
import os
import tempfile
import unittest

import scene
from paraview import simple
from scene import ALL_LEVELS, LEVEL, STREAM, arrays, blocks, counts, fetch, open_model
from vtkmodules.util.numpy_support import vtk_to_numpy

# By default, ParaView 5.11 writes appended data, which it cannot read with the current libexpat1 of Debian 12.
INLINE = {"DataMode": "Binary"}


def triangles(data):
    """The corners of all triangles, in float precision, in an order that does not depend on the file."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype("f4")
    corners = []
    for i in range(data.GetNumberOfCells()):
        ids = data.GetCell(i).GetPointIds()
        corner = [tuple(points[ids.GetId(k)]) for k in range(3)]
        first = corner.index(min(corner))
        corners.append(tuple(corner[first:] + corner[:first]))
    return sorted(corners)


class TestFiles(unittest.TestCase):
    def setUp(self):
        self.addCleanup(simple.ResetSession)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.carver = simple.TopologyCarver(Input=open_model("two-spheres.ply"), FollowTime=0, Vertices=1000)
        self.carver.UpdatePipeline()

    def through(self, name, port, **options):
        path = os.path.join(self.folder, name)
        simple.SaveData(path, simple.OutputPort(self.carver, port), **options)
        back = simple.OpenDataFile(path)
        back.UpdatePipeline()
        return fetch(self.carver, port), back

    def test_vtp_keeps_everything(self):
        """A level comes back from .vtp with the same bytes."""
        level, back = self.through("level.vtp", LEVEL, **INLINE)
        self.assertEqual(arrays(fetch(back)), arrays(level))

    def test_vtm_keeps_everything(self):
        """All levels come back from .vtm with the same names and bytes."""
        levels, back = self.through("levels.vtm", ALL_LEVELS, **INLINE)
        levels, back = blocks(levels), blocks(fetch(back))
        self.assertEqual(list(back), list(levels))
        for name, level in levels.items():
            self.assertEqual(arrays(back[name]), arrays(level))

    def test_stream_from_a_file_gives_the_same_levels(self):
        """A stream read from .vtu gives the same levels as the stream of the carver."""
        stream, back = self.through("stream.vtu", STREAM, **INLINE)
        self.assertEqual(arrays(fetch(back)), arrays(stream))
        extract = simple.ExtractCarvedLOD(Input=back)
        own = simple.ExtractCarvedLOD(Input=simple.OutputPort(self.carver, STREAM))
        for time in (0, 20, 49):
            counts(extract, 0, time), counts(own, 0, time)
            self.assertEqual(arrays(fetch(extract)), arrays(fetch(own)))

    def test_ply_and_stl_keep_the_triangles(self):
        """A level comes back from .ply and .stl with the same triangles, in float precision."""
        for name in ("level.ply", "level.stl"):
            level, back = self.through(name, LEVEL)
            self.assertEqual(triangles(fetch(back)), triangles(level))

    def test_view_exports_to_gltf(self):
        """A visible level is exported to glTF with all its triangles."""
        view = simple.CreateRenderView()
        simple.Show(simple.OutputPort(self.carver, LEVEL), view)
        simple.Render(view)
        path = os.path.join(self.folder, "level.gltf")
        simple.ExportView(path, view=view)
        back = simple.OpenDataFile(path)
        self.assertEqual(counts(back)[1], counts(self.carver)[1])


scene.run_tests(unittest)
