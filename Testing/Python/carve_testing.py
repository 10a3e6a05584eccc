# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the command-line program have in common.

Environment variables name the program (CARVE) and the folder of the fetched meshes (MESHES).
"""
import os
import re
import subprocess
import tempfile
import unittest

from meshes import two_cubes
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

CARVE = os.environ["CARVE"]
BONES = os.path.join(os.environ["MESHES"], "bones.off")


def plain_cubes():
    """Two triangulated cubes without normals, because the OBJ writer needs one normal per point."""
    cubes = two_cubes()
    triangulate = vtkTriangleFilter()
    triangulate.SetInputConnection(cubes.GetOutputPort())
    triangulate.Update()
    plain = vtkPolyData()
    plain.SetPoints(triangulate.GetOutput().GetPoints())
    plain.SetPolys(triangulate.GetOutput().GetPolys())
    return plain


def read(reader_class, name):
    reader = reader_class()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


class CarveTestCase(unittest.TestCase):
    """A test in a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_carve(self, *arguments, **environment):
        return subprocess.run(
            [CARVE, *arguments], capture_output=True, encoding="utf-8", errors="backslashreplace",
            cwd=self.folder, env={**os.environ, **environment})

    def table(self, *arguments):
        """Runs carve and returns its table: level, step, vertices, triangles, components, tunnels, voids."""
        run = self.run_carve(*arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return [tuple(None if word == "-" else int(word) for word in line.split())
                for line in run.stdout.splitlines() if re.fullmatch(r"[\s\d-]+", line)]

    def expect_failure(self, run, code, *words):
        self.assertEqual(run.returncode, code, run.stderr)
        lines = run.stderr.splitlines()
        self.assertEqual(len(lines), 1, run.stderr)
        self.assertTrue(lines[0].startswith("carve: "), lines[0])
        for word in words:
            self.assertIn(word, lines[0])

    def write(self, writer_class, name, mesh):
        writer = writer_class()
        writer.SetFileName(self.path(name))
        writer.SetInputData(mesh)
        writer.Write()
        return self.path(name)

    def write_cubes(self, writer_class, name):
        return self.write(writer_class, name, plain_cubes())
