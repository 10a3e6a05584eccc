# SPDX-License-Identifier: BSD-3-Clause
"""The files that the command-line program reads.

carve_testing.py names the environment variables.
"""
import gzip
import json
import math
import shutil
import struct
import unittest

from carve_testing import BONES, CarveTestCase, read
from meshes import two_cubes
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_LINE, vtkCompositeDataSet, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkConvertToPartitionedDataSetCollection
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOParallelXML import vtkXMLPartitionedDataSetCollectionWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader, vtkXMLMultiBlockDataWriter, vtkXMLPolyDataWriter


def cubes(number):
    """One cube, or two."""
    source = vtkCubeSource() if number == 1 else two_cubes()
    source.Update()
    return source.GetOutput()


class TestCarveReaders(CarveTestCase):
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

    def test_reads_ply_that_ends_within_a_line(self):
        """The last line of a text may lack its line feed."""
        text = (b"ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                b"element face 4\nproperty list uchar int vertex_indices\nend_header\n"
                b"0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3")
        with open(self.path("tetrahedron.ply"), "wb") as file:
            file.write(text)
        self.assertEqual(self.table("tetrahedron.ply"), [(0, 0, 4, 4, 1, 0, 0)])

    def test_refuses_scenes_without_polygons(self):
        """A scene of lines is refused like a single mesh of lines."""
        line = vtkPolyData()
        points = vtkPoints()
        points.InsertNextPoint(0.0, 0.0, 0.0)
        points.InsertNextPoint(1.0, 0.0, 0.0)
        line.SetPoints(points)
        line.AllocateEstimate(1, 2)
        line.InsertNextCell(VTK_LINE, 2, [0, 1])
        scene = vtkMultiBlockDataSet()
        scene.SetBlock(0, line)
        writer = vtkXMLMultiBlockDataWriter()
        writer.SetFileName(self.path("lines.vtm"))
        writer.SetInputData(scene)
        self.assertEqual(writer.Write(), 1)
        for options in ((), ("--stream", "s.vtu"), ("--decimate",)):
            self.expect_failure(self.run_carve("lines.vtm", *options), 1, "it holds lines and no polygon")

    def test_reads_off(self):
        """OFF files may have comments, polygons, colors, and counts in the line of the header."""
        with open(self.path("pyramid.off"), "w", encoding="ascii") as file:
            file.write("COFF 5 5 0 # counts\n# points\n0 0 0 255 0 0\n1 0 0 0 0 0\n\n1 1 0 1 1 1\n0 1 0 0 0 0\n"
                       ".5 .5 1e0 0 0 0\n4 3 2 1 0\n3 0 1 4 0.1 0.2 0.3\n3 1 2 4\n3 2 3 4\n3 3 0 4\n")
        # A pyramid is convex: its only level has its five vertices, four sides and two halves of the base.
        self.assertEqual(self.table("pyramid.off"), [(0, 0, 5, 6, 1, 0, 0)])

    def test_reads_scenes(self):
        """The meshes of .vtm and .vtpc files are carved one by one, under the names of their blocks."""
        inner, outer = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
        for tree, name, block in ((inner, "left", cubes(1)), (inner, "right", cubes(2)), (outer, "pair", inner),
                                  (outer, "empty", vtkPolyData()), (outer, 'o"dd', cubes(1))):
            tree.SetBlock(tree.GetNumberOfBlocks(), block)
            tree.GetMetaData(tree.GetNumberOfBlocks() - 1).Set(vtkCompositeDataSet.NAME(), name)
        outer.SetBlock(4, cubes(1))  # without a name
        convert = vtkConvertToPartitionedDataSetCollection()
        convert.SetInputDataObject(outer)
        convert.Update()
        self.write(vtkXMLMultiBlockDataWriter, "in.vtm", outer)
        self.write(vtkXMLPartitionedDataSetCollectionWriter, "in.vtpc", convert.GetOutput())
        for name, blocks in (("in.vtm", ["pair/left", "pair/right", 'o"dd', "Block 3"]),
                             ("in.vtpc", ["left", "right", 'o"dd', "Block 3"])):
            run = self.run_carve(name, "-o", "out.vtm", "--json", "-")
            self.assertEqual(run.returncode, 0, run.stderr)
            things = json.loads(run.stdout)["objects"]
            self.assertEqual([thing["block"] for thing in things], blocks)
            last = [thing["levels"][-1]["triangles"] for thing in things]
            self.assertEqual(last, [12, 24, 12, 12])  # 12 triangles per cube
            scene = read(vtkXMLMultiBlockDataReader, self.path("out.vtm"))
            names = [scene.GetMetaData(i).Get(vtkCompositeDataSet.NAME()) for i in range(scene.GetNumberOfBlocks())]
            self.assertEqual(names, blocks)
        self.assertIn("in.vtm: pair/right", self.run_carve("in.vtm").stdout)
        for options, word in ((("--decimate",), "--decimate"), (("--stream", "a.vtu"), "--stream"),
                              (("--profile", "a.csv"), "--profile"), (("-o", "a.ply"), ".vtpc")):
            self.expect_failure(self.run_carve("in.vtm", *options), 1, "in.vtm has several meshes", word)
        self.expect_failure(self.run_carve(BONES, "--initial-mesh", "in.vtm"), 1, "single mesh")

    def test_reads_gltf(self):
        """Every node with a mesh is a mesh, with all parts of it and where the scene places it."""
        points = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        faces = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6),
                 (0, 6, 4), (1, 5, 7), (1, 7, 3)]
        content = struct.pack("<24f36I", *sum(points, ()), *sum(faces, ()))
        views = ((0, 96), (96, 72), (168, 72))  # the points, and two halves of the faces, as of two materials
        accessors = [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0],
                      "max": [1, 1, 1]}]
        accessors += [{"bufferView": i, "componentType": 5125, "count": 18, "type": "SCALAR"} for i in (1, 2)]
        document = {
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"name": "car", "children": [1, 2]}, {"name": 'wheel "left"', "mesh": 0},
                      {"mesh": 0, "translation": [9, 0, 0]}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": i} for i in (1, 2)]}],
            "buffers": [{"byteLength": len(content), "uri": "car.bin"}],
            "bufferViews": [{"buffer": 0, "byteOffset": start, "byteLength": size} for start, size in views],
            "accessors": accessors}
        with open(self.path("car.bin"), "wb") as file:
            file.write(content)
        with open(self.path("car.gltf"), "w", encoding="ascii") as file:
            json.dump(document, file)
        run = self.run_carve("car.gltf", "--json", "-", "-o", "out.vtm")
        things = json.loads(run.stdout)["objects"]
        self.assertEqual([thing["block"] for thing in things], ['car/wheel "left"', "car/Node_2"])
        self.assertEqual([(level["vertices"], level["triangles"]) for thing in things for level in thing["levels"]],
                         [(8, 12), (8, 12)])  # a cube is its own hull
        scene = read(vtkXMLMultiBlockDataReader, self.path("out.vtm"))
        self.assertEqual(scene.GetBlock(1).GetBlock(0).GetBounds(), (9.0, 10.0, 0.0, 1.0, 0.0, 1.0))
        self.table(BONES, "--levels", "1", "-o", "bones.glb")  # one mesh, hence no scene
        self.assertEqual(self.table("bones.glb", "--levels", "1")[0][2:4], self.table(BONES, "--levels", "1")[0][2:4])

    def test_reads_infinite_vectors(self):
        """A point data vector that is infinite does not keep a mesh from being read, although VTK complains of it."""
        mesh = cubes(1)
        vectors = vtkDoubleArray()
        vectors.SetName("velocity")
        vectors.SetNumberOfComponents(3)
        for i in range(mesh.GetNumberOfPoints()):
            vectors.InsertNextTuple3(math.inf if i == 0 else 0.0, 1.0, 0.0)
        vectors.GetRange(-1)  # the range of lengths is kept, and written
        mesh.GetPointData().AddArray(vectors)
        with open(self.write(vtkXMLPolyDataWriter, "cube.vtp", mesh), "rb") as file:
            self.assertIn(b"L2_NORM_RANGE", file.read())
        run = self.run_carve("cube.vtp")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stderr, "")

    CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    SIDES = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]

    def cube_as_obj(self, begin="", break_line=""):
        """A unit cube; `begin` precedes the first line, and `break_line` the last corner of each face."""
        lines = ["v {} {} {}".format(*corner) for corner in self.CUBE]
        lines += ["f {} {} {} {}{}".format(*side[:3], break_line, side[3]) for side in self.SIDES]
        return begin + "\n".join(lines) + "\n"

    def test_reads_unusual_obj(self):
        """OBJ files may begin with a byte order mark, lines end with comments, and a backslash continue them."""
        for text in (self.cube_as_obj(begin="\ufeff"), self.cube_as_obj(break_line="\\\n"),
                     self.cube_as_obj(begin="\ufeff", break_line="\\\r\n"),
                     "# a cube\n" + self.cube_as_obj().replace("\n", " # a line\n")):
            with open(self.path("cube.obj"), "w", encoding="utf-8", newline="") as file:
                file.write(text)
            run = self.run_carve("cube.obj")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertEqual(self.table("cube.obj"), [(0, 0, 8, 12, 1, 0, 0)])  # a cube is its own hull

    def test_reads_unusual_stl(self):
        """Text is no binary STL file that ends early, whatever its case is, and behind empty lines."""
        name = self.path("cubes.stl")
        self.write_cubes(vtkSTLWriter, "cubes.stl")
        with open(name, encoding="ascii") as file:
            text = file.read()
        self.assertTrue(text.startswith("solid"))
        for unusual in (text.upper(), "\n \n" + text):
            with open(name, "w", encoding="ascii") as file:
                file.write(unusual)
            run = self.run_carve("cubes.stl")
            self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_refuses_ply_with_elements_before_faces(self):
        """A PLY file with edges before its faces, which the reader would take for faces, is refused."""
        corners = "".join("{} {} {}\n".format(*corner) for corner in self.CUBE)
        faces = "".join("4 {} {} {} {}\n".format(*(i - 1 for i in side)) for side in self.SIDES)
        head = "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
        face_head = "element face 6\nproperty list uchar int vertex_indices\n"
        edge_head = "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
        contents = (head + face_head + edge_head + "end_header\n" + corners + faces + "0 1\n",
                    head + edge_head + face_head + "end_header\n" + corners + "0 1\n" + faces)
        for i, content in enumerate(contents):
            with open(self.path("edges{}.ply".format(i)), "w", encoding="ascii") as file:
                file.write(content)
        self.assertEqual(self.table("edges0.ply"), [(0, 0, 8, 12, 1, 0, 0)])
        self.expect_failure(self.run_carve("edges1.ply"), 1, "edges1.ply", '1 elements "edge"')

    def test_refuses_off_that_is_not_plain(self):
        """Binary OFF files, and those with four coordinates, are refused instead of misread."""
        for header, word in (("OFF BINARY", "binary"), ("4OFF", "OFF"), ("nOFF", "OFF")):
            with open(self.path("other.off"), "w", encoding="ascii") as file:
                file.write(header + "\n3 1 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n")
            self.expect_failure(self.run_carve("other.off"), 1, "other.off", word)


if __name__ == "__main__":
    unittest.main()
