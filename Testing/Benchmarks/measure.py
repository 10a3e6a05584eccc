# SPDX-License-Identifier: BSD-3-Clause
"""Measuring one mesh: carve, and the other programs beside it."""
import dataclasses
import os
import re
import statistics

import peers
from mesh_files import write_plain
from processes import run

WRAPS = ("d/20", "d/50", "d/100")
BUDGET = ("--maximum-components", "1", "--maximum-tunnels", "0", "--maximum-voids", "0")
PATIENCE = 3600.0  # seconds for one program
AFTER_TETGEN = ("transfer", "classify", "carve", "measure", "output", "write")


@dataclasses.dataclass
class Programs:
    carve: str
    alpha_wrap: str


class Mesh:
    """A measured mesh. A sample has the figures of one repetition by name: seconds, or bytes for those of memory."""

    def __init__(self, name, vertices):
        self.name = name
        self.vertices = vertices
        self.tetrahedra = self.strategy = self.tetgen_tetrahedra = None
        self.samples = []

    def median(self, figure):
        """The median of a figure, which is a name or a function of a sample; None if a program failed."""
        function = figure if callable(figure) else lambda sample: sample[figure]
        try:
            return statistics.median(function(sample) for sample in self.samples)
        except KeyError:
            return None


def stages_of(output):
    """The seconds of carve's last line, by stage."""
    line = re.search(r"^seconds: (.*)$", output, re.MULTILINE)[1]
    return {name: float(seconds) for name, seconds in re.findall(r"([a-z ]+) ([\d.]+)(?:, |$)", line)}


def run_carve(programs, mesh, path, folder):
    levels, profile = os.path.join(folder, "levels.vtm"), os.path.join(folder, "profile.csv")
    whole = run([programs.carve, path, "--levels", "8", "-o", levels, "--profile", profile], PATIENCE)
    stream = re.search(r"^stream: (\d+) tetrahedra \((.*)\)$", whole.output, re.MULTILINE)
    mesh.tetrahedra, mesh.strategy = int(stream[1]), stream[2]
    budget = run([programs.carve, path, *BUDGET], PATIENCE)
    return {**stages_of(whole.output), "carve, budget": stages_of(budget.output)["carve"], "whole": whole.seconds,
            "processor": whole.processor_seconds, "host memory": whole.own_peak, "helper memory": whole.helper_peak}


def run_peers(programs, mesh, path, surface, folder):
    figures = peers.run_decimations(surface)
    tetgen = peers.run_tetgen(path, PATIENCE)
    if tetgen:
        result, mesh.tetgen_tetrahedra = tetgen
        figures.update({"TetGen": result.seconds, "TetGen processor": result.processor_seconds,
                        "TetGen memory": result.own_peak})
    for size in WRAPS:
        figures["wrap " + size] = peers.run_alpha_wrap(programs.alpha_wrap, path, size,
                                                       os.path.join(folder, "wrap.off"))
    return figures


def measure(programs, path, folder, repetitions):
    ply, off, surface = write_plain(path, folder)
    mesh = Mesh(os.path.basename(path).split(".")[0], surface.GetNumberOfPoints())
    for _ in range(repetitions):
        mesh.samples.append({**run_carve(programs, mesh, ply, folder), **run_peers(programs, mesh, off, surface, folder)})
    return mesh
