# SPDX-License-Identifier: BSD-3-Clause
"""The plot of seconds over vertices, if there are generated meshes."""
import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "growth"  # the same figures make the same file
from matplotlib import pyplot as plt  # noqa: E402, after the choice of the backend

import growth  # noqa: E402

LINES = {"whole": "whole run of carve", "TetGen": "TetGen alone", "resolve": "crossing check", "carve": "carving",
         "measure": "profile", "output": "levels and stream", "wrap d/100": "alpha wrap at d/100",
         "vtkQuadricDecimation": "vtkQuadricDecimation"}


def draw(meshes, path):
    families = growth.families(meshes)
    if not families:
        return
    figure, plots = plt.subplots(1, len(families), figsize=(6.0 * len(families), 5.0), sharey=True, squeeze=False)
    for plot, (kind, members) in zip(plots[0], families.items()):
        for name, label in LINES.items():
            points = [(mesh.vertices, mesh.median(name)) for mesh in members]
            exponent = growth.exponent(members, name)
            plot.plot(*zip(*((x, y) for x, y in points if y)), marker="o", markersize=3,
                      label=label + ("" if exponent is None else f" ({exponent:.2f})"))
        plot.set(title=kind, xlabel="vertices", xscale="log", yscale="log")
        plot.grid(True, which="major", alpha=0.3)
        plot.legend(fontsize=8, title="growth exponents in brackets", title_fontsize=8)
    plots[0][0].set_ylabel("seconds")
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)
