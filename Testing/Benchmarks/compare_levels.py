#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compare simplified levels with CGAL's alpha wrap and VTK's quadric decimation at equal numbers of vertices.

usage: compare_levels.py CARVE ALPHA_WRAP FOLDER MESH...

Prints a table in Markdown: distances of the level from the mesh as thousandths of the mesh's diagonal (the largest, and
the mean over the surface), the share of the mesh's vertices that lie outside, the intersection over the union of its
silhouettes and those of the mesh from 26 directions, the pixels of the mesh's silhouettes that are lost, and seconds.
Distances are measured at the level's vertices and at random points of its triangles, so that the largest is a lower
bound. The carved level has at most as many vertices as asked for, or the hull's if these are more. The levels of a mesh
come from one run of carve; the seconds of the run stand beside its first level. FOLDER gets pictures and index.html.
"""
import os
import subprocess
import sys
import tempfile
import time

import numpy as np
from level_pictures import Page, Silhouettes
from mesh_files import to_arrays, write_off
from peers import run_alpha_wrap, run_filter
from show_levels import read_levels
from surfaces import read
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import reference, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation

TARGETS = (200, 500, 1000, 2000, 5000)
SAMPLES = 20000


def to_poly_data(points, triangles):
    data, coordinates, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(coordinates)
    for triangle in triangles:
        cells.InsertNextCell(3, triangle.tolist())
    data.SetPolys(cells)
    return data


def random_points(points, triangles):
    """Points that are evenly distributed over the surface."""
    random = np.random.default_rng(0)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    chosen = random.choice(len(triangles), SAMPLES, p=areas / areas.sum())
    weights = random.dirichlet((1.0, 1.0, 1.0), SAMPLES)
    return sum(weights[:, i:i + 1] * points[triangles[chosen, i]] for i in range(3))


def distances(locator, points):
    closest, cell, sub, squared = [0.0] * 3, reference(0), reference(0), reference(0.0)
    found = []
    for point in points:
        locator.FindClosestPoint(point, closest, cell, sub, squared)
        found.append(float(squared) ** 0.5)
    return np.array(found)


def winding_number(points, triangles, p):
    """How often the surface encloses p: the sum of the solid angles of its triangles."""
    a, b, c = (points[triangles[:, i]] - p for i in range(3))
    x, y, z = (np.linalg.norm(corner, axis=1) for corner in (a, b, c))
    volume = np.einsum("ij,ij->i", a, np.cross(b, c))
    cosine = (x * y * z + np.einsum("ij,ij->i", a, b) * z + np.einsum("ij,ij->i", b, c) * x +
              np.einsum("ij,ij->i", c, a) * y)
    return np.arctan2(volume, cosine).sum() / (2.0 * np.pi)


def locate(points, triangles):
    locator = vtkStaticCellLocator()
    locator.SetDataSet(to_poly_data(points, triangles))
    locator.BuildLocator()
    return locator


def judge(mesh, level):
    """The largest and mean distance as thousandths of the diagonal, and the share of the mesh's vertices outside."""
    points, triangles = level
    locator = locate(*mesh)
    diagonal = np.linalg.norm(mesh[0].max(axis=0) - mesh[0].min(axis=0))
    sampled = distances(locator, random_points(points, triangles))
    largest = max(sampled.max(), distances(locator, points).max())
    vertices = mesh[0][::max(1, len(mesh[0]) // 2000)]
    off = distances(locate(points, triangles), vertices) > 1e-9 * diagonal
    outside = np.mean([far and winding_number(points, triangles, p) < 0.5 for far, p in zip(off, vertices)])
    return 1000.0 * largest / diagonal, 1000.0 * sampled.mean() / diagonal, outside


def run_carve(carve, path, targets, folder, *options):
    """A level for each target, and the seconds of the run."""
    output = os.path.join(folder, "levels.vtm")
    start = time.perf_counter()
    subprocess.run([carve, path, "--vertices", ",".join(map(str, targets)), "-o", output, *options], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    seconds = time.perf_counter() - start
    return [(level, seconds if i == 0 else None) for i, level in enumerate(read_levels(output))]


def wrap(program, path, target, folder):
    output = os.path.join(folder, "wrap.off")
    seconds = run_alpha_wrap(program, path, str(target), output)
    return read(output), seconds


def run_quadric(mesh, target):
    decimation = vtkQuadricDecimation()
    decimation.SetTargetReduction(max(0.0, 1.0 - 2.0 * target / len(mesh[1])))
    seconds = run_filter(decimation, to_poly_data(*mesh))
    points, triangles = to_arrays(decimation.GetOutput())
    used, triangles = np.unique(triangles, return_inverse=True)
    return to_poly_data(points[used].astype(float), triangles.reshape(-1, 3)), seconds


def run_all(carve, alpha_wrap, mesh, targets):
    """The names of the methods, and for each target a surface and its seconds for each method."""
    with tempfile.TemporaryDirectory() as folder:
        # All programs read the same file, which has triangles only.
        plain = os.path.join(folder, "mesh.off")
        write_off(plain, *mesh)
        methods = {
            "carve --simplify": run_carve(carve, plain, targets, folder, "--simplify"),
            "carve": run_carve(carve, plain, targets, folder),
            "alpha wrap": [wrap(alpha_wrap, plain, target, folder) for target in targets],
            "vtkQuadricDecimation": [run_quadric(mesh, target) for target in targets]}
    return list(methods), list(zip(*methods.values()))


def compare(carve, alpha_wrap, path, page):
    mesh = to_arrays(read(path))
    name = os.path.splitext(os.path.basename(path))[0]
    data = to_poly_data(*mesh)
    silhouettes = Silhouettes(data)
    targets = [target for target in TARGETS if 2 * target <= len(mesh[0])]
    methods, rows = run_all(carve, alpha_wrap, mesh, targets)
    surfaces, texts = [], []
    for target, row in zip(targets, rows):
        for method, (surface, seconds) in zip(methods, row):
            largest, mean, outside = judge(mesh, to_arrays(surface))
            overlap, lost = silhouettes.compare(surface)
            vertices = surface.GetNumberOfPoints()
            print(f"| {name} ({len(mesh[0])}) | {target} | {method} | {vertices} | {largest:.2f} | {mean:.3f} | "
                  f"{100.0 * outside:.1f} % | {overlap:.3f} | {lost} | "
                  f"{'' if seconds is None else format(seconds, '.2f')} |", flush=True)
            surfaces.append(surface)
            texts.append(f"{method}, {vertices:,} vertices\nlargest {largest:.1f}, mean {mean:.2f}\n"
                         f"silhouette {overlap:.3f}, {100.0 * outside:.0f} % outside")
    page.add(name, data, surfaces, texts, len(methods))


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    carve, alpha_wrap, folder = sys.argv[1:4]
    page = Page(folder)
    print("| mesh (vertices) | target | method | vertices | largest | mean | outside | silhouettes | lost | seconds |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for path in sys.argv[4:]:
        compare(carve, alpha_wrap, path, page)


if __name__ == "__main__":
    main()
