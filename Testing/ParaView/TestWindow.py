#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window with a home of its own: toolbars, settings, messages, quick search, Python states.

Needs a display. LMS3D_PARAVIEW and LMS3D_PVPYTHON are the programs, LMS3D_PARAVIEW_VERSION is ParaView's
version, LMS3D_PLUGINS are the plugins' files, LMS3D_DATA_DIR is the folder of room.wrl, LMS3D_RUN the
script "run".
"""

import os
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

import window
from window import PIPELINE, WindowTest

DATA = Path(os.environ["LMS3D_DATA_DIR"])
ROOM, JOURNEY = DATA / "room.wrl", DATA / "journey.vtp"
BEAMS = 361 * 360
HAS_REMOTE = "LMS3DRemote" in os.environ["LMS3D_PLUGINS"]

FILTERS = ["LMS3D Map Comparison", "LMS3D Map Fusion", "LMS3D Range Error", "LMS3D Scan",
           "LMS3D Surface Reconstruction"]


class TestToolbars(WindowTest):
    """The icons, with the settings of the starts before."""

    def test_every_start_shows_all_icons(self):
        icons = [window.expect_icon("filters", "LMS3D", i, text) for i, text in enumerate(FILTERS)]
        if HAS_REMOTE:
            icons.append(window.expect_icon("sources", "LMS3D Server", 0, "LMS3D Remote"))
        for start in range(3):
            with self.subTest(start):
                self.play(*icons)
        self.assertTrue(any(self.home.rglob("ParaView*.ini")), "the settings were not kept")


class TestRun(WindowTest):
    """./run paraview FILE, in a copy whose build is this one."""

    def setUp(self):
        super().setUp()
        self.root = self.home / "tree"
        (self.root / "build").mkdir(parents=True)
        shutil.copy(os.environ["LMS3D_RUN"], self.root / "run")
        plugin = Path(os.environ["LMS3D_PLUGINS"].split(os.pathsep)[0])
        libraries = next(folder for folder in plugin.parents if folder.name == "lib")
        (self.root / "build/lib").symlink_to(libraries)
        self.programs = self.root / "programs"
        self.programs.mkdir()
        self.stand_in("cmake", "exit 0")
        self.stand_in("dpkg-query", 'for last; do echo; echo "$last installed"; done')
        (self.programs / "paraview").symlink_to(os.environ["LMS3D_PARAVIEW"])

    def stand_in(self, name, script):
        """Put a program first in PATH."""
        program = self.programs / name
        program.write_text(f"#!/bin/sh\n{script}\n")
        program.chmod(0o755)

    def test_the_file_is_open_and_plain_paraview_unchanged(self):
        before = self.plain_settings()
        code, messages = window.play(
            self.home, [*window.APPLY, *window.expect_cells(804),
                        *window.expect_icon("filters", "LMS3D", 3, "LMS3D Scan")],
            [self.root / "run", "paraview", ROOM], LMS3D_PRESET="default",
            PATH=f"{self.programs}:{os.environ['PATH']}")
        self.assertEqual(code, 0, messages)
        self.assertTrue(any((self.home / ".config/LMS3D/ParaView").glob("ParaView*.ini")))
        self.assertEqual(self.plain_settings(), before)

    def plain_settings(self):
        """The files of plain ParaView's settings."""
        return {path.name: path.read_bytes() for path in (self.home / ".config/ParaView").iterdir()}


class TestMessages(WindowTest):
    """What a user reads in Output Messages."""

    def test_one_error_for_a_scene_without_polygons(self):
        messages = self.play(window.open_file(JOURNEY), window.add_filter("LMS3DScan"), window.APPLY)
        self.check_one_error(messages, "has no polygons")

    def test_one_error_for_a_comparison_without_a_scan(self):
        dialog = "SelectInputDialog"
        messages = self.play(
            window.open_file(ROOM), window.add_filter("LMS3DMapComparison"),
            [(f"{dialog}/buttonFrame/Scene", "set_boolean", "true")],
            window.select(f"{dialog}/pipelineView", "/0:0/0:0", 59),
            [(f"{dialog}/{window.OK_BUTTON}", "activate", "")], window.APPLY)
        self.check_one_error(messages, "SensorToWorld")

    def test_a_scan_without_returns(self):
        messages = self.play(
            window.open_file(ROOM), window.add_filter("LMS3DScan"),
            window.type_property("LMS3DPose/translateX", 1000), window.APPLY, window.expect_cells(0))
        self.assertEqual(messages.count("LMS3DScan1: no beam returned"), 1, messages)
        self.assertNotIn("ERR|", messages)

    @unittest.skipUnless(HAS_REMOTE, "a build without CORBA")
    def test_none_for_the_pose_of_a_server(self):
        """The widget of the pose also serves LMS3D Remote, which has no trajectory."""
        messages = self.play(
            window.choose("menuSources", "LMS3D Server", "LMS3DRemote"),
            window.type_property("LMS3DPose/translateX", 1),
            window.expect(f"{window.PROPERTIES}/LMS3DPose/show3DWidget", "enabled", "true"),
            window.DELETE)
        self.assertNotRegex(messages, "NULL|[Ff]ailed to locate|nullptr")
        self.assertNotIn("ERR|", messages)

    def test_a_text_that_is_no_vrml(self):
        text = self.home / "letter.wrl"
        text.write_text("Dear reader\n")
        self.check_one_error(self.play(window.open_file(text)), "not a VRML 2.0 (VRML97) file")


class TestStartPose(WindowTest):
    """Where the sensor of a new scan is."""

    def test_half_of_the_height_of_a_low_scene(self):
        low = self.home / "low.wrl"
        low.write_text(
            "#VRML V2.0 utf8\nTransform { translation 3 1 4 children Shape { geometry Box { size 2 4 1 } } }")
        pose = f"{window.PROPERTIES}/LMS3DPose"
        self.play(
            window.open_file(low), window.add_filter("LMS3DScan"),
            *[window.expect(f"{pose}/translate{axis}", "text", value)
              for axis, value in zip("XYZ", ("3", "1", "4"))])


class TestTrajectory(WindowTest):
    """The trajectory of a scan, chosen in the scan's panel."""

    def test_it_is_taken_and_taken_away(self):
        trajectory = f"{window.PROPERTIES}/Trajectory/1QComboBox0"
        box = f"{window.PROPERTIES}/LMS3DPose/show3DWidget"
        self.play(
            window.open_file(ROOM), window.open_file(JOURNEY), window.select(PIPELINE, "/0:0/0:0"),
            window.add_filter("LMS3DScan"), window.type_property("LMS3DPose/translateX", 1000),
            [(trajectory, "set_string", "journey.vtp")], window.APPLY,
            window.expect_cells(BEAMS), window.expect(box, "enabled", "false"),
            [(trajectory, "set_string", "(none)")], window.APPLY,
            window.expect_cells(0), window.expect(box, "enabled", "true"))


def list_inputs(proxy, name):
    """The numbers of the proxies that are an input of a proxy of a state."""
    return [found.get("value") for found in proxy.findall(f"Property[@name='{name}']/Proxy")]


def read_fusion(state):
    """The one fusion of a state, and all proxies by number."""
    proxies = {proxy.get("id"): proxy for proxy in ET.parse(state).getroot().iter("Proxy")
               if proxy.get("type")}
    (fusion,) = (proxy for proxy in proxies.values() if proxy.get("type") == "LMS3DMapFusion")
    return fusion, proxies


class TestFusion(WindowTest):
    """Filters > LMS3D > LMS3D Map Fusion of maps: the scans of the maps are chosen already."""

    def test_play_reaches_the_end(self):
        messages = self.play(
            window.open_file(ROOM), window.open_file(JOURNEY), window.select(PIPELINE, "/0:0/0:0"),
            window.add_filter("LMS3DScan"),
            [(f"{window.PROPERTIES}/Trajectory/1QComboBox0", "set_string", "journey.vtp")],
            window.APPLY, window.add_filter("LMS3DSurfaceReconstruction"), window.APPLY,
            window.add_filter("LMS3DMapFusion"),
            window.expect(f"{window.PROPERTIES}/Scan/1QComboBox0", "currentText", "LMS3DScan1:Scan"),
            window.APPLY, [("VCRToolbar/actionVCRPlay", "activate", "")],
            window.expect("currentTimeToolbar/AnimationTimeWidget/timeValueComboBox",
                          "currentText", "16"))
        self.assertNotIn("ERR|", messages)

    def test_two_sensors(self):
        state = self.home / "state.pvsm"
        add_map = [*window.add_filter("LMS3DScan"), *window.APPLY,
                   *window.add_filter("LMS3DSurfaceReconstruction"), *window.APPLY]
        first, second = (f"/0:0/0:0/{scan}:0/0:0/0:0" for scan in (0, 1))
        messages = self.play(
            window.open_file(ROOM), add_map, window.select(PIPELINE, "/0:0/0:0"), add_map,
            window.select(PIPELINE, first), window.select(PIPELINE, second, held=window.CONTROL),
            window.add_filter("LMS3DMapFusion"), window.APPLY, window.save_state(state))
        self.assertNotIn("ERR|", messages)
        fusion, proxies = read_fusion(state)
        scans = list_inputs(fusion, "Scan")
        self.assertEqual(len(set(scans)), 2)
        self.assertEqual(scans, [list_inputs(proxies[number], "Input")[0]
                                 for number in list_inputs(fusion, "Map")])

    def test_a_map_of_another_source(self):
        state = self.home / "state.pvsm"
        self.play(
            window.open_file(ROOM), window.add_filter("LMS3DMapFusion"), window.save_state(state))
        fusion, _ = read_fusion(state)
        self.assertEqual(len(list_inputs(fusion, "Map")), 1)
        self.assertEqual(list_inputs(fusion, "Scan"), [])


@unittest.skipIf(window.VERSION >= (5, 13), "another dialog, which searches the filters' short help")
class TestQuickSearch(WindowTest):
    """Ctrl+Space and words."""

    def test_words_of_the_field(self):
        found = {f"{word} {part}": text for word in ("lidar", "laser", "range")
                 for part, text in (("map", "LMS3D Map Comparison"), ("scan", "LMS3D Scan"))}
        self.play(
            window.open_file(ROOM), window.choose("menuFilters", "Search...\tCtrl+Space"),
            *[window.expect_found(words, text) for words, text in found.items()],
            window.press(window.SEARCH, window.ESCAPE),
            window.expect("menubar/menuFilters/LMS3D", "title", "LMS3D"))

    def test_the_reconstruction_of_a_scan(self):
        self.play(
            window.open_file(ROOM), window.add_filter("LMS3DScan"), window.APPLY,
            window.choose("menuFilters", "Search...\tCtrl+Space"),
            window.expect_found("laser surface", "LMS3D Surface Reconstruction"),
            window.press(window.SEARCH, window.ESCAPE))


class TestPythonState(WindowTest):
    """File > Save State as a Python script."""

    def test_pvpython_runs_it(self):
        state = self.home / "state.py"
        self.play(
            window.open_file(ROOM), window.add_filter("LMS3DScan"), window.APPLY,
            window.save_state(state), [("/StateOptionsDialog/widget/OKButton", "activate", "")])
        self.assertEqual(state.read_text().count("LoadPlugin("), 1)
        script = self.home / "check.py"
        script.write_text(
            f"exec(compile(open({str(state)!r}).read(), 'state', 'exec'))\n"
            "scan = FindSource('LMS3DScan1')\n"
            "scan.UpdatePipeline()\n"
            "print('class:', scan.SMProxy.GetClientSideObject().GetClassName())\n")
        done = subprocess.run(
            [os.environ["LMS3D_PVPYTHON"], str(script)], env=window.make_environment(self.home),
            capture_output=True, text=True, check=False, timeout=window.TIMEOUT)
        self.assertIn("class: vtkLMS3DScanFilter", done.stdout, done.stderr)


if __name__ == "__main__":
    unittest.main()
