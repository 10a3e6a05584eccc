# SPDX-License-Identifier: BSD-3-Clause
"""The command-line program.

Environment variables name the program (CARVE), the folder of the fetched meshes (MESHES), the folder of the sources
(ROOT) and the number of seconds to wait for an event (PATIENCE).
"""
import csv
import glob
import gzip
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from meshes import two_cubes
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkCompositeDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLMultiBlockDataReader, vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader,
    vtkXMLUnstructuredGridWriter)

CARVE = os.environ["CARVE"]
PATIENCE = float(os.environ["PATIENCE"])
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


def descendants(pid):
    """The process ids of all descendants of a process."""
    try:
        with open(f"/proc/{pid}/task/{pid}/children", encoding="ascii") as file:
            children = file.read().split()
    except OSError:
        return []
    return children + [further for child in children for further in descendants(child)]


def is_running(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


class TestCarve(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_carve(self, *arguments, **environment):
        return subprocess.run(
            [CARVE, *arguments], capture_output=True, text=True, cwd=self.folder, env={**os.environ, **environment})

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

    # Terminal output

    def test_prints_a_table(self):
        """The table has the levels from the hull to the mesh, and the seconds of all stages."""
        rows = self.table(BONES)
        self.assertEqual([row[0] for row in rows], list(range(8)))  # the default number of levels
        self.assertEqual(rows[0][1:3], (0, 124))  # hull vertices of the bones in the paper's Table 1
        self.assertEqual(rows, sorted(rows))
        self.assertEqual(rows[0][4:], (1, 0, 0))  # a convex hull
        self.assertEqual([row[4] for row in rows], sorted(row[4] for row in rows))
        output = self.run_carve(BONES).stdout
        for stage in ("read", "clean", "resolve", "tetrahedralize", "transfer", "classify", "carve", "measure",
                      "output"):
            self.assertRegex(output, rf"{stage} \d+\.\d\d\d")

    def test_prints_the_number_of_tetrahedra(self):
        """The number is that of the tetrahedra in the stored stream, and the strategy beside it made them."""
        output = self.run_carve(BONES, "--stream", "out.vtu").stdout
        stream = read(vtkXMLUnstructuredGridReader, self.path("out.vtu"))
        types = [stream.GetCellType(i) for i in range(stream.GetNumberOfCells())]
        strategy = stream.GetFieldData().GetAbstractArray("Strategy").GetValue(0)
        self.assertIn(f"\nstream: {types.count(VTK_TETRA)} tetrahedra ({strategy})\n", output)

    def test_carves_several_inputs(self):
        """Several inputs are blocks of one output, named and in order, whatever the number of threads."""
        cubes = self.write_cubes(vtkSTLWriter, "cubes.stl")
        for threads in ("1", "2"):
            run = self.run_carve(BONES, cubes, "--levels", "3", "--threads", threads, "-o", "scene.vtm")
            self.assertEqual(run.returncode, 0, run.stderr)
            scene = read(vtkXMLMultiBlockDataReader, self.path("scene.vtm"))
            names = [scene.GetMetaData(i).Get(vtkCompositeDataSet.NAME()) for i in range(scene.GetNumberOfBlocks())]
            self.assertEqual(names, ["bones.off", "cubes.stl"])
            alone = self.table(BONES, "--levels", "3") + self.table(cubes, "--levels", "3")
            levels = [scene.GetBlock(i).GetBlock(k) for i in range(2)
                      for k in range(scene.GetBlock(i).GetNumberOfBlocks())]
            self.assertEqual([level.GetNumberOfPolys() for level in levels], [row[3] for row in alone])

    def test_goes_on_after_a_bad_input(self):
        """Of several inputs, one that cannot be carved is an error, and the others are written."""
        flat = self.path("flat.off")
        with open(flat, "w", encoding="ascii") as file:
            file.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        run = self.run_carve(flat, BONES, "-o", "scene.vtm")
        self.expect_failure(run, 1, "plane")
        self.assertIn("flat.off: no levels", run.stdout)
        scene = read(vtkXMLMultiBlockDataReader, self.path("scene.vtm"))
        self.assertEqual(scene.GetBlock(1).GetNumberOfBlocks(), 8)

    def test_refuses_what_several_inputs_exclude(self):
        """Options and formats for a single input are a mistake with several ones."""
        for arguments, word in ((("--decimate",), "--decimate"), (("--stream", "a.vtu"), "--stream"),
                                (("--profile", "a.csv"), "--profile"), (("-o", "a.ply"), ".vtm")):
            self.expect_failure(self.run_carve(BONES, BONES, *arguments), 2, "several inputs", word)

    def test_prints_no_progress_into_a_pipe(self):
        """Standard error stays empty if it is not a terminal."""
        self.assertEqual(self.run_carve(BONES).stderr, "")

    def test_prints_help(self):
        """--help is a manual page with every option of the README."""
        run = self.run_carve("--help")
        self.assertEqual(run.returncode, 0)
        for word in ("NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "ENVIRONMENT", "EXAMPLES"):
            self.assertIn(word, run.stdout)
        with open(os.path.join(os.environ["ROOT"], "README.md"), encoding="utf-8") as file:
            text = file.read()
        sections = [text.split(title)[1].split("\n##")[0] for title in ("### Command line", "## Properties")]
        options = set(re.findall(r"--[a-z][a-z-]+", "".join(sections)))
        self.assertGreater(len(options), 25)
        headings = "".join(re.findall(r"^ {4}-.*$", run.stdout, re.MULTILINE))
        self.assertLessEqual(options, set(re.findall(r"--[a-z-]+", headings)))

    def test_decimates(self):
        """--decimate gives closed surfaces of the wanted sizes, coarsest first."""
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(40)
        sphere.SetPhiResolution(40)
        sphere.Update()
        self.write(vtkXMLPolyDataWriter, "sphere.vtp", sphere.GetOutput())
        run = self.run_carve("sphere.vtp", "--decimate", "--vertices", "300,50", "-o", "out.vtm")
        self.assertEqual(run.returncode, 0, run.stderr)
        rows = [line.split() for line in run.stdout.splitlines() if re.match(r" +\d", line)]
        # A sphere of n vertices has 2 n - 4 triangles.
        self.assertEqual([row[:3] for row in rows], [["0", "50", "96"], ["1", "300", "596"]])
        self.assertGreater(float(rows[0][3]), float(rows[1][3]))
        self.assertTrue(os.path.exists(self.path("out.vtm")))
        bounded = self.run_carve("sphere.vtp", "--decimate", "--nested", "--error-bound", "0.05")
        self.assertLessEqual(float(bounded.stdout.split("seconds")[0].split()[-1]), 0.05)
        self.expect_failure(self.run_carve(BONES, "--decimate"), 1, "crosses itself")
        for options in (("--levels", "3"), ("--tunnels", "0"), ("--depth-exponent", "1")):
            self.assertEqual(self.run_carve("sphere.vtp", "--decimate", *options).returncode, 2)
        self.expect_failure(self.run_carve("sphere.vtp", "--nested"), 2, "--decimate")

    def test_writes_the_profile(self):
        """--profile writes a table with a row per step, or a chart if there is a display."""
        rows = self.table(BONES, "--profile", "out.csv", "--stream", "out.vtu", "--compute-error", "on")
        with open(self.path("out.csv"), encoding="utf-8") as file:
            table = list(csv.DictReader(file))
        self.assertEqual(len(table), rows[-1][1] + 1)
        names = ("Vertices", "Triangles", "Components", "Tunnels", "Voids")
        for row in rows:
            self.assertEqual(tuple(int(table[row[1]][name]) for name in names), row[2:])
        self.assertEqual(float(table[-1]["Error"]), 0.0)  # the last level is the mesh
        self.table("out.vtu", "--profile", "again.csv")
        with open(self.path("out.csv"), "rb") as first, open(self.path("again.csv"), "rb") as second:
            self.assertEqual(first.read(), second.read())
        self.table("out.vtu", "--profile", "out.png")
        with open(self.path("out.png"), "rb") as file:
            self.assertGreater(len(file.read()), 5000)  # an empty picture has less than 3,000 bytes
        self.expect_failure(self.run_carve("out.vtu", "--profile", "no.png", DISPLAY=":7654"), 1, "no.png", "display")
        self.expect_failure(self.run_carve("out.vtu", "--profile", "out.txt"), 2, "--profile", ".csv")

    def test_picks_levels_by_topology_and_distance(self):
        """Tunnels, components and distances pick levels of a mesh and of a stream."""
        for option, column in (("--tunnels", 5), ("--components", 4)):
            rows = self.table(BONES, option, "3,8")
            for row, most in zip(rows, (3, 8)):
                self.assertLessEqual(row[column], most)
            self.assertLess(rows[0][1], rows[1][1])
        rows = self.table(BONES, "--error-bound", "0.2,0.4", "--stream", "out.vtu")
        self.assertLess(rows[0][1], rows[1][1])
        self.assertEqual(self.table("out.vtu", "--error-bound", "0.4,0.2"), rows)
        self.expect_failure(self.run_carve(BONES, "--tunnels", "-1"), 2, "--tunnels", "whole numbers")
        self.expect_failure(self.run_carve(BONES, "--tunnels", "1", "--components", "1"), 2, "options only")

    def test_prints_its_version(self):
        """--version prints a name and a number."""
        self.assertRegex(self.run_carve("--version").stdout, r"^carve \d+\.\d+\.\d+\n$")

    # Choice of levels

    def test_takes_a_number_of_levels(self):
        """--levels sets the number of levels."""
        self.assertEqual(len(self.table(BONES, "--levels", "3")), 3)

    def test_takes_targets(self):
        """--vertices and --triangles give one level per target, none larger than its target."""
        rows = self.table(BONES, "--vertices", "500,1000")
        # Without voids, a step adds at most one vertex (section 3.3), so every number of vertices occurs.
        self.assertEqual([row[2] for row in rows], [500, 1000])
        rows = self.table(BONES, "--triangles", "1000")
        self.assertLessEqual(rows[0][3], 1000)

    def test_warns_of_a_target_below_the_hull(self):
        """A target below the hull gives the hull and a warning."""
        run = self.run_carve(BONES, "--vertices", "5")
        self.assertEqual(run.returncode, 0)
        self.assertIn("warning", run.stderr)

    def test_can_leave_exposed_tetrahedra(self):
        """--carve-exposed off gives more triangles at the same number of vertices."""
        on = self.table(BONES, "--vertices", "1000")
        off = self.table(BONES, "--vertices", "1000", "--carve-exposed", "off")
        self.assertGreater(off[0][3], on[0][3])

    def test_sets_every_property(self):
        """Every value of a property option is accepted and changes the table of the bones."""
        plain = self.table(BONES)
        for option, values in (("--initial-approximation", ("bounding-box",)),
                               ("--priority-measure", ("volume", "circumradius", "edge-volume")),
                               ("--depth-exponent", ("2", "0.5")),
                               ("--breadth-radius", ("0.5",)),
                               ("--maximum-components", ("1", "5")),
                               ("--maximum-tunnels", ("0", "1")),
                               ("--solid-rule", ("even-odd", "surface-only"))):
            for value in values:
                self.assertNotEqual(self.table(BONES, option, value), plain, (option, value))
        self.assertNotEqual(self.table(BONES, "--depth-exponent", "1", "--depth-measure", "distance"),
                            self.table(BONES, "--depth-exponent", "1", "--depth-measure", "hierarchy"))
        self.assertNotEqual(self.table(BONES, "--solid-rule", "surface-only", "--carve-voids", "off"),
                            self.table(BONES, "--solid-rule", "surface-only", "--carve-voids", "on"))

    # Input files

    def test_reads_all_formats(self):
        """OBJ, PLY, STL, VTP and legacy VTK files of the same mesh give the same mesh, gzipped or not."""
        names = [
            self.write_cubes(vtkOBJWriter, "cubes.obj"),
            self.write_cubes(vtkPLYWriter, "cubes.ply"),
            self.write_cubes(vtkSTLWriter, "cubes.stl"),
            self.write_cubes(vtkXMLPolyDataWriter, "cubes.vtp"),
            self.write_cubes(vtkPolyDataWriter, "cubes.vtk"),
        ]
        for name in list(names):
            with open(name, "rb") as plain, gzip.open(name + ".gz", "wb") as packed:
                shutil.copyfileobj(plain, packed)
            names.append(name + ".gz")
        upper = self.path("CUBES.STL")
        shutil.copy(self.path("cubes.stl"), upper)
        sizes = {name: [row[2:4] for row in self.table(name)][-1] for name in names + [upper]}
        self.assertEqual(set(sizes.values()), {(16, 24)}, sizes)  # 8 vertices and 12 triangles per cube

    def test_reads_off(self):
        """OFF files may have comments, polygons, colors, and counts in the line of the header."""
        with open(self.path("pyramid.off"), "w", encoding="ascii") as file:
            file.write("COFF 5 5 0 # counts\n# points\n0 0 0 255 0 0\n1 0 0 0 0 0\n\n1 1 0 1 1 1\n0 1 0 0 0 0\n"
                       ".5 .5 1e0 0 0 0\n4 3 2 1 0\n3 0 1 4 0.1 0.2 0.3\n3 1 2 4\n3 2 3 4\n3 3 0 4\n")
        # A pyramid is convex: its only level has its five vertices, four sides and two halves of the base.
        self.assertEqual(self.table("pyramid.off"), [(0, 0, 5, 6, 1, 0, 0)])

    # Output files

    def test_writes_a_multiblock(self):
        """-o OUT.vtm writes all levels with their arrays."""
        self.table(BONES, "-o", "out.vtm", "--levels", "3")
        levels = read(vtkXMLMultiBlockDataReader, self.path("out.vtm"))
        self.assertEqual(levels.GetNumberOfBlocks(), 3)
        level = levels.GetBlock(2)
        self.assertIsNotNone(level.GetCellData().GetArray("vtkOriginalCellIds"))
        self.assertEqual(level.GetFieldData().GetArray("Vertices").GetValue(0), level.GetNumberOfPoints())

    def test_writes_a_file_per_level(self):
        """-o OUT.ply, .obj, .stl and .vtp write one numbered file per level, with the triangles of the table."""
        for extension, reader in ((".ply", vtkPLYReader), (".stl", vtkSTLReader), (".vtp", vtkXMLPolyDataReader)):
            rows = self.table(BONES, "-o", "out" + extension, "--levels", "3")
            self.assertEqual(len(glob.glob(self.path("out_*" + extension))), 3)
            for row in rows:
                level = read(reader, self.path(f"out_{row[0]}{extension}"))
                self.assertEqual(level.GetNumberOfPolys(), row[3])
        self.table(BONES, "-o", "out.obj", "--levels", "3")
        self.assertEqual(len(glob.glob(self.path("out_*.obj"))), 3)

    def test_warns_when_rounding_makes_a_level_cross_itself(self):
        """A format that rounds to floats gives a warning if that makes a level cross itself.

        The facing sides of two tetrahedra far from the origin have the same coordinates as floats.
        """
        gap = 1e-6
        with open(self.path("close.off"), "w", encoding="ascii") as file:
            file.write("OFF\n8 8 0\n")
            for x, y, z in ((0, 0, -gap), (2, 0, -gap), (0, 2, -gap), (0.5, 0.5, -1),
                            (0, 0.3, gap), (2, 0.3, gap), (0.7, 2, gap), (0.5, 0.5, 1)):
                file.write(f"{x + 1000!r} {y + 1000!r} {z + 1000!r}\n")
            file.write("3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n3 4 6 5\n3 4 5 7\n3 5 6 7\n3 6 4 7\n")
        for extension in (".ply", ".stl", ".obj"):
            run = self.run_carve("close.off", "-o", "out" + extension, "--levels", "1")
            self.assertEqual(run.returncode, 0)
            self.assertIn("rounding", run.stderr)
        run = self.run_carve("close.off", "-o", "out.vtp", "--levels", "1")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        run = self.run_carve(BONES, "-o", "out.ply", "--levels", "1")
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    # Errors

    def test_simplifies_levels(self):
        """--simplify reaches numbers of vertices below the hull's, also together with a number of tunnels."""
        rows = self.table(BONES, "--simplify", "--vertices", "60,200")
        self.assertEqual([row[2] for row in rows], [60, 200])
        for order in (("--tunnels", "0,2", "--vertices", "150"), ("--vertices", "150", "--tunnels", "0,2")):
            rows = self.table(BONES, *order)
            self.assertEqual(len(rows), 2)
            for row, tunnels in zip(rows, (0, 2)):
                self.assertLessEqual(row[2], 150)
                self.assertLessEqual(row[5], tunnels)
        two = ("--vertices", "9,10", "--tunnels", "0")
        self.expect_failure(self.run_carve(BONES, *two), 2, "options only")

    def test_refuses_a_wrong_command_line(self):
        """A wrong command line gives exit code 2 and one line with the reason."""
        self.expect_failure(self.run_carve(), 2, "input")
        self.expect_failure(self.run_carve("--nonsense", BONES), 2, "--nonsense")
        self.expect_failure(self.run_carve(BONES, "-x"), 2, "-x")
        self.expect_failure(self.run_carve(BONES, "-o"), 2, "-o", "value")
        self.expect_failure(self.run_carve(BONES, "-o", "out.doc"), 2, "out.doc", ".vtm")
        for levels in ("0", "-1", "many", "1.5", "1e99", "nan", ""):
            self.expect_failure(self.run_carve(BONES, "--levels", levels), 2, "--levels")
        for targets in ("", ",", "1,,2", "10,x", "0"):
            self.expect_failure(self.run_carve(BONES, "--vertices", targets), 2, "--vertices")
        self.expect_failure(self.run_carve(BONES, "--vertices", "9", "--triangles", "9"), 2, "options only")
        self.expect_failure(self.run_carve(BONES, "--levels", "9", "--triangles", "9"), 2, "--levels")
        self.expect_failure(self.run_carve(BONES, "--carve-exposed", "maybe"), 2, "off|on")
        self.expect_failure(self.run_carve(BONES, "--solid-rule", "odd"), 2, "even-odd")
        for number in ("-1", "deep", "inf", ""):
            self.expect_failure(self.run_carve(BONES, "--depth-exponent", number), 2, "--depth-exponent")

    def test_refuses_a_wrong_file(self):
        """A file that is missing, a folder or in a wrong format gives exit code 1 and one line with its name."""
        self.expect_failure(self.run_carve("missing.ply"), 1, "missing.ply", "no such file")
        os.mkdir(self.path("folder.ply"))
        self.expect_failure(self.run_carve("folder.ply"), 1, "folder.ply")
        for extension in (".obj", ".ply", ".stl", ".off", ".vtp", ".vtk", ".obj.gz"):
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

    def test_refuses_a_truncated_gzip_file(self):
        """A gzip file that ends early is an error."""
        name = self.path("cut.off.gz")
        with open(BONES, "rb") as plain, gzip.open(name, "wb") as packed:
            shutil.copyfileobj(plain, packed)
        os.truncate(name, 20000)
        self.expect_failure(self.run_carve(name), 1, "cut.off.gz", "gzip")

    def test_refuses_a_place_that_cannot_be_written(self):
        """A place that cannot be written, here below a file, gives exit code 1 and one line with its name."""
        with open(self.path("file"), "w", encoding="ascii"):
            pass
        for extension in (".vtm", ".vtp", ".ply", ".obj", ".stl"):
            self.expect_failure(self.run_carve(BONES, "-o", "file/out" + extension), 1, "file/out", "write")

    def test_notices_a_full_disk(self):
        """A full disk is an error in every format, for every level of a multiblock and for a stream."""
        for extension in (".vtp", ".ply", ".obj", ".stl"):
            os.symlink("/dev/full", self.path("out_0" + extension))
            self.expect_failure(self.run_carve(BONES, "-o", "out" + extension), 1, "cannot write out_0" + extension)
        for option, name in (("--stream", "full.vtu"), ("-o", "full.vtm")):
            os.symlink("/dev/full", self.path(name))
            self.expect_failure(self.run_carve(BONES, option, name), 1, "cannot write " + name)
        self.table(BONES, "--stream", "s.vtu")
        for name, failed in (("out.vtm", "out.vtm"), ("level.vtp", "level_")):
            run = subprocess.run(
                [CARVE, "s.vtu", "-o", name], capture_output=True, text=True, cwd=self.folder, restore_signals=False,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000)))
            self.expect_failure(run, 1, "cannot write " + failed)

    # Stored streams

    def test_answers_from_a_stored_stream(self):
        """Levels from a file of --stream have the same bytes as the levels of the carving."""
        for option in (("--levels", "4"), ("--vertices", "300,900"), ("--triangles", "700"), ("--step", "0,55"),
                       ("--feature-size", "0.8")):
            carved = self.table(BONES, "--stream", "out.vtu", "-o", "carved.vtm", *option)
            answered = self.table("out.vtu", "-o", "answered.vtm", *option)
            self.assertEqual(carved, answered)
            for i in range(len(carved)):
                with open(self.path(f"carved/carved_{i}.vtp"), "rb") as a:
                    with open(self.path(f"answered/answered_{i}.vtp"), "rb") as b:
                        self.assertEqual(a.read(), b.read())

    def test_refuses_to_carve_a_stream_again(self):
        """A stored stream excludes options for carving, and has to be a .vtu file that exists."""
        self.table(BONES, "--stream", "out.vtu")
        self.expect_failure(self.run_carve("out.vtu", "--depth-exponent", "2"), 2, "--depth-exponent", "already")
        self.expect_failure(self.run_carve("none.vtu"), 1, "none.vtu", "no such file")
        self.expect_failure(self.run_carve(BONES, "--stream", "out.vtk"), 2, ".vtu")

    def test_names_what_is_wrong_with_a_damaged_stream(self):
        """A damaged stream gives exit code 1 and one line that names the wrong array or the file."""
        self.table(BONES, "--stream", "out.vtu")
        stream = read(vtkXMLUnstructuredGridReader, self.path("out.vtu"))
        pairs = vtkIntArray()
        pairs.SetName("ProfileVertices")
        pairs.SetNumberOfComponents(2)
        pairs.InsertNextTuple2(1, 2)
        stream.GetFieldData().AddArray(pairs)
        self.write(vtkXMLUnstructuredGridWriter, "damaged.vtu", stream)
        self.expect_failure(self.run_carve("damaged.vtu"), 1, "ProfileVertices", "2 components")
        with open(self.path("out.vtu"), "rb") as file:
            content = file.read()
        with open(self.path("cut.vtu"), "wb") as file:  # VTK's reader reports no error
            file.write(content.replace(b'"ProfileVertices" NumberOfTuples="', b'"ProfileVertices" NumberOfTuples="1'))
        self.expect_failure(self.run_carve("cut.vtu"), 1, "cut.vtu", "no cells")

    def test_writes_names_that_can_be_read(self):
        """Levels stay readable if the OBJ file has material names in another encoding."""
        with open(self.path("latin.obj"), "wb") as file:
            file.write(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nusemtl Terr\xe6n\n")
            for a, b, c in ((1, 3, 2), (1, 2, 4), (2, 3, 4), (3, 1, 4)):
                file.write(b"f %d/1 %d/1 %d/1\n" % (a, b, c))
        self.assertEqual(self.run_carve("latin.obj", "-o", "levels.vtm").returncode, 0)
        level = read(vtkXMLMultiBlockDataReader, self.path("levels.vtm")).GetBlock(0)
        self.assertEqual(level.GetNumberOfPolys(), 4)

    def test_carves_contours(self):
        """--contours carves a U out of its hull, a square."""
        corners = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
        points, lines = vtkPoints(), vtkCellArray()
        for x, y in corners:
            points.InsertNextPoint(x, y, 0)
        lines.InsertNextCell(len(corners) + 1)
        for i in range(len(corners) + 1):
            lines.InsertCellPoint(i % len(corners))
        contour = vtkPolyData()
        contour.SetPoints(points)
        contour.SetLines(lines)
        self.write(vtkXMLPolyDataWriter, "u.vtp", contour)
        rows = self.table("u.vtp", "--contours", "-o", "levels.vtm")
        # Six of the eight corners of the U lie on the square.
        self.assertEqual((rows[0][2:], rows[-1][2:]), ((6, 6, 1, 0, 0), (8, 8, 1, 0, 0)))
        self.assertEqual(read(vtkXMLMultiBlockDataReader, self.path("levels.vtm")).GetNumberOfBlocks(), len(rows))
        # In the plane, the stream has the solid's triangles, too. Eight points with six on the square make 2 * 8 - 6 - 2.
        self.assertRegex(self.run_carve("u.vtp", "--contours").stdout, r"\nstream: 8 triangles \(.+\)\n")
        self.assertIn("--contours", self.run_carve("u.vtp").stderr)
        self.assertEqual(self.run_carve("u.vtp", "--contours", "-o", "levels.stl").returncode, 2)

    def test_starts_from_a_given_mesh(self):
        """--initial-mesh gives level 0 and has to contain the input."""
        for size, name in ((100.0, "big.ply"), (0.01, "small.ply")):
            cube = vtkCubeSource()
            cube.SetBounds(-size, size, -size, size, -size, size)
            triangulate = vtkTriangleFilter()
            triangulate.SetInputConnection(cube.GetOutputPort())
            writer = vtkPLYWriter()
            writer.SetInputConnection(triangulate.GetOutputPort())
            writer.SetFileName(self.path(name))
            writer.Write()
        self.assertEqual(self.table(BONES, "--initial-mesh", "big.ply")[0], (0, 0, 8, 12, 1, 0, 0))  # a cube
        self.expect_failure(self.run_carve(BONES, "--initial-mesh", "small.ply"), 1, "does not contain")
        self.expect_failure(self.run_carve(BONES, "--initial-approximation", "custom"), 2, "--initial-mesh")

    def test_reports_a_missing_helper(self):
        """A missing helper program gives exit code 1 and one line with the environment variable."""
        self.expect_failure(
            self.run_carve(BONES, TOPOLOGYCARVING_HELPER="/there/is/none"), 1, "TOPOLOGYCARVING_HELPER")

    def test_reports_a_dying_helper(self):
        """The death of the helper program gives exit code 1 and one line."""
        script = self.path("helper.sh")
        with open(script, "w", encoding="ascii") as file:
            file.write("#!/bin/sh\nkill -KILL $$\n")
        os.chmod(script, 0o700)
        self.expect_failure(self.run_carve(BONES, TOPOLOGYCARVING_HELPER=script), 1, "died")

    def test_takes_the_helper_along_when_killed(self):
        """When a signal ends carve, the helper program and its child processes end too."""
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(300)
        sphere.SetPhiResolution(300)
        sphere.Update()
        mesh = self.write(vtkXMLPolyDataWriter, "big.vtp", sphere.GetOutput())
        for end in (signal.SIGKILL, signal.SIGTERM, signal.SIGINT):
            carve = subprocess.Popen([CARVE, mesh], stdout=subprocess.DEVNULL, cwd=self.folder)
            self.addCleanup(carve.wait)
            self.addCleanup(carve.kill)
            # The helper program, and an attempt, which is a child process of the helper program.
            started = self.wait_for("an attempt", lambda: descendants(carve.pid), lambda pids: len(pids) >= 2)
            carve.send_signal(end)
            self.assertNotEqual(carve.wait(), 0)
            self.wait_for("the end of both", lambda: list(filter(is_running, started)), lambda pids: not pids)

    def wait_for(self, what, look, good):
        """Calls `look` until its result is good, and returns the result."""
        end = time.monotonic() + PATIENCE
        while not good(seen := look()):
            self.assertLess(time.monotonic(), end, f"waited in vain for {what}")
            time.sleep(0.01)
        return seen


if __name__ == "__main__":
    unittest.main()
