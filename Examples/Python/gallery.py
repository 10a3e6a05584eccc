#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Render the paper's figures and its table of running times to a folder with an index.html.

usage: gallery.py --models FOLDER --output FOLDER [MESH...]

The folder of models contains the files of carving-model, NAME.off and NAME.vtk; missing models are skipped. Each MESH
(OFF, PLY, OBJ, STL) gets a picture and a row of the table; bones is also rendered as in Figures 1 and 8. The script
needs VTK's Python modules with numpy, topologycarving on PYTHONPATH, and a display (or xvfb-run).
"""
import argparse
import html
import os
import sys

import numpy
from show_levels import make_actor, render, write_picture
from surfaces import clustered, decimated, read, topology
from topologycarving import vtkContourCarver, vtkTopologyCarver
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkContourTriangulator
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

PAPER = {
    "yucca-leaves": ("Yucca leaves", "801", "87", "1.2K", "5.3K", "0.3"),
    "bones": ("Bones", "2,154", "124", "4.2K", "13.9K", "1.3"),
    "tree": ("Scots Pine", "90,125", "151", "61.7K", "595.1K", "847.9"),
}
PAPER_ONLY = [
    ("Mushrooms", "4,515", "282", "9.0K", "30.0K", "3.6"),
    ("Elm", "7,401", "91", "8.5K", "47.4K", "9.5"),
    ("Horse", "19,851", "979", "39.7K", "137.9K", "70.5"),
]
STYLE = """body { font: 16px sans-serif; margin: 2em; max-width: 1700px; } img { max-width: 100%; }
table { border-collapse: collapse; } th, td { padding: .2em .8em; text-align: right; }
th:first-child, td:first-child, .paper { text-align: left; } tr { border-bottom: 1px solid #ccc; }"""


def vertex_count(level):
    """The number of vertices without the copies that make a level manifold."""
    count = level.GetFieldData().GetArray("Vertices")
    return int(count.GetTuple1(0)) if count else level.GetNumberOfPoints()


def surface_text(level):
    components, genus = topology(level)
    genus = "-" if genus is None else f"{genus:,}"
    return (f"{vertex_count(level):,} vertices, {level.GetNumberOfPolys():,} triangles\n"
            f"components {components:,}, genus {genus}")


def contour_text(level):
    return f"{vertex_count(level):,} vertices, {level.GetNumberOfLines():,} edges"


def contour_actors(level):
    """Actors for the inside of a contour and for its edges, which are blue if carved and dark otherwise."""
    inside = vtkContourTriangulator()
    inside.SetInputData(level)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(inside.GetOutputPort())
    mapper.ScalarVisibilityOff()
    fill = vtkActor()
    fill.SetMapper(mapper)
    fill.GetProperty().SetColor(0.95, 0.89, 0.76)
    fill.GetProperty().LightingOff()
    fill.SetPosition(0, 0, -1e-3 * level.GetLength())
    edges = make_actor(level)
    edges.GetMapper().GetLookupTable().SetTableValue(1, 0.35, 0.28, 0.18, 1.0)
    edges.GetProperty().SetLineWidth(2)
    edges.GetProperty().LightingOff()
    return [fill, edges]


def carve(mesh, levels, carver_type=vtkTopologyCarver, **properties):
    """Runs a carver and returns the carver and its levels."""
    carver = carver_type()
    carver.SetInputData(mesh)
    carver.SetNumberOfLevels(levels)
    for name, value in properties.items():
        getattr(carver, "Set" + name)(value)
    carver.Update()
    blocks = carver.GetOutput()
    found = [blocks.GetBlock(i) for i in range(blocks.GetNumberOfBlocks())]
    if not found:
        sys.exit("A model could not be carved; see the error above.")
    return carver, found


class Gallery:
    def __init__(self, folder):
        self.folder = folder
        self.figures = []
        self.rows = []

    def draw(self, name, title, levels, view=None, up=None, **style):
        print(title, flush=True)
        style.setdefault("text_of", surface_text)
        write_picture(render(levels, len(levels), view, up, **style), f"{self.folder}/{name}.png")
        self.figures.append(f'<h2>{html.escape(title)}</h2>\n<img src="{name}.png" alt="">')

    def tabulate(self, name, mesh, carver):
        profile = carver.GetOutputDataObject(2).GetColumnByName("Vertices")
        tetrahedra = int((vtk_to_numpy(carver.GetOutputDataObject(1).GetCellTypesArray()) == VTK_TETRA).sum())
        seconds = sum(carver.GetStageSeconds(i) for i in range(carver.GetNumberOfStages()))
        row = (name, f"{mesh.GetNumberOfPoints():,}", f"{profile.GetValue(0):,}",
               f"{mesh.GetNumberOfPolys():,}", f"{tetrahedra:,}", f"{seconds:.2f}")
        print(*row, sep="\t", flush=True)
        self.rows.append(row + PAPER.get(name, ("",) * 6))

    def surface(self, name, picture, title, mesh, view=None, up=None, **properties):
        carver, found = carve(mesh, 5, **properties)
        if not properties:
            self.tabulate(name, mesh, carver)
        self.draw(picture, title, found, view, up)

    def against_collapse(self, name, mesh):
        """Figure 1, with VTK's filters instead of pair collapse."""
        _, levels = carve(mesh, 8)
        level = min(levels, key=lambda l: abs(l.GetNumberOfPolys() - mesh.GetNumberOfPolys() / 3))
        count = level.GetNumberOfPolys()
        others = []
        for other in (decimated(mesh, count), clustered(mesh, count), mesh):
            shown = vtkPolyData()
            shown.CopyStructure(other)
            ids = numpy_to_vtkIdTypeArray(numpy.zeros(other.GetNumberOfPolys(), numpy.int64), deep=True)
            ids.SetName("vtkOriginalCellIds")
            shown.GetCellData().AddArray(ids)
            others.append(shown)
        self.draw(f"{name}-collapse", f"Figure 1, {name}: carving, vtkQuadricDecimation and "
                  "vtkQuadricClustering at about as many triangles, and the input", [level, *others])

    def contour(self, name, title, mesh, **properties):
        _, found = carve(mesh, 5, vtkContourCarver, **properties)
        self.draw(name, title, found, (0, 0, 1), (0, 1, 0), text_of=contour_text, actors_of=contour_actors)

    def write(self):
        head = "".join(f"<th>{h}</th>" for h in (
            "model", "vertices", "hull vertices", "faces", "tetrahedra of the complement", "time (s)",
            "in the paper", "vertices", "hull vertices", "faces", "tetrahedra", "time (s), at 500 MHz"))
        rows = self.rows + [("",) * 6 + row for row in PAPER_ONLY]
        body = "\n".join("<tr>" + "".join(f"<td>{html.escape(c)}</td>" for c in row) + "</tr>" for row in rows)
        with open(f"{self.folder}/index.html", "w", encoding="utf-8") as file:
            file.write("<!DOCTYPE html>\n<meta charset=\"utf-8\">\n<title>Carving: the figures</title>\n"
                       f"<style>{STYLE}</style>\n<h1>Carving for topology simplification</h1>\n"
                       "<p>Levels from coarse to fine. Carved faces are blue, faces of the input "
                       "are ivory. The genus is given for closed surfaces only.</p>\n"
                       + "\n".join(self.figures)
                       + f"\n<h2>Table 1</h2>\n<table><tr>{head}</tr>\n{body}</table>\n")


# Name, title, view, up direction, and the pictures: for each, its caption and its properties. A BreadthRadius is in
# diagonals of the mesh.
SURFACES = [
    ("two-spheres", "Figure 4: two spheres", None, None, [("", {})]),
    ("eight-spheres", "Figure 10: eight spheres", (0.5, 0.4, 1), (0, 1, 0),
     [("dp = 0", {}), ("dp = 2", {"DepthExponent": 2})]),
    ("yucca-leaves", "Figure 11: yucca leaves", (0.3, -1, 0.4), (0, 0, 1),
     [("bp = 0", {}), ("bp = 3 % of the diagonal", {"BreadthRadius": 0.03})]),
    ("scone", "Figure 12: a scone", None, None, [("", {})]),
    ("ribs", "Figure 13: ribs", None, None, [("", {})]),
    ("tree", "Figure 14: a tree", None, None, [("", {})]),
]
CONTOURS = [
    ("carved-figure", "Figure 5: a jug", [
        ("from the hull", {}),
        ("from the box", {"InitialApproximation": vtkContourCarver.BOUNDING_BOX})]),
    ("snaking-contour", "Figure 9: snaking and spiking", [
        ("dp = 0", {}), ("dp = 2", {"DepthExponent": 2}),
        ("bp = 5 % of the diagonal", {"BreadthRadius": 0.05})]),
]


def scaled(properties, mesh):
    return {n: v * mesh.GetLength() if n == "BreadthRadius" else v for n, v in properties.items()}


def fill(gallery, models, meshes):
    for name, title, pictures in CONTOURS:
        path = f"{models}/{name}.vtk"
        if os.path.exists(path):
            mesh = read(path)
            for i, (said, properties) in enumerate(pictures):
                gallery.contour(f"{name}-{i}", f"{title}, {said}", mesh, **scaled(properties, mesh))
    for path in meshes:
        name = os.path.splitext(os.path.basename(path))[0]
        mesh = read(path)
        gallery.surface(name, name, "Figure 8: bones" if name == "bones" else name, mesh)
        if name == "bones":
            gallery.against_collapse(name, mesh)
    for name, title, view, up, pictures in SURFACES:
        path = f"{models}/{name}.off"
        if os.path.exists(path):
            mesh = read(path)
            for i, (said, properties) in enumerate(pictures):
                gallery.surface(name, f"{name}-{i}" if i else name, f"{title}, {said}" if said else title,
                                mesh, view, up, **scaled(properties, mesh))
            if name == "ribs":
                gallery.against_collapse(name, mesh)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--models", required=True, help="folder of the models from carving-model")
    parser.add_argument("--output", required=True, help="folder for the pictures and index.html")
    parser.add_argument("meshes", nargs="*", metavar="MESH", help="further meshes of triangles")
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    gallery = Gallery(arguments.output)
    fill(gallery, arguments.models, arguments.meshes)
    gallery.write()


if __name__ == "__main__":
    main()
