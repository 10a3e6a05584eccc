#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Render the levels of a carved mesh side by side to a PNG file.

usage: show_levels.py LEVELS.vtm PICTURE.png [--columns N] [--view X Y Z] [--up X Y Z]

Faces of the input mesh are ivory, carved faces are blue. The script needs VTK's Python modules and a display (or
xvfb-run).
"""
import argparse

import vtkmodules.vtkRenderingFreeType  # noqa: F401 (text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (the rendering backend)
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersCore import vtkArrayCalculator
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

TILE = (420, 300)
FONT_SIZE = 17


def read_levels(path):
    reader = vtkXMLMultiBlockDataReader()
    reader.SetFileName(path)
    reader.Update()
    blocks = reader.GetOutput()
    return [blocks.GetBlock(i) for i in range(blocks.GetNumberOfBlocks())]


def make_actor(level):
    """An actor for a level, with different colors for faces of the input and carved faces."""
    kind = vtkArrayCalculator()
    kind.SetInputData(level)
    kind.SetAttributeTypeToCellData()
    kind.AddScalarArrayName("vtkOriginalCellIds")
    kind.SetFunction("vtkOriginalCellIds >= 0")
    kind.SetResultArrayName("IsInput")
    colors = vtkLookupTable()
    colors.SetNumberOfTableValues(2)
    colors.SetTableValue(0, 0.45, 0.62, 0.80, 1.0)
    colors.SetTableValue(1, 0.95, 0.89, 0.76, 1.0)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(kind.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("IsInput")
    mapper.SetLookupTable(colors)
    mapper.SetScalarRange(0, 1)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetAmbient(0.15)
    return actor


def level_text(level):
    vertices = level.GetFieldData().GetArray("Vertices").GetValue(0)  # without the copies that cutting makes
    return f"{vertices:,} vertices, {level.GetNumberOfPolys():,} triangles"


def make_caption(text):
    caption = vtkTextActor()
    caption.SetInput(text)
    caption.GetTextProperty().SetFontSize(FONT_SIZE)
    caption.GetTextProperty().SetColor(0.1, 0.1, 0.1)
    caption.GetTextProperty().SetJustificationToCentered()
    caption.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    caption.SetPosition(0.5, 0.03)
    return caption


def default_view(bounds):
    """A direction that shows the broad side of a mesh, slightly from above and from the side, and the up direction."""
    size = [bounds[2 * i + 1] - bounds[2 * i] for i in range(3)]
    thin = size.index(min(size))
    view = [0.45] * 3
    view[thin] = 1.0
    return view, (0, 0, 1) if thin == 1 else (0, 1, 0)


def place_camera(renderer, bounds, view, up, lines):
    """Fills a tile with a box, above a caption of some lines."""
    center = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(center)
    camera.SetPosition([c + v for c, v in zip(center, view)])
    camera.SetViewUp(up)
    camera.OrthogonalizeViewUp()
    camera.SetViewAngle(20)
    renderer.ResetCameraScreenSpace(bounds)
    camera.Zoom(1.1)  # leaves room for one line
    share = 2.0 * FONT_SIZE * (lines - 1) / TILE[1]
    camera.Zoom(1.0 - share)
    camera.SetWindowCenter(0.0, -share)


def render(levels, columns, view, up, text_of=level_text, actors_of=lambda level: [make_actor(level)], bounds=None):
    """A window with a tile per level. All tiles show the same part of space, by default that of the first level."""
    rows = -(-len(levels) // columns)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(columns * TILE[0], rows * TILE[1])
    bounds = bounds or levels[0].GetBounds()
    automatic = default_view(bounds)
    for i, level in enumerate(levels):
        column, row = i % columns, rows - 1 - i // columns
        renderer = vtkRenderer()
        renderer.SetViewport(column / columns, row / rows, (column + 1) / columns, (row + 1) / rows)
        renderer.SetBackground(1, 1, 1)
        for actor in actors_of(level):
            renderer.AddActor(actor)
        text = text_of(level)
        renderer.AddViewProp(make_caption(text))
        window.AddRenderer(renderer)
        place_camera(renderer, bounds, view or automatic[0], up or automatic[1], 1 + text.count("\n"))
    window.Render()
    return window


def write_picture(window, path):
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("levels")
    parser.add_argument("picture")
    parser.add_argument("--columns", type=int, default=4, help="levels in a row (default 4)")
    parser.add_argument("--view", type=float, nargs=3, help="direction from the mesh to the camera")
    parser.add_argument("--up", type=float, nargs=3, help="direction that points up in the picture")
    arguments = parser.parse_args()
    levels = read_levels(arguments.levels)
    if not levels:
        parser.error(f"{arguments.levels} contains no level")
    window = render(levels, min(arguments.columns, len(levels)), arguments.view, arguments.up)
    write_picture(window, arguments.picture)


if __name__ == "__main__":
    main()
