# SPDX-License-Identifier: BSD-3-Clause
"""The memory that carving takes is that of the estimate by which meshes are refused.

The environment variable MODEL names the program that makes models.
"""
import os
import re
import resource
import subprocess
import sys
import tempfile
import unittest

from topologycarving import vtkTopologyCarver
from vtkmodules.vtkIOPLY import vtkPLYReader


def read(name):
    reader = vtkPLYReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def measure(name):
    """Prints the number of levels, and the bytes that this process and its helper program take for a mesh."""
    mesh = read(name)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    carver = vtkTopologyCarver()
    carver.SetInputData(mesh)
    carver.Update()
    host = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    helper = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    print(carver.GetOutput().GetNumberOfBlocks(), 1024 * host, 1024 * helper)


def measured(name, **environment):
    """What a process of its own prints, errors included."""
    return subprocess.run([sys.executable, __file__, name], check=True, text=True, env={**os.environ, **environment},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout


class TestMemory(unittest.TestCase):
    def test_is_as_estimated(self):
        """For closed surfaces and for foliage, host and helper program take what the error says, within a tenth."""
        for model in ("bumpy-torus:50000", "tree:50000"):
            with self.subTest(model), tempfile.TemporaryDirectory() as folder:
                name = os.path.join(folder, "model.ply")
                subprocess.run([os.environ["MODEL"], model, name], check=True)
                error = measured(name, PV_HOST_MEMORY_LIMIT="1000")
                estimates = [float(number) * 2 ** 20 for number in re.findall(r"(\d+) MiB", error)]
                levels, host, helper = measured(name).split()
                self.assertEqual(levels, "8")
                self.assertAlmostEqual(float(helper), estimates[0], delta=0.1 * estimates[0])
                self.assertAlmostEqual(float(host), estimates[1], delta=0.1 * estimates[1])


if __name__ == "__main__":
    if sys.argv[1:] and os.path.isfile(sys.argv[1]):
        measure(sys.argv[1])
    else:
        unittest.main()
