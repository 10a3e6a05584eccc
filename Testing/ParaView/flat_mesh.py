# SPDX-License-Identifier: BSD-3-Clause
"""Carves a flat mesh, which fails, and then another mesh, which succeeds."""
from paraview import simple
from scene import counts, open_model

flat = simple.TopologyCarver(Input=simple.Triangulate(Input=simple.Plane()))
assert counts(flat) == (0, 0)
carver = simple.TopologyCarver(Input=open_model("two-spheres.ply"))
assert counts(carver)[1] > 0
print("carved the next mesh")
