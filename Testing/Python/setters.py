# SPDX-License-Identifier: BSD-3-Clause
"""The properties of the filters, by their setters."""
import re


def setters(filter_class):
    """The setters that a class and its bases add to those of VTK, without the On and Off methods."""
    vtk = next(base for base in filter_class.__mro__ if base.__module__.startswith("vtkmodules."))
    return {name for name in set(dir(filter_class)) - set(dir(vtk)) if re.match(r"(Set|Add|Clear)[A-Z]", name)}
