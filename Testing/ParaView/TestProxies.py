# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the plugin adds to ParaView, in pvpython.

Run by pvpython, which finds the package lms3d. LMS3D_PLUGIN is the plugin's file.
"""

import os
import re
import sys
import unittest

import lms3d
import numpy as np
from paraview import simple
from proxies import algorithm

simple.LoadPlugin(os.environ["LMS3D_PLUGIN"], remote=False, ns=globals())

# Properties that connect proxies.
INPUTS = {"Input", "Trajectory", "Map", "Scene", "Scan"}

# Properties without a default.
NEEDED = INPUTS | {"FileName", "TimestepValues"}

# What tells the unit of a property, by its kind; other kinds have none.
UNITS = {
    "vtkSMDoubleVectorProperty": r"\b(metres|degrees)\b",
    "vtkSMIntVectorProperty": r"\b([Nn]umber of|How many)\b",
    "vtkSMIdTypeVectorProperty": r"\b([Nn]umber of|How many)\b",
}


def explanation(shown):
    """What the window tells of a property, in one line."""
    return " ".join(shown.GetDocumentation().GetDescription().split())


def values_of(shown):
    """All elements of a property."""
    return [shown.GetElement(i) for i in range(shown.GetNumberOfElements())]


def entry_of(shown):
    """The text for the value of an enumeration or a switch, None for another property."""
    if shown.FindDomain("vtkSMBooleanDomain"):
        return ("off", "on")[shown.GetElement(0)]
    listed = shown.FindDomain("vtkSMEnumerationDomain")
    texts = {listed.GetEntryValue(i): listed.GetEntryText(i)
             for i in range(listed.GetNumberOfEntries())} if listed else {}
    return texts.get(shown.GetElement(0))


def in_words(value):
    """A value as an explanation has it."""
    if isinstance(value, str):
        return value or "none"
    return f"{value:,}" if isinstance(value, int) else f"{value:g}"


def compare():
    """A comparison with inputs, which ParaView asks for as soon as there is one."""
    return LMS3DMapComparison(Map=simple.Sphere(), Scene=simple.Sphere())


def fuse():
    """A fusion with inputs, which ParaView asks for as soon as there is one."""
    scan = LMS3DScan(Input=simple.Sphere())
    return LMS3DMapFusion(Map=LMS3DSurfaceReconstruction(Input=scan), Scan=scan)


def constructors():
    """What makes the proxies whose properties the tests check."""
    return VRMLReader, LMS3DScan, LMS3DRangeError, LMS3DSurfaceReconstruction, compare, fuse


class TestProxies(unittest.TestCase):
    """What the plugin adds, as the properties panel shows it."""

    def test_the_reader_says_what_it_replaces_and_hides_what_crashes(self):
        reader = VRMLReader(registrationName="shown").SMProxy
        self.assertIn("replaces ParaView's own VRML reader",
                      reader.GetDocumentation().GetLongHelp())
        self.assertIsNotNone(reader.GetHints().FindNestedElementByName(
            "ShowProxyDocumentationInPanel"))
        self.assertEqual(reader.GetProperty("Engine").GetPanelVisibility(), "never")

    def test_python_names_give_our_classes(self):
        classes = {
            VRMLReader: "vtkVRMLImporterSource",
            LMS3DScan: "vtkLMS3DScanFilter",
            LMS3DRangeError: "vtkLMS3DRangeErrorFilter",
            LMS3DSurfaceReconstruction: "vtkLMS3DSurfaceReconstructionFilter",
            compare: "vtkLMS3DMapComparison",
            fuse: "vtkLMS3DMapFusion",
        }
        for make, name in classes.items():
            with self.subTest(name):
                self.assertEqual(algorithm(make()).GetClassName(), name)

    def test_filters_are_in_the_menu_lms3d(self):
        for make in constructors()[1:]:
            with self.subTest(make.__name__):
                menu = make().SMProxy.GetHints().FindNestedElementByName("ShowInMenu")
                self.assertEqual(menu.GetAttribute("category"), "LMS3D")

    def test_the_short_help_has_the_words_of_the_field(self):
        """ParaView's quick search finds them from version 5.13 on."""
        for make in constructors()[1:]:
            for word in ("lidar", "laser", "range"):
                with self.subTest(make.__name__, word=word):
                    self.assertIn(word, make().SMProxy.GetDocumentation().GetShortHelp())

    def test_labels(self):
        self.assertEqual(VRMLReader().GetXMLLabel(), "VRML Reader")
        self.assertEqual(LMS3DScan().GetXMLLabel(), "LMS3D Scan")
        self.assertEqual(LMS3DRangeError().GetXMLLabel(), "LMS3D Range Error")
        self.assertEqual(
            LMS3DSurfaceReconstruction().GetXMLLabel(), "LMS3D Surface Reconstruction")
        self.assertEqual(compare().GetXMLLabel(), "LMS3D Map Comparison")
        self.assertEqual(fuse().GetXMLLabel(), "LMS3D Map Fusion")

    def test_properties_of_the_scan_are_grouped(self):
        proxy = LMS3DScan().SMProxy
        groups = [proxy.GetPropertyGroup(i) for i in range(proxy.GetNumberOfPropertyGroups())]
        grouped = {
            group.GetXMLLabel(): [
                group.GetProperty(i).GetXMLName() for i in range(group.GetNumberOfProperties())
            ]
            for group in groups
        }
        self.assertEqual(grouped, {
            "Device": ["BeamDiameter", "BeamDivergence", "BeamSamples", "PulseLength",
                       "RangeAtTenPercent", "ReflectanceArray"],
            "Pose": ["Position", "Orientation"],
            "Angles (degrees)": ["AlphaRange", "AlphaResolution", "BetaRange", "BetaResolution"],
            "Range (metres)": ["MinimumRange", "MaximumRange"],
            "Platform": ["Mounting", "AxisOffset", "TurnRate", "MotionDuringScan"],
            "Additional arrays": ["ComputeIncidence", "ComputeIntensity", "ComputeTime",
                                  "ComputeStatus", "ComputePoses", "SurfaceAttributes"],
            "Method": ["IntersectionMethod", "NumberOfThreads"],
        })

    def test_every_property_is_documented(self):
        for make in constructors():
            proxy = make()
            for name in proxy.ListProperties():
                with self.subTest(make.__name__, property=name):
                    self.assertTrue(explanation(proxy.SMProxy.GetProperty(name)))

    def explained(self):
        """The properties that have a default, each with its name and its documentation."""
        for make in constructors():
            proxy = make()
            for name in set(proxy.ListProperties()) - NEEDED:
                shown = proxy.SMProxy.GetProperty(name)
                yield f"{make.__name__}.{name}", shown, explanation(shown)

    def test_every_number_has_a_unit_or_is_a_count(self):
        for name, shown, words in self.explained():
            unit = UNITS.get(shown.GetClassName())
            if unit and entry_of(shown) is None:
                with self.subTest(name):
                    self.assertRegex(words, unit)

    def test_every_default_is_documented(self):
        for name, shown, words in self.explained():
            default = entry_of(shown) or " ".join(map(in_words, values_of(shown)))
            with self.subTest(name):
                self.assertRegex(words, rf"Default: {re.escape(default)}[.,]")

    def test_methods_match_the_filter(self):
        listed = LMS3DScan().SMProxy.GetProperty("IntersectionMethod").FindDomain(
            "vtkSMEnumerationDomain")
        shown = {listed.GetEntryValue(i): listed.GetEntryText(i).replace(" ", "")
                 for i in range(listed.GetNumberOfEntries())}
        filter_ = lms3d.vtkLMS3DScanFilter
        self.assertEqual(shown, {i: filter_.GetIntersectionMethodName(i)
                                 for i in range(filter_.GetNumberOfIntersectionMethods())})

    def test_mountings_match_the_filter(self):
        listed = LMS3DScan().SMProxy.GetProperty("Mounting").FindDomain("vtkSMEnumerationDomain")
        for i in range(listed.GetNumberOfEntries()):
            self.assertEqual(listed.GetEntryText(i).replace(" ", ""),
                             lms3d.vtkLMS3DScanFilter.GetMountingName(listed.GetEntryValue(i)))
        self.assertIsNone(
            lms3d.vtkLMS3DScanFilter.GetMountingName(listed.GetNumberOfEntries()))

    def test_every_device_reaches_the_filters(self):
        for make in (LMS3DScan, LMS3DRangeError):
            proxy = make()
            for name, number in reversed(lms3d.DEVICES.items()):
                with self.subTest(make.__name__, device=name):
                    lms3d.set_device(proxy, name)
                    proxy.SMProxy.UpdateVTKObjects()
                    self.assertEqual(algorithm(proxy).GetDevice(), number)

    def test_defaults_match_the_filters(self):
        for make in constructors():
            proxy = make()
            fresh = getattr(lms3d, algorithm(proxy).GetClassName())()
            for name in set(proxy.ListProperties()) - NEEDED:
                with self.subTest(make.__name__, property=name):
                    default = getattr(fresh, f"Get{name}")()
                    default = "" if default is None else default  # ParaView has no None
                    shown = proxy.SMProxy.GetProperty(name)
                    self.assertEqual(values_of(shown), list(np.atleast_1d(default)))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
