# SPDX-License-Identifier: BSD-3-Clause
"""Functions shared by the scripts for pvbatch.

The environment variable MODELS names the folder of the models, TOPOLOGYCARVING_PLUGIN the plugin.
"""
import os
import sys

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

MODELS = os.environ["MODELS"]
simple._DisableFirstRenderCameraReset()
simple.LoadPlugin(os.environ["TOPOLOGYCARVING_PLUGIN"], remote=False, ns=simple.__dict__)

LEVEL, ALL_LEVELS, STREAM, PROFILE = range(4)


def open_model(name):
    return simple.OpenDataFile(os.path.join(MODELS, name))


def counts(proxy, port=0, time=0.0):
    """Updates an output and returns the numbers of its points and cells."""
    proxy.UpdatePipeline(time)
    information = simple.OutputPort(proxy, port).GetDataInformation()
    return information.GetNumberOfPoints(), information.GetNumberOfCells()


def fetch(proxy, port=LEVEL):
    """An output as a VTK data object."""
    return simple.servermanager.Fetch(proxy, idx=port)


def arrays(data):
    """All points, cells and arrays of a data set as bytes or lists of strings, by kind and name."""
    cells = data.GetPolys() if data.IsA("vtkPolyData") else data.GetCells()
    found = {
        "points": vtk_to_numpy(data.GetPoints().GetData()).tobytes(),
        "corners": vtk_to_numpy(cells.GetConnectivityArray()).tobytes(),
        "offsets": vtk_to_numpy(cells.GetOffsetsArray()).tobytes(),
    }
    for kind in ("PointData", "CellData", "FieldData"):
        attributes = getattr(data, "Get" + kind)()
        for i in range(attributes.GetNumberOfArrays()):
            array = attributes.GetAbstractArray(i)
            found[kind, array.GetName()] = (
                [array.GetValue(k) for k in range(array.GetNumberOfValues())] if array.IsA("vtkStringArray")
                else vtk_to_numpy(array).tobytes())
    return found


def blocks(tree):
    """The blocks of a multiblock by name."""
    return {tree.GetMetaData(i).Get(tree.NAME()): tree.GetBlock(i) for i in range(tree.GetNumberOfBlocks())}


def numbers(proxy, name):
    """The values of an information property."""
    proxy.UpdatePipelineInformation()
    found = proxy.SMProxy.GetProperty(name)
    return [found.GetElement(i) for i in range(found.GetNumberOfElements())]


def run_tests(unittest):
    """Runs all tests. unittest.main alone would interpret the arguments of pvbatch."""
    result = unittest.main(argv=["test"], exit=False, verbosity=2).result
    sys.stderr.flush()
    if not result.wasSuccessful():
        print("FAILED", flush=True)
        os._exit(1)
