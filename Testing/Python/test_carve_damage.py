# SPDX-License-Identifier: BSD-3-Clause
"""Files that the command-line program cannot read as they are, and places where it cannot write.

carve_testing.py names the environment variables.
"""
import gzip
import os
import random
import resource
import shutil
import subprocess
import unittest

from carve_testing import BONES, CARVE, CarveTestCase, read
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader, vtkXMLPolyDataWriter


class TestCarveDamage(CarveTestCase):
    def test_refuses_a_wrong_file(self):
        """A file that is missing, a folder or in a wrong format gives exit code 1 and one line with its name."""
        self.expect_failure(self.run_carve("missing.ply"), 1, "missing.ply", "no such file")
        os.mkdir(self.path("folder.ply"))
        self.expect_failure(self.run_carve("folder.ply"), 1, "folder.ply")
        for extension in (".obj", ".ply", ".stl", ".off", ".vtp", ".vtk", ".obj.gz", ".vtm", ".vtpc", ".glb",
                          ".gltf"):
            name = "text" + extension
            with open(self.path(name), "w", encoding="ascii") as file:
                file.write("This is not a mesh.\n" * 3)
            self.expect_failure(self.run_carve(name), 1, name)
        for name in ("text.doc", "text"):
            shutil.copy(self.path("text.obj"), self.path(name))
            self.expect_failure(self.run_carve(name), 1, name, ".ply")

    def test_refuses_broken_off_files(self):
        """The error for a broken OFF file names the header, the counts, the point or the face."""
        for text, word in (("PLY\n", "OFF"), ("OFF\n", "number"), ("OFF\n1 x\n", "numbers"),
                           ("OFF\n1 0 0\n1 2\n", "point 0"), ("OFF\n1 1 0\n1 2 3\n", "face 0"),
                           ("OFF\n1 1 0\n1 2 3\n3 0 0 1\n", "face 0")):
            with open(self.path("broken.off"), "w", encoding="ascii") as file:
                file.write(text)
            self.expect_failure(self.run_carve("broken.off"), 1, "broken.off", word)

    def test_warns_of_a_truncated_stl_file(self):
        """A binary STL file of fewer triangles than its head counts gets a warning with both numbers."""
        name = self.write_cubes(vtkSTLWriter, "cubes.stl")
        solid = read(vtkSTLReader, name)
        writer = vtkSTLWriter()
        writer.SetInputData(solid)
        writer.SetFileName(self.path("whole.stl"))
        writer.SetFileTypeToBinary()
        writer.Write()
        self.assertEqual(self.run_carve("whole.stl", "-o", "levels.vtm").stderr, "")
        with open(self.path("whole.stl"), "rb") as file:
            content = file.read()
        count = solid.GetNumberOfCells()
        with open(self.path("cut.stl"), "wb") as file:
            file.write(content[:84 + 50 * (count - 2) + 7])
        run = self.run_carve("cut.stl", "-o", "levels.vtm")
        self.assertEqual(run.returncode, 0)
        self.assertIn(f"{count - 2} of the {count} triangles", run.stderr)

    def test_refuses_a_truncated_gzip_file(self):
        """A gzip file that ends early is an error."""
        name = self.path("cut.off.gz")
        with open(BONES, "rb") as plain, gzip.open(name, "wb") as packed:
            shutil.copyfileobj(plain, packed)
        os.truncate(name, 20000)
        self.expect_failure(self.run_carve(name), 1, "cut.off.gz", "gzip")

    def test_survives_damaged_files(self):
        """A file that ends early, or has wrong bytes, gives levels or an error, and never a crash."""
        mesh = vtkPlaneSource()
        mesh.SetResolution(3, 3)
        writers = [("a.vtp", vtkXMLPolyDataWriter), ("a.obj", vtkOBJWriter)]
        for writer, extension in ((vtkPLYWriter, "ply"), (vtkSTLWriter, "stl"), (vtkPolyDataWriter, "vtk")):
            writers += [("text." + extension, writer), ("binary." + extension, writer)]
        draw = random.Random(7)
        for name, writer_class in writers:
            writer = writer_class()
            writer.SetFileName(self.path(name))
            writer.SetInputConnection(mesh.GetOutputPort())
            if not name.startswith("a."):
                (writer.SetFileTypeToASCII if name.startswith("text") else writer.SetFileTypeToBinary)()
            writer.Write()
            with open(self.path(name), "rb") as file:
                whole = file.read()
            for damage in range(16):
                content = bytearray(whole)
                if damage % 2:
                    for _ in range(draw.choice((1, 3, 10))):
                        content[draw.randrange(len(content))] = draw.choice((*b"0123456789 -.\n", draw.randrange(256)))
                else:
                    del content[draw.randrange(len(content)):]
                with open(self.path("damaged-" + name), "wb") as file:
                    file.write(content)
                with self.subTest(name=name, damage=damage):
                    run = self.run_carve("damaged-" + name, "--initial-approximation", "bounding-box", "--levels", "1")
                    self.assertIn(run.returncode, (0, 1), run.stderr)
                    if run.returncode == 1:
                        self.assertTrue(run.stderr.splitlines()[-1].startswith("carve: "), run.stderr)

    def test_refuses_a_truncated_gltf_file(self):
        """A .glb file that ends early is an error."""
        self.table(BONES, "--levels", "1", "-o", "out.glb")
        size = os.path.getsize(self.path("out.glb"))
        for length in (size - 4, size // 2, 100, 12, 4, 0):
            os.truncate(self.path("out.glb"), length)
            self.expect_failure(self.run_carve("out.glb"), 1, "cannot read out.glb")

    def test_refuses_to_write_vtkhdf(self):
        """A name that ends in .vtkhdf is a mistake that names the version of VTK that would be needed."""
        self.expect_failure(self.run_carve(BONES, "-o", "out.vtkhdf"), 2, "out.vtkhdf", "9.4", ".vtpc")

    def test_refuses_a_place_that_cannot_be_written(self):
        """A place that cannot be written, here below a file, gives exit code 1 and one line with its name."""
        with open(self.path("file"), "w", encoding="ascii"):
            pass
        for extension in (".vtm", ".vtpc", ".glb", ".vtp", ".ply", ".obj", ".stl"):
            self.expect_failure(self.run_carve(BONES, "-o", "file/out" + extension), 1, "file/out", "write")
        self.expect_failure(self.run_carve(BONES, "-o", "file/folder/"), 1, "file/folder/", "folder")
        self.expect_failure(self.run_carve(BONES, "--json", "file/out.json"), 1, "file/out.json", "write")

    def test_notices_a_full_disk(self):
        """A full disk is an error in every format, for every level of a multiblock and for a stream."""
        for extension in (".vtp", ".ply", ".obj", ".stl"):
            os.symlink("/dev/full", self.path("out_0" + extension))
            self.expect_failure(self.run_carve(BONES, "-o", "out" + extension), 1, "cannot write out_0" + extension)
        for option, name in (("--stream", "full.vtu"), ("-o", "full.vtm"), ("-o", "full.vtpc"), ("-o", "full.glb"),
                             ("--json", "full.json"), ("--profile", "full.csv")):
            os.symlink("/dev/full", self.path(name))
            self.expect_failure(self.run_carve(BONES, option, name), 1, "cannot write " + name)
        with open("/dev/full", "w", encoding="ascii") as full:
            run = subprocess.run([CARVE, BONES], stdout=full, stderr=subprocess.PIPE, text=True, cwd=self.folder)
        self.assertEqual((run.returncode, run.stderr), (1, "carve: cannot write to standard output\n"))
        self.table(BONES, "--stream", "s.vtu")
        for name, failed in (("out.vtm", "out.vtm"), ("out.vtpc", "out.vtpc"), ("out.glb", "out.glb"),
                             ("level.vtp", "level_")):
            run = subprocess.run(
                [CARVE, "s.vtu", "-o", name], capture_output=True, text=True, cwd=self.folder, restore_signals=False,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000)))
            self.expect_failure(run, 1, "cannot write " + failed)

    def test_reads_obj_files_with_broken_faces(self):
        """Faces that refer to nothing, or are lines, cost an OBJ file its attributes; a warning names the line."""
        def carve(head, corners, *more):
            faces = ((1, 3, 2), (1, 2, 4), (2, 3, 4), (3, 1, 4))
            lines = ["v 0 0 0", "v 1 0 0", "v 0 1 0", "v 0 0 1", *head]
            lines += ["f " + " ".join(corners.format(corner) for corner in face) for face in faces]
            with open(self.path("tetrahedron.obj"), "w", encoding="ascii") as file:
                file.write("\n".join((*lines, *more)))
            run = self.run_carve("tetrahedron.obj", "-o", "levels.vtm")
            self.assertEqual(run.returncode, 0, run.stderr)
            level = read(vtkXMLMultiBlockDataReader, self.path("levels.vtm")).GetBlock(0)
            self.assertEqual(level.GetNumberOfPolys(), 4)
            return run.stderr

        texture, normals = ["vt 0 0"] * 4, ["vn 0 0 1"] * 4
        for head, corners in (([], "{0}"), (texture, "{0}/{0}"), (normals, "{0}//{0}"),
                              (texture + normals, "{0}/{0}/{0}")):
            self.assertEqual(carve(head, corners), "")
        for head, corners, line in (([], "{0}/", 5), ([], "{0}/{0}", 6), (texture[:3], "{0}/{0}", 9),
                                    (texture, "{0}/-{0}", 9), (texture + normals, "{0}/{0}/-{0}", 13),
                                    (normals[:1], "{0}//{0}", 7), (texture, "{0}/{0}/", 9),
                                    (texture, "{0}/{0}/{0}", 10), (texture, "{0}/0", 9)):
            warning = carve(head, corners)
            self.assertIn("tetrahedron.obj", warning)
            self.assertIn(f"line {line} ", warning)
        self.assertIn("line 9 ", carve([], "{0}", "f 1 2"))


if __name__ == "__main__":
    unittest.main()
