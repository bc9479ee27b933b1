#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The first look of outputs in ParaView's window: colours, legends, and the camera of a range image.

The tests read states that the window saves. Needs a display and the environment of TestWindow.py.
"""

import os
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

import window
from window import PIPELINE, WindowTest

ROOM = Path(os.environ["LMS3D_DATA_DIR"]) / "room.wrl"
GREEN, ORANGE = [0.2, 0.7, 0.3], [0.9, 0.55, 0.15]
EYE = 8  # pixels from the left of an entry of the pipeline
SCAN, RANGE_IMAGE = "/0:0/0:0/0:0/0:1", "/0:0/0:0/0:0/1:1"
CAMERA = ("CameraPosition", "CameraFocalPoint", "CameraViewUp", "CameraParallelScale",
          "CenterOfRotation", "InteractionMode")
SCROLL_BAR = "propertiesDock/propertiesPanel/scrollArea/qt_scrollarea_hcontainer/1QScrollBar0"
PIPELINE_SCRIPT = f"""
from paraview.simple import *
room = VRMLReader(FileName={str(ROOM)!r})
scan = LMS3DScan(Input=room, Position=[0.3, -0.2, 1], AlphaResolution=61, BetaResolution=90)
view = GetActiveViewOrCreate("RenderView")
"""


class State:
    """A state that the window has saved."""

    def __init__(self, path):
        self.proxies = [proxy for proxy in ET.parse(path).getroot().iter("Proxy") if proxy.get("type")]

    def find(self, kind):
        """All proxies of a type, in the order of their creation."""
        found = [proxy for proxy in self.proxies if proxy.get("type") == kind]
        return sorted(found, key=lambda proxy: int(proxy.get("id")))

    def find_displays(self, kind):
        """The displays of the sources of a type, in the order of their creation."""
        sources = {proxy.get("id") for proxy in self.find(kind)}
        return [display for display in self.find("GeometryRepresentation")
                if display.find("Property[@name='Input']/Proxy").get("value") in sources]

    def colors(self):
        """The colours of the maps, in the order in which they were shown."""
        return [numbers(display, "DiffuseColor")
                for display in self.find_displays("LMS3DSurfaceReconstruction")]

    def titles(self):
        """The titles of the legends."""
        return {texts(legend, "Title")[0] for legend in self.find("ScalarBarWidgetRepresentation")}

    def camera(self):
        """The camera of the one view."""
        (view,) = self.find("RenderView")
        return {name: numbers(view, name) for name in CAMERA}


def texts(proxy, name):
    """A property of a proxy."""
    return [element.get("value") for element in proxy.findall(f"Property[@name='{name}']/Element")]


def numbers(proxy, name):
    """A property of a proxy as numbers."""
    return [float(value) for value in texts(proxy, name)]


class LookTest(WindowTest):
    """Tests that look at saved states."""

    def state_file(self, name="state"):
        """The path of a state."""
        return self.home / f"{name}.pvsm"

    def read_state(self, name="state"):
        """A state that a step has saved."""
        return State(self.state_file(name))

    def save(self, name="state"):
        """The step that saves a state."""
        return window.save_state(self.state_file(name))

    def run_script(self, script):
        """The state of a window that has run a Python script."""
        file = self.home / "script.py"
        file.write_text(PIPELINE_SCRIPT + script)
        command = [*window.start_with_plugins(), f"--script={file}"]
        code, messages = window.play(self.home, self.save(), command)
        self.assertEqual(code, 0, messages)
        return self.read_state()


def open_scan():
    """The room and its scan."""
    return window.open_file(ROOM) + window.add_filter("LMS3DScan") + window.APPLY


def click_eye(place):
    """Shows or hides an output."""
    return window.select(PIPELINE, place, EYE)


class TestMaps(LookTest):
    """Colours of local maps."""

    def test_second_map_is_orange(self):
        add_map = [*window.add_filter("LMS3DSurfaceReconstruction"), *window.APPLY]
        self.play(open_scan(), add_map, window.select(PIPELINE, "/0:0/0:0/0:0"), add_map, self.save())
        self.assertEqual(self.read_state().colors(), [GREEN, ORANGE])

    def test_a_map_has_one_colour_in_all_views(self):
        state = self.run_script("""
one, other = (LMS3DSurfaceReconstruction(Input=scan) for _ in range(2))
Show(one, view)
Show(other, view)
second = CreateView("RenderView")
Show(other, second)
Show(one, second)
""")
        self.assertEqual(state.colors(), [GREEN, ORANGE, ORANGE, GREEN])


class TestFusedMap(LookTest):
    """The map of a journey."""

    def test_it_grows_in_the_window_and_looks_like_a_map(self):
        count = self.home / "scans.txt"
        state = self.run_script(f"""
scan.Trajectory = OpenDataFile({str(ROOM.with_name("journey.vtp"))!r})
fusion = LMS3DMapFusion(Map=LMS3DSurfaceReconstruction(Input=scan), Scan=scan)
Show(fusion, view)
scan.UpdatePipelineInformation()
animation = GetAnimationScene()
animation.UpdateAnimationUsingDataTimeSteps()
animation.Play()
fused = fusion.SMProxy.GetClientSideObject().GetOutputDataObject(0)
with open({str(count)!r}, "w") as file:
    file.write(str(fused.GetFieldData().GetArray("NumberOfScans").GetValue(0)))
""")
        self.assertEqual(count.read_text(), "17")
        (display,) = state.find_displays("LMS3DMapFusion")
        self.assertEqual(numbers(display, "DiffuseColor"), GREEN)
        self.assertEqual(numbers(display, "Ambient"), [0.3])


class TestLegends(LookTest):
    """Units in legends."""

    def test_range_has_a_unit(self):
        self.play(open_scan(), self.save())
        self.assertEqual(self.read_state().titles(), {"Range (m)"})

    def test_errors_have_a_unit(self):
        state = self.run_script("""
comparison = LMS3DMapComparison(Map=LMS3DSurfaceReconstruction(Input=scan), Scene=room)
Show(comparison, view).SetScalarBarVisibility(view, True)
""")
        self.assertEqual(state.titles(), {"Largest Error (m)"})

    def test_other_sources_have_none(self):
        state = self.run_script("""
points = Calculator(Input=Sphere(), ResultArrayName="Range", Function="coordsX")
shown = Show(points, view)
ColorBy(shown, ("POINTS", "Range"))
shown.SetScalarBarVisibility(view, True)
""")
        self.assertEqual(state.titles(), {"Range"})


class TestRangeImage(LookTest):
    """The camera of a view that shows a range image."""

    def test_camera_comes_back(self):
        self.play(
            open_scan(), self.save("scan"), click_eye(SCAN), click_eye(RANGE_IMAGE),
            self.save("image"), click_eye(RANGE_IMAGE), self.save("hidden"),
            click_eye(RANGE_IMAGE), self.save("again"), click_eye(SCAN), click_eye(RANGE_IMAGE),
            self.save("both"))
        before, image = (self.read_state(name).camera() for name in ("scan", "image"))
        self.assertEqual(image["InteractionMode"], [1])
        self.assertEqual(image["CameraViewUp"], [1, 0, 0])
        self.assertEqual(before["InteractionMode"], [0])
        self.assertEqual(self.read_state("hidden").camera(), before)
        self.assertEqual(self.read_state("again").camera(), image)
        self.assertEqual(self.read_state("both").camera(), before)

    def test_deleted_image_gives_the_camera_back(self):
        self.play(
            open_scan(), self.save("scan"), click_eye(SCAN), click_eye(RANGE_IMAGE),
            window.DELETE, self.save("deleted"))
        before, after = (self.read_state(name).camera() for name in ("scan", "deleted"))
        self.assertEqual(after, before)

    def test_camera_that_the_user_turned_stays(self):
        self.play(
            open_scan(), click_eye(SCAN), click_eye(RANGE_IMAGE),
            [("cameraToolbar/actionNegativeZ", "activate", "")], self.save("turned"),
            click_eye(RANGE_IMAGE), self.save("hidden"))
        turned, after = (self.read_state(name).camera() for name in ("turned", "hidden"))
        self.assertEqual(after, turned)

    def test_camera_of_a_script_holds(self):
        camera = {"CameraPosition": [3, 2, 1], "CameraFocalPoint": [0, 1, 2], "CameraViewUp": [0, 0, 1]}
        state = self.run_script("Show(OutputPort(scan, 1), view)\n" + "".join(
            f"view.{name} = {value}\n" for name, value in camera.items()))
        seen = state.camera()
        self.assertEqual({name: seen[name] for name in camera}, camera)

    def test_script_without_a_camera(self):
        seen = self.run_script("Show(OutputPort(scan, 1), view)\nRender()\n").camera()
        self.assertEqual((seen["CameraViewUp"], seen["InteractionMode"]), ([1, 0, 0], [1]))


class TestPanel(LookTest):
    """The properties of LMS3D Scan."""

    def test_they_fit_into_the_panel(self):
        self.play(window.open_file(ROOM), window.add_filter("LMS3DScan"),
                  window.expect(SCROLL_BAR, "maximum", "0"))


if __name__ == "__main__":
    unittest.main()
