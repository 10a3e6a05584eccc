# SPDX-License-Identifier: BSD-3-Clause
"""The other programs and filters that measurements stand beside."""
import re
import subprocess
import time

from processes import run
from vtkmodules.vtkFiltersCore import vtkDecimatePro, vtkQuadricClustering, vtkQuadricDecimation

# Those of the first attempt of carving-helper, without neighbors (n), which the program would write to a file; and no
# output (N, E, F).
TETGEN_FLAGS = "-pcYO0/0T1e-14JNEF"
REDUCTION = 0.9  # the share of triangles that decimation removes


def run_tetgen(path, patience):
    """The Run of the bare program and its number of tetrahedra, or None where TetGen fails."""
    try:
        result = run(["tetgen", TETGEN_FLAGS, path], patience)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
        return None
    found = re.search(r"Mesh tetrahedra: (\d+)", result.output)
    return (result, int(found[1])) if found else None


def run_alpha_wrap(program, path, size, output):
    """The seconds of a wrap. `size` is a number of vertices or, as d/N, alpha as a part of the diagonal."""
    wrapped = subprocess.run([program, path, output, size], check=True, capture_output=True, text=True)
    return float(wrapped.stdout)


def run_filter(filter_, data):
    """The seconds of an update."""
    filter_.SetInputData(data)
    start = time.perf_counter()
    filter_.Update()
    return time.perf_counter() - start


def run_decimations(data):
    """The seconds of VTK's decimations, by name."""
    quadric, pro, clustering = vtkQuadricDecimation(), vtkDecimatePro(), vtkQuadricClustering()
    quadric.SetTargetReduction(REDUCTION)
    pro.SetTargetReduction(REDUCTION)
    return {filter_.GetClassName(): run_filter(filter_, data) for filter_ in (quadric, pro, clustering)}
