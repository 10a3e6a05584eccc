# SPDX-License-Identifier: BSD-3-Clause
"""How figures grow with the size of a mesh."""
import numpy as np

SMALLEST = 10000  # vertices: below, starting a program counts


def families(meshes):
    """The generated meshes of each kind, by the name before the size."""
    found = {}
    for mesh in meshes:
        kind, _, size = mesh.name.rpartition("-")
        if size.isdigit():
            found.setdefault(kind, []).append(mesh)
    return found


def exponent(meshes, figure):
    """The exponent of the power of the vertices that fits a figure best (least squares in logarithms), or None."""
    pairs = [(mesh.vertices, mesh.median(figure)) for mesh in meshes if mesh.vertices >= 0.9 * SMALLEST]
    if len(pairs) < 2 or any(not value for _, value in pairs):
        return None
    x, y = np.log(np.array(pairs, dtype=float)).T
    return np.polyfit(x, y, 1)[0]
