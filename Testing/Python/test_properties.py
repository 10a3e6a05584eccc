# SPDX-License-Identifier: BSD-3-Clause
"""Properties are printed, and documented in the README.

The environment variable ROOT names the folder of the sources.
"""
import os
import re
import unittest

from setters import setters
from topologycarving import vtkContourCarver, vtkExtractCarvedLOD, vtkTopologyCarver

CARVERS = (vtkTopologyCarver, vtkContourCarver)
# Setters without influence on the result.
NO_PROPERTIES = {"SetController"}


def names(filter_class):
    """The properties that have one value."""
    return {name[3:] for name in setters(filter_class) - NO_PROPERTIES if name.startswith("Set")}


def printed(instance):
    """The names and values that PrintSelf writes."""
    return dict(re.findall(r"^ *(\w+): ?(.*)$", str(instance), re.M))


def value_of(instance, text):
    """The value of a printed or documented text."""
    if text.lower() in ("on", "off"):
        return text.lower() == "on"
    return getattr(instance, text) if text.isupper() else float(text.replace("−", "-"))


def change(instance, name):
    """Gives a property another value, whatever its type and range."""
    before = getattr(instance, "Get" + name)()
    for after in (not before,) if isinstance(before, bool) else (before + 1, before - 1):
        getattr(instance, "Set" + name)(after)
        if getattr(instance, "Get" + name)() != before:
            return
    raise AssertionError(name + " cannot be changed")


def documented():
    """The names and defaults in the README's table of properties, and the table."""
    with open(os.path.join(os.environ["ROOT"], "README.md"), encoding="utf-8") as file:
        table = file.read().split("## Properties")[1].split("\n##")[0]
    defaults = {}
    for line in re.findall(r"^\| `.*$", table, re.M):
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)]
        for name in re.findall(r"`(\w+)(?:\(\w*\))?`", cells[1]):
            defaults[name] = cells[3].strip("`")
    return defaults, table


class TestProperties(unittest.TestCase):
    def test_are_printed(self):
        """PrintSelf writes the name and current value of every property."""
        for filter_class in (*CARVERS, vtkExtractCarvedLOD):
            instance = filter_class()
            for name in names(filter_class):
                with self.subTest(filter=filter_class.__name__, property=name):
                    for _ in range(2):
                        text = printed(instance)[name]
                        self.assertEqual(value_of(instance, text), getattr(instance, "Get" + name)())
                        change(instance, name)

    def test_have_the_documented_defaults(self):
        """The README lists exactly the properties of the carvers, with their defaults."""
        for filter_class in CARVERS:
            instance = filter_class()
            defaults = documented()[0]
            self.assertEqual(defaults.pop("AddLevelTarget"), "none")
            self.assertEqual(defaults.pop("ClearLevelTargets"), "none")
            self.assertEqual(instance.GetNumberOfLevelTargets(), 0)
            self.assertEqual(set(defaults), names(filter_class))
            for name, default in defaults.items():
                self.assertEqual(getattr(instance, "Get" + name)(), value_of(instance, default), name)

    def test_have_the_documented_values(self):
        """The README gives the numbers of enumeration values as in the filter."""
        values = re.findall(r"`([A-Z_]+)`(?: \(|, )(\d)\)", documented()[1])
        self.assertGreater(len(values), 15)
        for name, value in values:
            self.assertEqual(getattr(vtkTopologyCarver, name), int(value), name)


if __name__ == "__main__":
    unittest.main()
