# SPDX-License-Identifier: BSD-3-Clause
"""The command-line program: its options, its table and its errors.

Environment variables, besides those of carve_testing.py, name the folder of the sources (ROOT) and the number of
seconds to wait for an event (PATIENCE).
"""
import csv
import os
import re
import signal
import subprocess
import time
import unittest

from carve_testing import BONES, CARVE, CarveTestCase, read
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLMultiBlockDataReader, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter)

PATIENCE = float(os.environ["PATIENCE"])


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


class TestCarve(CarveTestCase):
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

    def test_prints_its_version(self):
        """--version prints a name and a number."""
        self.assertRegex(self.run_carve("--version").stdout, r"^carve \d+\.\d+\.\d+\n$")

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
        limit = ("--components", "1", "--maximum-vertices", "60")
        self.expect_failure(self.run_carve(BONES, *limit), 2, "--maximum-vertices", "--simplify")

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

    # Properties

    def test_can_leave_exposed_tetrahedra(self):
        """--carve-exposed off gives more triangles at the same number of vertices."""
        on = self.table(BONES, "--vertices", "1000")
        off = self.table(BONES, "--vertices", "1000", "--carve-exposed", "off")
        self.assertGreater(off[0][3], on[0][3])

    def test_sets_every_property(self):
        """Every value of a property option is accepted and changes the table of the bones."""
        plain = self.table(BONES)
        for option, values in (("--initial-approximation", ("bounding-box",)),
                               ("--priority-measure", ("volume", "circumradius", "edge-volume", "edge-distance")),
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

    def test_measures_no_depth_of_a_convex_mesh(self):
        """Depth by distance needs no tetrahedron: the only level is the mesh."""
        cube = vtkCubeSource()
        cube.Update()
        path = self.write(vtkXMLPolyDataWriter, "cube.vtp", cube.GetOutput())
        rows = self.table(path, "--depth-exponent", "1", "--depth-measure", "distance")
        self.assertEqual([row[2:4] for row in rows], [(8, 12)])

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
        self.expect_failure(self.run_carve("u.vtp", "--contours", "--simplify"), 2, "--simplify", "meshes")
        self.table("u.vtp", "--contours", "--stream", "u.vtu")
        self.assertRegex(self.run_carve("u.vtu").stdout, r"\nlevel +step +vertices +edges +components +holes")
        self.expect_failure(self.run_carve("u.vtu", "-o", "levels.glb"), 2, ".vtm")
        self.expect_failure(self.run_carve("u.vtu", "--simplify", "--vertices", "7"), 2, "--simplify", "meshes")

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

    # Stored streams

    def test_answers_from_a_stored_stream(self):
        """Levels from a file of --stream have the same bytes as the levels of the carving."""
        for option in (("--levels", "4"), ("--vertices", "300,900"), ("--triangles", "700"), ("--step", "0,55"),
                       ("--feature-size", "0.8"), ("--simplify", "--vertices", "60,300"),
                       ("--tunnels", "0,2", "--vertices", "150")):
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
        self.expect_failure(self.run_carve("out.vtu", "--simplify"), 2, "--simplify", "--vertices")
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

    # Errors

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
