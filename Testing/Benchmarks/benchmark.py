#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measure carve and other programs on meshes, and write RESULTS.md and growth.svg.

The name of a generated mesh is its kind and its size: KIND-VERTICES.ply.
"""
import argparse
import os
import subprocess
import sys
import tempfile

import growth_plot
import machine
import peers
import report
from measure import Programs, measure


def publish(given, meshes, loads):
    os.makedirs(given.output, exist_ok=True)
    growth_plot.draw(meshes, os.path.join(given.output, "growth.svg"))
    lines = [*machine.describe(given.root), f"load: {min(loads):.1f} to {max(loads):.1f}; the benchmark's own is 1 to 2"]
    page = report.page(meshes, command=given.command, machine="\n".join("- " + line for line in lines),
                       repetitions=given.repetitions, flags=peers.TETGEN_FLAGS)
    with open(os.path.join(given.output, "RESULTS.md"), "w", encoding="utf-8") as file:
        file.write(page)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", required=True, help="folder of carve and alpha-wrap")
    parser.add_argument("--root", required=True, help="folder of the sources")
    parser.add_argument("--output", required=True, help="folder for RESULTS.md and growth.svg")
    parser.add_argument("--command", required=True, help="the command that the page names")
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("meshes", nargs="+")
    given = parser.parse_args()
    programs = Programs(*(os.path.join(given.programs, name) for name in ("carve", "alpha-wrap")))
    loads, meshes = [machine.load()], []
    for path in given.meshes:
        with tempfile.TemporaryDirectory() as folder:
            try:
                meshes.append(measure(programs, path, folder, given.repetitions))
            except subprocess.SubprocessError as error:
                print(f"{path} is left out: {error}", file=sys.stderr)
                continue
        loads.append(machine.load())
        print(f"{meshes[-1].name}: {meshes[-1].median('whole'):.2f} s, load {loads[-1]:.1f}", file=sys.stderr)
        publish(given, meshes, loads)  # at once, so that nothing is lost if a later mesh takes too long


if __name__ == "__main__":
    main()
