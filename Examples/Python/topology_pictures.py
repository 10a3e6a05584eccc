#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Render the pictures of Filters/TOPOLOGY.md to a folder.

usage: topology_pictures.py CHEESE.off SCONE.off FOLDER

CHEESE.off is the mesh of that name from Debian's package libcgal-demo, SCONE.off a model from carving-model. The carver
counts all numbers in the pictures. The script needs VTK's Python modules, topologycarving on PYTHONPATH, and a display
(or xvfb-run).
"""
import sys

from show_levels import make_actor, render, write_picture
from surfaces import read
from topologycarving import vtkTopologyCarver
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkPlane
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData,
    vtkCleanPolyData,
    vtkClipPolyData,
    vtkPolyDataConnectivityFilter,
    vtkReverseSense,
    vtkThreshold,
    vtkTriangleFilter,
)
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkParametricFunctionSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkProperty

SOLID = (0.95, 0.89, 0.76)
PIECES = [(0.55, 0.68, 0.85), (0.92, 0.66, 0.52), (0.60, 0.78, 0.60), (0.90, 0.82, 0.50)]


def output(algorithm):
    algorithm.Update()
    return algorithm.GetOutput()


def joined(*meshes):
    append = vtkAppendPolyData()
    for mesh in meshes:
        append.AddInputData(mesh)
    return output(append)


def sphere(x, radius):
    source = vtkSphereSource()
    source.SetCenter(x, 0, 0)
    source.SetRadius(radius)
    source.SetThetaResolution(48)
    source.SetPhiResolution(24)
    return output(source)


def flipped(mesh):
    reverse = vtkReverseSense()
    reverse.SetInputData(mesh)
    return output(reverse)


def box(x, y, z):
    """A box, given by its range along each axis."""
    source = vtkCubeSource()
    source.SetBounds(*x, *y, *z)
    triangles = vtkTriangleFilter()
    triangles.SetInputData(output(source))
    return output(triangles)


def moved(mesh, *offset):
    transform = vtkTransform()
    transform.Translate(*offset)
    shift = vtkTransformPolyDataFilter()
    shift.SetTransform(transform)
    shift.SetInputData(mesh)
    return output(shift)


def centered(mesh):
    return moved(mesh, *(-c for c in mesh.GetCenter()))


def torus():
    shape = vtkParametricTorus()
    shape.SetRingRadius(0.85)
    shape.SetCrossSectionRadius(0.35)
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(shape)
    source.SetUResolution(48)
    source.SetVResolution(24)
    seams = vtkCleanPolyData()  # both ends of each direction differ by rounding
    seams.SetTolerance(1e-6)
    seams.SetInputConnection(source.GetOutputPort())
    return output(seams)


def frame():
    """The frame of a cube, made of the outer blocks along the edges of 5 x 5 x 5 blocks."""
    image = vtkImageData()
    image.SetDimensions(6, 6, 6)
    image.SetOrigin(-1, -1, -1)
    image.SetSpacing(0.4, 0.4, 0.4)
    filled = vtkUnsignedCharArray()
    filled.SetName("filled")
    for k in range(5):
        for j in range(5):
            for i in range(5):
                filled.InsertNextValue(sum(c in (0, 4) for c in (i, j, k)) >= 2)
    image.GetCellData().SetScalars(filled)
    blocks = vtkThreshold()
    blocks.SetInputData(image)
    blocks.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "filled")
    blocks.SetUpperThreshold(1)
    blocks.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputConnection(blocks.GetOutputPort())
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(surface.GetOutputPort())
    return output(triangles)


def ring():
    """Four cubes around a square, each of which touches two others in an edge."""
    places = ((0, 1), (1, 0), (1, 2), (2, 1))
    return moved(joined(*(box((x, x + 1), (y, y + 1), (0, 1)) for x, y in places)), -1.5, -1.5, -0.5)


def levels(mesh, kind=None, targets=(), measure=vtkTopologyCarver.LONGEST_EDGE):
    """One level for each target; without targets, the last level."""
    carver = vtkTopologyCarver()
    carver.SetInputData(mesh)
    carver.SetConformity(carver.EXACT)
    carver.SetPriorityMeasure(measure)
    carver.SetNumberOfLevels(1)
    if kind is not None:
        carver.SetLevelTargetType(kind)
    for target in targets:
        carver.AddLevelTarget(target)
    carver.Update()
    blocks = carver.GetOutput()
    return [blocks.GetBlock(i) for i in range(blocks.GetNumberOfBlocks())]


def number(level, name):
    return int(level.GetFieldData().GetArray(name).GetTuple1(0))


def counted(count, name):
    return f"{count} {name}" + ("" if count == 1 else "s")


def closed_text(level):
    return ", ".join(counted(number(level, name), word) for name, word in (
        ("Components", "component"), ("Tunnels", "tunnel"), ("Voids", "void")))


def plain_actor(mesh, color):
    """Back faces are visible only where a solid is cut open. They are plain dark red."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetAmbient(0.15)
    actor.GetProperty().SetDiffuse(0.85)
    back = vtkProperty()
    back.SetColor(0.65, 0.25, 0.2)
    back.SetAmbient(1)
    back.SetDiffuse(0)
    actor.SetBackfaceProperty(back)
    return actor


def opened_actors(level):
    """Cuts a level with voids open to show its inside."""
    if number(level, "Voids") == 0:
        return [plain_actor(level, SOLID)]
    plane = vtkPlane()
    plane.SetNormal(-0.4, 0, -1)
    clip = vtkClipPolyData()
    clip.SetClipFunction(plane)
    clip.SetInputData(level)
    return [plain_actor(output(clip), SOLID)]


def piece_actors(level):
    """The components of the surface, moved apart."""
    actors = []
    regions = vtkPolyDataConnectivityFilter()
    regions.SetInputData(level)
    regions.SetExtractionModeToSpecifiedRegions()
    for i in range(number(level, "SurfaceComponents")):
        regions.InitializeSpecifiedRegionList()
        regions.AddSpecifiedRegion(i)
        used = vtkCleanPolyData()  # removes the points of the other regions
        used.PointMergingOff()
        used.SetInputConnection(regions.GetOutputPort())
        center = output(used).GetCenter()
        actors.append(plain_actor(moved(used.GetOutput(), 0.12 * center[0], 0.12 * center[1], 0), PIECES[i % 4]))
    return actors


def surface_text(level):
    return (f"surface: {counted(number(level, 'SurfaceComponents'), 'component')}, "
            f"genus {number(level, 'SurfaceGenus')}")


def draw(path, shown, columns, view, up, text_of=closed_text, actors_of=lambda level: [make_actor(level)]):
    bounds = [1.22 * b for b in shown[0].GetBounds()]  # room for captions; all shapes are centered at the origin
    write_picture(render(shown, columns, view, up, text_of, actors_of, bounds), path)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    cheese, scone, folder = sys.argv[1:]

    shapes = [sphere(0, 1.2), joined(sphere(-0.75, 0.65), sphere(0.75, 0.65)), torus(),
              frame(), joined(sphere(0, 1.2), flipped(sphere(0, 0.8)))]
    shapes.append(joined(shapes[-1], sphere(0, 0.4)))
    carved = [levels(shape)[0] for shape in shapes]
    draw(f"{folder}/topology-numbers.png", carved, 3, (0.35, 0.3, 1), (0, 1, 0), actors_of=opened_actors)

    touching = levels(ring())[0]
    texts = iter([lambda level: "closed: " + closed_text(level), surface_text])
    actors = iter([lambda level: [plain_actor(level, SOLID)], piece_actors])
    draw(f"{folder}/topology-cut.png", [touching, touching], 2, (0.15, -0.25, 1), (0, 1, 0),
         text_of=lambda level: next(texts)(level), actors_of=lambda level: next(actors)(level))

    mesh = centered(read(cheese))
    found = levels(mesh, vtkTopologyCarver.TUNNELS, (0, 10, 50)) + levels(mesh)
    draw(f"{folder}/topology-targets.png", found, 4, None, None, text_of=lambda level: counted(
        number(level, "Tunnels"), "tunnel") + f", {level.GetNumberOfPolys():,} triangles")

    mesh = centered(read(scone))
    sizes = (0.4, 0.2, 0.15, 0.1)
    found = levels(mesh, vtkTopologyCarver.FEATURE_SIZE, sizes, vtkTopologyCarver.CIRCUMRADIUS)
    names = iter(sizes)
    draw(f"{folder}/topology-widths.png", found, 4, None, None, text_of=lambda level:
         f"closed below {next(names)}: {counted(number(level, 'Tunnels'), 'tunnel')}")


if __name__ == "__main__":
    main()
