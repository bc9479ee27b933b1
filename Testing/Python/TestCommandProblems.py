#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the command line refuses."""

import tempfile
import unittest
from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkIOPLY import vtkPLYWriter

from command_line import COARSE, POSE, ROOM, CommandLineTest, room, write


class TestProblems(CommandLineTest):
    """What is refused: the exit code, the message, and that no file appears."""

    def setUp(self):
        self.target = self.folder / "out.vtp"

    def test_wrong_arguments(self):
        output = ("-o", self.target)
        wrong = {
            "no command": (),
            "unknown command": ("sweep",),
            "no scene": ("scan", *POSE, *output),
            "no position": ("scan", ROOM, *output),
            "nothing to write": ("scan", ROOM, *POSE),
            "unknown option": ("scan", ROOM, *POSE, *output, "--colour", "red"),
            "half a position": ("scan", ROOM, "--position", 1, 2, *output),
            "no number": ("scan", ROOM, "--position", 0, 0, "up", *output),
            "not a number": ("scan", ROOM, "--position", 0, 0, "nan", *output),
            "alpha beyond the poles": ("scan", ROOM, *POSE, *output, "--alpha-range", -91, 90),
            "alpha falls": ("scan", ROOM, *POSE, *output, "--alpha-range", 10, -10),
            "more than a circle": ("scan", ROOM, *POSE, *output, "--beta-range", 0, 361),
            "no beam": ("scan", ROOM, *POSE, *output, "--alpha-resolution", 0),
            "more beams than an int": ("scan", ROOM, *POSE, *output, "--alpha-resolution", 2**31),
            "more turns than an int": ("scan", ROOM, *POSE, *output,
                                       "--beta-resolution", 99999999999),
            "half a turn": ("scan", ROOM, *POSE, *output, "--beta-resolution", 1.5),
            "position too far": ("scan", ROOM, "--position", 0, "-1.1e18", 0, *output),
            "view from too far": ("view", ROOM, "--position", "1e19", 0, 0),
            "range below zero": ("scan", ROOM, *POSE, *output, "--minimum-range", -1),
            "ranges fall": ("scan", ROOM, *POSE, *output, "--minimum-range", 5,
                            "--maximum-range", 2),
            "no range": ("scan", ROOM, *POSE, *output, "--maximum-range", 0),
            "threads below zero": ("scan", ROOM, *POSE, *output, "--threads", -1),
            "too many threads": ("scan", ROOM, *POSE, *output, "--threads", 1025),
            "more threads than an int": ("scan", ROOM, *POSE, *output, "--threads", 99999999999),
            "picture too large": ("scan", ROOM, *POSE, "--picture", self.folder / "out.png",
                                  "--size", 99999999999, 620),
            "picture wider than OpenGL draws": ("scan", ROOM, *POSE, "--picture",
                                                self.folder / "out.png", "--size", 16385, 620),
            "unknown method": ("scan", ROOM, *POSE, *output, "--method", "guess"),
            "unknown axis": ("scan", ROOM, *POSE, *output, "--up-axis", "x"),
            "error below zero": ("scan", ROOM, *POSE, *output, "--maximum-error", -0.01),
            "endless error": ("scan", ROOM, *POSE, *output, "--maximum-error", "inf"),
            "error of a demo": ("demo", "--output", self.folder, "--maximum-error", -1),
            "gap below -1": ("scan", ROOM, *POSE, *output, "--maximum-gap-size", -2),
            "speckle too large": ("scan", ROOM, *POSE, *output, "--maximum-speckle-size", 1000001),
            "no depth": ("scan", ROOM, *POSE, *output, "--depth-step", 0),
            "attributes in a format without": ("scan", ROOM, *POSE, "--surface-attributes", "-o",
                                               self.folder / "out.csv"),
            "attributes without points": ("scan", ROOM, *POSE, "--surface-attributes", "--map",
                                          self.folder / "out.ply"),
            "one name twice": ("scan", ROOM, *POSE, *output, "--map", self.target),
            "no step": ("view", ROOM, "--step", 0),
            "no memory": ("scan", ROOM, *POSE, *output, "--scene-memory", 0),
            "screenshot as text": ("view", ROOM, "--screenshot", self.folder / "picture.txt"),
        }
        for name, arguments in wrong.items():
            with self.subTest(name):
                self.refused(2, *arguments)

    def test_a_format_that_cannot_hold_the_data_names_those_that_can(self):
        for option, ending, right in (("-o", "vti", ".vtp or .ply or .csv"),
                                      ("-o", "stl", ".vtp or .ply or .csv"),
                                      ("--map", "csv", ".vtp or .ply or .stl"),
                                      ("--range-image", "vtp", ".vti"),
                                      ("--picture", "gif", ".png")):
            with self.subTest(option + ending):
                path = self.folder / f"out.{ending}"
                self.assertIn(right, self.refused(2, "scan", ROOM, *POSE, option, path))

    def test_formats_are_checked_before_the_scene_is_read(self):
        self.refused(2, "scan", "nowhere.wrl", *POSE, "-o", self.folder / "out.vti")

    def test_an_unknown_scene_format_lists_the_known_ones(self):
        words = self.refused(2, "scan", "room.step", *POSE, "-o", self.target)
        for ending in ".wrl .vrml .vtp .stl .ply .obj .vtu .vtm".split():
            self.assertIn(ending, words)

    def test_a_missing_scene(self):
        words = self.refused(1, "scan", "nowhere.wrl", *POSE, "-o", self.target)
        self.assertIn("nowhere.wrl", words)

    def test_names_that_the_system_refuses(self):
        name = 300 * "x" + ".wrl"
        expected = f"lms3d: error: cannot use '{name}': File name too long\n"
        self.assertEqual(self.refused(1, "info", name), expected)

    def test_a_scene_that_is_a_folder(self):
        for name in ("scene", "scene.wrl"):
            with self.subTest(name):
                folder = self.folder / name
                folder.mkdir()
                words = self.refused(1, "scan", folder, *POSE, "-o", self.target)
                self.assertIn(f"'{folder}': that is a folder", words)

    def test_broken_scenes_are_refused_in_vtks_words(self):
        for ending, expected in (("wrl", "VRML"), ("vtp", "XML"), ("stl", "solid"),
                                 ("ply", "PLY"), ("obj", "no triangles")):
            with self.subTest(ending):
                path = self.folder / f"broken.{ending}"
                path.write_text("<this is no scene>")
                words = self.refused(1, "scan", path, *POSE, "-o", self.target)
                self.assertIn(expected, words)
                self.assertIn(path.name, words)
                self.assertNotRegex(words, r"0x[0-9a-f]{4}|\.cxx")

    def test_a_sensor_that_sees_nothing(self):
        words = self.refused(1, "scan", ROOM, "--position", 500, 0, 0, "-o", self.target)
        self.assertIn("no beam returned", words)
        self.assertIn("500 0 0", words)

    def test_more_beams_than_can_be_numbered(self):
        words = self.refused(2, "scan", ROOM, *POSE, "-o", self.target,
                             "--alpha-resolution", 100000, "--beta-resolution", 100000)
        self.assertIn("10000000000 beams", words)
        self.assertIn("2147483647", words)

    def test_what_the_filter_refuses_is_said_in_its_words(self):
        far = self.folder / "far.obj"
        far.write_text("v 0 0 0\nv 1 0 0\nv 0 1e19 0\nf 1 2 3\n")
        words = self.refused(1, "scan", far, *POSE, "-o", self.target)
        self.assertIn("nothing left to scan", words)
        self.assertIn("1e18", words)

    def test_places_that_cannot_be_written_to(self):
        nowhere = self.folder / "missing" / "out.vtp"
        self.assertIn("no folder", self.refused(1, "scan", ROOM, *POSE, "-o", nowhere))
        (self.folder / "folder.vtp").mkdir()
        self.assertIn("is a folder",
                      self.refused(1, "scan", ROOM, *POSE, "-o", self.folder / "folder.vtp"))

    def test_the_scene_is_never_overwritten(self):
        scene = self.folder / "scene.ply"
        write(vtkPLYWriter(), room(), scene)
        before = scene.read_bytes()
        self.refused(2, "scan", scene, *POSE, "-o", scene)
        self.assertEqual(scene.read_bytes(), before)

    def test_a_writer_that_fails_leaves_the_old_file(self):
        from lms3d.problems import Problem
        from lms3d.results import save

        folder = self.folder / "kept"
        folder.mkdir()
        (folder / "old.vtp").write_text("old")
        with self.assertRaises(Problem):
            save(vtkMultiBlockDataSet(), folder / "old.vtp")
        self.assertEqual((folder / "old.vtp").read_text(), "old")
        self.assertEqual(len(list(folder.iterdir())), 1)

    def test_no_display(self):
        for display in (None, ":4711"):
            with self.subTest(display):
                words = self.refused(1, "view", ROOM, *POSE, DISPLAY=display, WAYLAND_DISPLAY=None)
                self.assertIn("display", words)
                self.refused(1, "scan", ROOM, *POSE, "--picture", self.folder / "out.png",
                             DISPLAY=display, WAYLAND_DISPLAY=None)

    def test_scans_need_no_display(self):
        with tempfile.TemporaryDirectory() as folder:
            self.done("scan", ROOM, *POSE, *COARSE, "-o", Path(folder) / "out.vtp", DISPLAY=None)

    def test_a_demo_without_scenes(self):
        words = self.refused(1, "demo", "--data", self.folder, "--output", self.folder)
        self.assertIn("room.wrl", words)
        self.assertIn("--data", words)


if __name__ == "__main__":
    unittest.main()
