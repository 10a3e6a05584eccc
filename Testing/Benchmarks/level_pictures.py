# SPDX-License-Identifier: BSD-3-Clause
"""Silhouettes of surfaces, and a page with pictures of levels beside each other, for compare_levels.py."""
import html
import itertools
import os

import numpy as np
from show_levels import render, write_picture
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

PIXELS = 512
ROOM = 1.2  # for levels around the mesh
# To the corners, the middles of the edges and the middles of the faces of a cube.
DIRECTIONS = [d for d in itertools.product((-1, 0, 1), repeat=3) if any(d)]


def view_up(direction):
    return (0, 0, 1) if direction[0] or direction[1] else (0, 1, 0)


def crosses(surface, tolerance):
    """A function that says whether a line from one point to another meets the surface, in double precision."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()

    def meets(begin, end):
        return locator.IntersectWithLine(begin, end, tolerance, reference(0.0), [0.0] * 3, [0.0] * 3, reference(0),
                                         reference(0)) != 0

    return meets


class Silhouettes:
    """The pixels that a mesh covers from 26 directions, in parallel projection."""

    def __init__(self, mesh):
        bounds = np.array(mesh.GetBounds()).reshape(3, 2)
        self.center = bounds.mean(axis=1)
        self.radius = 0.5 * np.linalg.norm(bounds[:, 1] - bounds[:, 0])
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(PIXELS, PIXELS)
        self.renderer = vtkRenderer()
        self.window.AddRenderer(self.renderer)
        self.mesh = mesh
        self.of_mesh = self.draw(mesh)

    def draw(self, surface):
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(surface)
        mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        self.renderer.RemoveAllViewProps()
        self.renderer.AddActor(actor)
        return np.array([self.look(np.array(direction, dtype=float)) for direction in DIRECTIONS])

    def look(self, direction):
        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(ROOM * self.radius)
        camera.SetFocalPoint(self.center)
        camera.SetPosition(self.center + 4.0 * self.radius * direction / np.linalg.norm(direction))
        camera.SetViewUp(view_up(direction))
        camera.SetClippingRange(self.radius, 7.0 * self.radius)
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())[:, 0] > 0

    def line_through(self, direction, pixel):
        """The ends of the line of sight through the middle of a pixel, counted from the lower left one."""
        toward = direction / np.linalg.norm(direction)
        right = np.cross(view_up(direction), toward)
        right /= np.linalg.norm(right)
        x, y = (2.0 * (np.array([pixel % PIXELS, pixel // PIXELS]) + 0.5) / PIXELS - 1.0) * ROOM * self.radius
        middle = self.center + x * right + y * np.cross(toward, right)
        return middle + 3.0 * self.radius * toward, middle - 3.0 * self.radius * toward

    def compare(self, surface):
        """The intersection over the union of all pixels, and the number of pixels of the mesh that are lost.

        A graphics library rounds positions to fractions of a pixel. So a pixel that it has lost counts only if the line
        through its middle meets the mesh, but not the surface.
        """
        other = self.draw(surface)
        of_mesh, of_surface = crosses(self.mesh, 0.0), crosses(surface, 1e-9 * self.radius)
        lost = 0
        for direction, pixels in zip(DIRECTIONS, self.of_mesh & ~other):
            for pixel in np.flatnonzero(pixels):
                line = self.line_through(np.array(direction, dtype=float), pixel)
                lost += of_mesh(*line) and not of_surface(*line)
        return (self.of_mesh & other).sum() / (self.of_mesh | other).sum(), lost


class Page:
    """A folder with a picture for each mesh, a row for each target and a column for each method, and index.html."""

    def __init__(self, folder):
        self.folder = folder
        self.parts = []
        os.makedirs(folder, exist_ok=True)

    def add(self, name, mesh, surfaces, texts, columns):
        for surface in surfaces:
            if not surface.GetCellData().HasArray("vtkOriginalCellIds"):
                ids = numpy_to_vtkIdTypeArray(np.full(surface.GetNumberOfCells(), -1), deep=True)
                ids.SetName("vtkOriginalCellIds")
                surface.GetCellData().AddArray(ids)
        text_of = dict(zip(map(id, surfaces), texts))
        window = render(surfaces, columns, None, None, text_of=lambda surface: text_of[id(surface)],
                        bounds=mesh.GetBounds())
        write_picture(window, f"{self.folder}/{name}.png")
        self.parts.append(f'<h2>{html.escape(name)}</h2>\n<img src="{name}.png" alt="levels of {html.escape(name)}">')
        with open(f"{self.folder}/index.html", "w", encoding="utf-8") as file:
            file.write('<!DOCTYPE html>\n<meta charset="utf-8">\n<title>Levels beside those of other programs</title>\n'
                       "<style>body { font: 16px sans-serif; margin: 2em; } img { max-width: 100%; }</style>\n"
                       "<h1>Levels beside those of other programs</h1>\n<p>Faces of the input are ivory, all others "
                       "blue. Distances are thousandths of the mesh's diagonal.</p>\n" + "\n".join(self.parts) + "\n")
