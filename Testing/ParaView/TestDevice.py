# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The choice of a device in ParaView's window.

The tests read states that the window saves. Needs a display and the environment of TestWindow.py.
"""

import os
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

import window
from window import PROPERTIES, WindowTest

ROOM = Path(os.environ["LMS3D_DATA_DIR"]) / "room.wrl"
CHOICE = f"{PROPERTIES}/LMS3DDevice/device"
MAXIMUM_RANGE = f"{PROPERTIES}/MaximumRange/1pqDoubleLineEdit0"
RESET = [("propertiesDock/propertiesPanel/Reset", "activate", "")]
UNDO = window.choose("menu_Edit", "actionEditUndo")
ADVANCED = "propertiesDock/propertiesPanel/SearchBox/AdvancedButton"

IDEAL = {"MaximumRange": 80, "BeamDiameter": 0, "BeamDivergence": 0, "BeamSamples": 1,
         "PulseLength": 1, "RangeAtTenPercent": 0}
LMS200 = {"MaximumRange": 8, "BeamDiameter": 0.012, "BeamDivergence": 0.0044, "BeamSamples": 7,
          "PulseLength": 1, "RangeAtTenPercent": 10}


def choose(device):
    """Takes a device of the list."""
    return [(CHOICE, "set_string", device)]


def expect_device(device):
    """The device that the panel shows."""
    return window.expect(CHOICE, "currentText", device)


def open_room():
    """The room, and a scan whose properties are shown."""
    return [*window.open_file(ROOM), *window.add_filter("LMS3DScan")]


class TestDevice(WindowTest):
    """A device sets its properties, as if the user had typed them."""

    def save(self, name):
        """The step that saves a state."""
        return window.save_state(self.home / f"{name}.pvsm")

    def read(self, name, kind="LMS3DScan", names=tuple(IDEAL)):
        """The properties of the one proxy of a type in a state."""
        root = ET.parse(self.home / f"{name}.pvsm").getroot()
        (proxy,) = (proxy for proxy in root.iter("Proxy") if proxy.get("type") == kind)
        return {name: float(proxy.find(f"Property[@name='{name}']/Element").get("value"))
                for name in names}

    def test_a_state_has_the_values(self):
        self.play(open_room(), expect_device("Ideal"), choose("LMS200-mm"),
                  expect_device("LMS200-mm"), window.APPLY, expect_device("LMS200-mm"),
                  self.save("lms200"), choose("Ideal"), window.APPLY, self.save("ideal"))
        self.assertEqual(self.read("lms200"), LMS200)
        self.assertEqual(self.read("ideal"), IDEAL)

    def test_other_fields_of_the_panel_follow_and_the_choice_follows_them(self):
        self.play(open_room(), choose("LMS200-mm"), window.expect(MAXIMUM_RANGE, "text", "8"),
                  [(MAXIMUM_RANGE, "set_string", "5")], expect_device("Custom"), window.APPLY,
                  self.save("custom"), [(MAXIMUM_RANGE, "set_string", "80")],
                  expect_device("LMS200-cm"))
        self.assertEqual(self.read("custom"), {**LMS200, "MaximumRange": 5})

    def test_advanced_fields_show_the_values(self):
        field = f"{PROPERTIES}/LMS3DDevice/BeamSamples"
        self.play(open_room(), window.expect(field, "visible", "false"),
                  [(ADVANCED, "set_boolean", "true")],
                  window.expect(field, "visible", "true"), choose("LMS291"),
                  window.expect(f"{PROPERTIES}/LMS3DDevice/BeamDiameter/1pqDoubleLineEdit0", "text",
                                "0.016"), [(ADVANCED, "set_boolean", "false")])

    def test_reset_and_undo_take_it_back(self):
        self.play(open_room(), window.APPLY, choose("LMS291"), RESET, expect_device("Ideal"),
                  window.expect(MAXIMUM_RANGE, "text", "80"), choose("LMS200-mm"), window.APPLY,
                  UNDO, expect_device("Ideal"), self.save("undone"))
        self.assertEqual(self.read("undone"), IDEAL)

    def test_errors_of_ranges(self):
        self.play(open_room(), window.APPLY, window.add_filter("LMS3DRangeError"),
                  expect_device("Ideal"), choose("LMS200-cm"), window.APPLY, self.save("errors"))
        self.assertEqual(
            self.read("errors", "LMS3DRangeError", ("RangeBias", "RangeNoise", "RangeResolution")),
            {"RangeBias": 0, "RangeNoise": 0.005, "RangeResolution": 0.01})


if __name__ == "__main__":
    unittest.main()
