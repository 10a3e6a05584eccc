# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's panels agree with the filters.

The environment variable PLUGIN names the folder of the plugin's sources.
"""
import os
import re
import unittest
import xml.etree.ElementTree as ElementTree

from setters import setters
from topologycarving import vtkContourCarver, vtkEnclosingDecimation, vtkExtractCarvedLOD, vtkTopologyCarver

PLUGIN = os.environ["PLUGIN"]

# Setters without a property on a panel, and the reason.
LEFT_OUT = {
    "SetLevelTarget": "the panel has one target per type",
    "SetController": "ParaView uses the global controller",
    "SetTarget": "the panel has a list of targets",
    "SetOutputType": "ParaView has a filter that converts multiblocks",
}


def parse(name):
    return ElementTree.parse(os.path.join(PLUGIN, name)).getroot()


def find_proxy(root, name):
    return next(proxy for proxy in root.iter() if proxy.tag.endswith("Proxy") and proxy.get("name") == name)


def properties(proxy):
    """The properties that a command sets."""
    return [p for p in proxy if p.tag.endswith("VectorProperty") and p.get("information_only") != "1"]


def commands(proxy):
    found = {p.get("command") for p in proxy if p.tag.endswith("Property")}
    for p in properties(proxy):
        found.add(p.get("clean_command"))
    return found


def header_defaults(name):
    """Members and defaults of a class of the plugin, read from its header: the class is not wrapped in Python."""
    with open(os.path.join(PLUGIN, "Classes", name + ".h"), encoding="utf-8") as file:
        return dict(re.findall(r"^  (?:int|double|bool) (\w+) = ([^;{]+);", file.read(), re.M))


class TestPanels(unittest.TestCase):
    def setUp(self):
        self.carver = find_proxy(parse("Carvers.xml"), "Carver")
        extract = parse("ExtractCarvedLOD.xml")
        self.picker = find_proxy(extract, "LevelPicker")
        self.extract = find_proxy(extract, "ExtractCarvedLOD")
        self.decimation = find_proxy(parse("EnclosingDecimation.xml"), "EnclosingDecimation")

    def expect_defaults(self, proxy, instance, others):
        for p in properties(proxy):
            name = p.get("command")[3:]
            if p.get("command").startswith("Add"):
                self.assertEqual(instance.GetNumberOfLevelTargets(), 0)
                continue
            default = others[name] if name in others else getattr(instance, "Get" + name)()
            self.assertEqual(float(p.get("default_values")), float(default), p.get("name"))

    def test_defaults_are_the_filters(self):
        """Every property has the default of the filter."""
        others = header_defaults("vtkPVExtractCarvedLOD")
        others["FollowTime"] = 0  # the window shows a level in the middle first
        for instance in (vtkTopologyCarver(), vtkContourCarver()):
            self.expect_defaults(self.carver, instance, {})
        for proxy in (self.picker, self.extract):
            self.expect_defaults(proxy, vtkExtractCarvedLOD(), others)
        decimation = vtkEnclosingDecimation()
        for p in properties(self.decimation):
            name = p.get("command")[3:]
            default = decimation.GetTarget(0) if name == "Target" else getattr(decimation, "Get" + name)()
            self.assertEqual(float(p.get("default_values")), float(default), p.get("name"))

    def test_every_setter_is_on_a_panel(self):
        """Every setter of the filters is on a panel or is left out on purpose."""
        shown = commands(self.carver)
        for name in setters(vtkTopologyCarver) | setters(vtkContourCarver):
            self.assertTrue(name in shown or name in LEFT_OUT, name)
        shown = commands(self.picker) | commands(self.extract)
        for name in setters(vtkExtractCarvedLOD):
            self.assertTrue(name in shown or name in LEFT_OUT, name)
        shown = commands(self.decimation)
        for name in setters(vtkEnclosingDecimation):
            self.assertTrue(name in shown or name in LEFT_OUT, name)

    def test_enumerations_are_the_filters(self):
        """Every enumeration offers all values of the filter, under their names."""
        known = {
            "SetInitialApproximation": "CONVEX_HULL BOUNDING_BOX CUSTOM",
            "SetPriorityMeasure": "LONGEST_EDGE VOLUME CIRCUMRADIUS EDGE_VOLUME EDGE_DISTANCE AUTO_MEASURE",
            "SetDepthMeasure": "HIERARCHY DISTANCE",
            "SetSolidRule": "NONZERO_WINDING EVEN_ODD SURFACE_ONLY",
            "SetConformity": "EXACT ENCLOSING AUTO",
            "SetStrategy": "TETGEN RECOVER AUTO",
            "SetLevelSimplification": "SUBSET ENCLOSING_COLLAPSE",
            "SetKeepBothFoldSides": "ONE_SIDE BOTH_SIDES AUTO",
            "SetTargetType": "VERTICES TRIANGLES ERROR_BOUND",
            "SetLevelTargetType": "VERTICES TRIANGLES FEATURE_SIZE TUNNELS COMPONENTS ERROR_BOUND STEP",
        }
        seen = set()
        for proxy, owner in ((self.carver, vtkTopologyCarver), (self.picker, vtkTopologyCarver),
                             (self.extract, vtkExtractCarvedLOD), (self.decimation, vtkEnclosingDecimation)):
            for p in properties(proxy):
                entries = p.findall("EnumerationDomain/Entry")
                if not entries:
                    continue
                seen.add(p.get("command"))
                names = known[p.get("command")].split()
                self.assertEqual([int(e.get("value")) for e in entries],
                                 [getattr(owner, name) for name in names])
                for entry, name in zip(entries, names):
                    words = set(re.findall(r"[a-z]+", name.lower()))
                    self.assertTrue(words <= set(re.findall(r"[a-z]+", entry.get("text").lower())), name)
        self.assertEqual(seen, set(known))

    def test_every_property_is_explained(self):
        """Every property has a tooltip."""
        for proxy in (self.carver, self.picker, self.extract, self.decimation):
            for p in properties(proxy):
                text = p.findtext("Documentation") or ""
                self.assertGreater(len(text.strip()), 20, p.get("name"))

    def test_shared_properties_are_exposed(self):
        """The properties that pick a level are on all panels, in the same group."""
        exposed = {p.get("name") for p in self.carver.findall("SubProxy/ExposedProperties/Property")}
        self.assertEqual(exposed, {p.get("name") for p in self.picker if p.tag.endswith("Property")})
        for proxy in (self.carver, self.extract):
            group = next(g for g in proxy.findall("PropertyGroup") if g.get("label") == "Level")
            self.assertEqual([p.get("name") for p in group], [p.get("name") for p in properties(self.picker)])


if __name__ == "__main__":
    unittest.main()
