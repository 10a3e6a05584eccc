# SPDX-License-Identifier: BSD-3-Clause
"""Several inputs of the command-line program, and the files that it writes.

carve_testing.py names the environment variables.
"""
import glob
import json
import math
import os
import shutil
import struct
import unittest

from carve_testing import BONES, CarveTestCase, read
from vtkmodules.vtkCommonCore import VTK_FLOAT
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import (
    vtkXMLMultiBlockDataReader, vtkXMLPartitionedDataSetCollectionReader, vtkXMLPolyDataReader)

COLUMNS = ("step", "vertices", "triangles", "components", "tunnels", "voids")


def read_glb(name):
    """The JSON document of a binary glTF file, and the content of its buffer."""
    with open(name, "rb") as file:
        content = file.read()
    magic, version, length, size, kind = struct.unpack("<4sIII4s", content[:20])
    assert (magic, version, length, kind) == (b"glTF", 2, len(content), b"JSON")
    binary_size, binary_kind = struct.unpack("<I4s", content[20 + size:28 + size])
    assert (binary_kind, binary_size) == (b"BIN\0", len(content) - 28 - size)
    return json.loads(content[20:20 + size]), content[28 + size:]


def numbers_of(document, content, accessor):
    """The vectors of an accessor, or its indices in threes."""
    accessor = document["accessors"][accessor]
    view = document["bufferViews"][accessor["bufferView"]]
    kind = {5126: "f", 5125: "I"}[accessor["componentType"]]
    count = accessor["count"] * {"VEC3": 3, "SCALAR": 1}[accessor["type"]]
    assert view["byteLength"] == 4 * count
    numbers = struct.unpack_from(f"<{count}{kind}", content, view["byteOffset"])
    return list(zip(*[iter(numbers)] * 3))


class TestCarveFiles(CarveTestCase):
    # Several inputs

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
        for name in ("scene.vtm", "scene.vtpc", "scene.glb", "folder/"):
            run = self.run_carve(flat, BONES, "-o", name)
            self.expect_failure(run, 1, "plane")
            self.assertIn("flat.off: no levels", run.stdout)
        scene = read(vtkXMLMultiBlockDataReader, self.path("scene.vtm"))
        self.assertEqual(scene.GetBlock(1).GetNumberOfBlocks(), 8)
        collection = read(vtkXMLPartitionedDataSetCollectionReader, self.path("scene.vtpc"))
        self.assertEqual(collection.GetNumberOfPartitionedDataSets(), 8)
        nodes = read_glb(self.path("scene.glb"))[0]["nodes"]
        self.assertEqual(sum("mesh" in node for node in nodes), 8)
        self.assertEqual(sorted(os.listdir(self.path("folder"))), ["bones", "bones.vtm"])

    def test_refuses_what_several_inputs_exclude(self):
        """Options and formats for a single input are a mistake with several ones."""
        for arguments, word in ((("--decimate",), "--decimate"), (("--stream", "a.vtu"), "--stream"),
                                (("--profile", "a.csv"), "--profile"), (("-o", "a.ply"), "a/")):
            self.expect_failure(self.run_carve(BONES, BONES, *arguments), 2, "several inputs", word)

    def test_writes_a_folder(self):
        """-o FOLDER/ writes one result per input, named after it, in the given format."""
        cubes = self.write_cubes(vtkSTLWriter, "cubes.v2.stl")
        for options, names in (((), ["bones.vtm", "cubes.v2.vtm"]),
                               (("--format", "glb"), ["bones.glb", "cubes.v2.glb"]),
                               (("--format", "ply"), ["bones_0.ply", "cubes.v2_0.ply"])):
            folder = "-".join(("new", *options)) + "/"
            run = self.run_carve(BONES, cubes, "--levels", "1", "-o", folder, *options)
            self.assertEqual(run.returncode, 0, run.stderr)
            files = [entry.name for entry in os.scandir(self.path(folder)) if entry.is_file()]
            self.assertEqual(sorted(files), names)
        os.mkdir(self.path("there"))
        self.table(BONES, "--levels", "2", "-o", "there")
        self.assertEqual(read(vtkXMLMultiBlockDataReader, self.path("there/bones.vtm")).GetNumberOfBlocks(), 2)
        self.expect_failure(self.run_carve(BONES, BONES, "-o", "there"), 2, "there/bones.vtm", "both")
        self.expect_failure(self.run_carve(BONES, "-o", "a.vtm", "--format", "ply"), 2, "--format", "FOLDER/")
        self.expect_failure(self.run_carve(BONES, "-o", "there", "--format", "doc"), 2, "--format doc", ".vtm")

    # Output files

    def test_writes_a_multiblock(self):
        """-o OUT.vtm writes all levels with their arrays."""
        self.table(BONES, "-o", "out.vtm", "--levels", "3")
        levels = read(vtkXMLMultiBlockDataReader, self.path("out.vtm"))
        self.assertEqual(levels.GetNumberOfBlocks(), 3)
        level = levels.GetBlock(2)
        self.assertIsNotNone(level.GetCellData().GetArray("vtkOriginalCellIds"))
        self.assertEqual(level.GetFieldData().GetArray("Vertices").GetValue(0), level.GetNumberOfPoints())

    def test_writes_a_collection(self):
        """-o OUT.vtpc writes the same levels as OUT.vtm, and an assembly with the names of the inputs."""
        cubes = self.write_cubes(vtkSTLWriter, 'cu"bes.stl')
        for name in ("out.vtm", "out.vtpc"):
            self.assertEqual(self.run_carve(BONES, cubes, "--levels", "3", "-o", name).returncode, 0)
        scene = read(vtkXMLMultiBlockDataReader, self.path("out.vtm"))
        collection = read(vtkXMLPartitionedDataSetCollectionReader, self.path("out.vtpc"))
        levels = [scene.GetBlock(i).GetBlock(k) for i in range(2)
                  for k in range(scene.GetBlock(i).GetNumberOfBlocks())]
        self.assertEqual(collection.GetNumberOfPartitionedDataSets(), len(levels))
        for i, level in enumerate(levels):
            same = collection.GetPartition(i, 0)
            for array, other in ((level.GetPoints().GetData(), same.GetPoints().GetData()),
                                 (level.GetPolys().GetConnectivityArray(), same.GetPolys().GetConnectivityArray())):
                self.assertEqual(bytes(memoryview(array)), bytes(memoryview(other)))
            self.assertEqual(collection.GetMetaData(i).Get(vtkCompositeDataSet.NAME()), f"LOD {i % 3}")
        assembly = collection.GetDataAssembly()
        labels = [assembly.GetAttributeOrDefault(node, "label", "") for node in assembly.GetChildNodes(0, False)]
        self.assertEqual(labels, ["bones.off", 'cu"bes.stl'])

    def test_writes_gltf(self):
        """-o OUT.glb writes a node for each level, with its name, its numbers as extras, and unit normals."""
        rows = self.table(BONES, "-o", "out.glb", "--levels", "3")
        document, content = read_glb(self.path("out.glb"))
        self.assertEqual([node["name"] for node in document["nodes"]], ["LOD 0", "LOD 1", "LOD 2"])
        self.assertEqual(document["scenes"], [{"nodes": [0, 1, 2]}])
        for row, node in zip(rows, document["nodes"]):
            self.assertEqual(tuple(node["extras"][key] for key in COLUMNS), row[1:])
            primitive, = document["meshes"][node["mesh"]]["primitives"]
            points = numbers_of(document, content, primitive["attributes"]["POSITION"])
            normals = numbers_of(document, content, primitive["attributes"]["NORMAL"])
            corners = numbers_of(document, content, primitive["indices"])
            self.assertEqual(len(corners), row[3])
            self.assertEqual(max(max(corner) for corner in corners) + 1, len(points))
            self.assertEqual(len(normals), len(points))
            for normal in normals:
                self.assertAlmostEqual(math.hypot(*normal), 1.0, places=5)
        # The hull is convex: all of its triangles are seen from outside.
        points = numbers_of(document, content, 0)
        center = [sum(column) / len(points) for column in zip(*points)]
        for corner in numbers_of(document, content, 2):
            a, b, c = ([x - y for x, y in zip(points[i], center)] for i in corner)
            self.assertGreater(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                               + a[2] * (b[0] * c[1] - b[1] * c[0]), 0.0)

    def test_writes_gltf_of_several_inputs(self):
        """In a .glb file, the levels of each of several inputs are children of a node with the input's name."""
        cubes = self.write_cubes(vtkSTLWriter, 'cu"bes.stl')
        self.assertEqual(self.run_carve(BONES, cubes, "--levels", "2", "-o", "out.glb").returncode, 0)
        document, _ = read_glb(self.path("out.glb"))
        roots = [document["nodes"][i] for i in document["scenes"][0]["nodes"]]
        self.assertEqual([(root["name"], [document["nodes"][i]["name"] for i in root["children"]]) for root in roots],
                         [("bones.off", ["LOD 0", "LOD 1"]), ('cu"bes.stl', ["LOD 0", "LOD 1"])])

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
            # Since VTK 9.3, coordinates of OBJ files stay doubles.
            rounds = extension != ".obj" or read(
                vtkOBJReader, self.path("out_0.obj")).GetPoints().GetDataType() == VTK_FLOAT
            self.assertEqual("rounding" in run.stderr, rounds)
        run = self.run_carve("close.off", "-o", "out.vtp", "--levels", "1")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        run = self.run_carve(BONES, "-o", "out.ply", "--levels", "1")
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_writes_names_that_can_be_read(self):
        """Levels stay readable if the OBJ file has material names in another encoding."""
        with open(self.path("latin.obj"), "wb") as file:
            file.write(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nusemtl Terr\xe6n\n")
            for a, b, c in ((1, 3, 2), (1, 2, 4), (2, 3, 4), (3, 1, 4)):
                file.write(b"f %d/1 %d/1 %d/1\n" % (a, b, c))
        self.assertEqual(self.run_carve("latin.obj", "-o", "levels.vtm").returncode, 0)
        level = read(vtkXMLMultiBlockDataReader, self.path("levels.vtm")).GetBlock(0)
        self.assertEqual(level.GetNumberOfPolys(), 4)

    def test_writes_json(self):
        """--json writes the table as numbers, with the notes, files and seconds; unknown numbers are null."""
        name = self.path('bo"n\\es \N{SNOWMAN}.off')
        shutil.copy(BONES, name)
        rows = self.table(name, "--levels", "3", "-o", "out.vtm", "--json", "out.json")
        with open(self.path("out.json"), encoding="utf-8") as file:
            report = json.load(file)
        thing, = report["objects"]
        self.assertEqual((thing["input"], thing["block"]), (name, None))
        self.assertEqual([tuple(level[key] for key in ("level", *COLUMNS)) for level in thing["levels"]], rows)
        self.assertEqual({level["error"] for level in thing["levels"]}, {None})
        self.assertEqual((report["files"], report["errors"], report["warnings"]), (["out.vtm"], [], []))
        self.assertRegex(thing["notes"][0], "^366 pairs")  # 366 crossing pairs: CGAL's own count
        self.assertGreater(report["seconds"]["carve"], 0.0)
        run = self.run_carve(name, "--levels", "1", "--compute-error", "on", "--json", "-")
        level, = json.loads(run.stdout)["objects"][0]["levels"]
        self.assertEqual((level["error"], level["feature_size"] >= 0.0), (0.0, True))  # the last level is the mesh

    def test_writes_json_of_several_inputs(self):
        """--json has an object for each input and block, and the errors of those without levels."""
        with open(self.path("flat.off"), "w", encoding="ascii") as file:
            file.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        self.assertEqual(self.run_carve(BONES, "--levels", "3", "-o", "bones.vtm").returncode, 0)
        run = self.run_carve("flat.off", "bones.vtm", "--levels", "2", "--json", "-")
        self.expect_failure(run, 1, "plane")
        report = json.loads(run.stdout)
        self.assertEqual([(thing["input"], thing["block"], len(thing["levels"])) for thing in report["objects"]],
                         [("flat.off", None, 0), ("bones.vtm", "LOD 0", 1), ("bones.vtm", "LOD 1", 2),
                          ("bones.vtm", "LOD 2", 2)])
        self.assertRegex(report["errors"][0], "plane")


if __name__ == "__main__":
    unittest.main()
