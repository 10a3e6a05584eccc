# SPDX-License-Identifier: BSD-3-Clause
"""ParaView opens the files that carve writes.

The environment variable CARVE names the program, of a build with Debian's VTK.
"""
import os
import subprocess
import tempfile
import unittest

import scene
from paraview import simple
from scene import ALL_LEVELS, MODELS, STREAM, arrays, blocks, fetch, open_model

MODEL = "two-spheres.ply"


class TestProgram(unittest.TestCase):
    def setUp(self):
        self.addCleanup(simple.ResetSession)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.carver = simple.TopologyCarver(Input=open_model(MODEL))

    def carve(self, *options):
        subprocess.run([os.environ["CARVE"], os.path.join(MODELS, MODEL), *options], cwd=self.folder, check=True)

    def opened(self, name):
        return fetch(simple.OpenDataFile(os.path.join(self.folder, name)))

    def carved(self, port):
        """The output of the filter, in memory."""
        self.carver.UpdatePipeline()
        return fetch(self.carver, port)

    def test_opens_levels_in_one_file(self):
        """A .vtm file has the levels of the filter, with the same names and bytes."""
        self.carve("-o", "levels.vtm")
        written, levels = blocks(self.opened("levels.vtm")), blocks(self.carved(ALL_LEVELS))
        self.assertEqual(list(written), list(levels))
        for name, level in levels.items():
            self.assertEqual(arrays(written[name]), arrays(level))

    def test_opens_a_collection(self):
        """A .vtpc file has the levels of the filter, with the same names and bytes."""
        self.carve("-o", "levels.vtpc")
        reader = simple.OpenDataFile(os.path.join(self.folder, "levels.vtpc"))
        reader.UpdatePipeline()
        # ParaView 5.11 cannot fetch a collection, but its server is in this process.
        written = reader.SMProxy.GetClientSideObject().GetOutputDataObject(0)
        levels = blocks(self.carved(ALL_LEVELS))
        names = [written.GetMetaData(i).Get(written.NAME()) for i in range(written.GetNumberOfPartitionedDataSets())]
        self.assertEqual(names, list(levels))
        for i, level in enumerate(levels.values()):
            self.assertEqual(arrays(written.GetPartition(i, 0)), arrays(level))

    def test_opens_a_file_per_level(self):
        """Each .vtp file has a level of the filter, with the same bytes."""
        self.carve("-o", "level.vtp")
        for i, level in enumerate(blocks(self.carved(ALL_LEVELS)).values()):
            self.assertEqual(arrays(self.opened(f"level_{i}.vtp")), arrays(level))

    def test_opens_a_stream(self):
        """A .vtu file has the stream of the filter, with the same bytes."""
        self.carve("--stream", "stream.vtu")
        self.assertEqual(arrays(self.opened("stream.vtu")), arrays(self.carved(STREAM)))


scene.run_tests(unittest)
