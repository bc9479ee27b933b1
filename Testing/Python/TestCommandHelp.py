#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The help of the command line, lms3d view and lms3d demo."""

import re
import unittest

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

import lms3d
from command_line import COARSE, DATA, POSE, ROOM, CommandLineTest, array, pixels, read


class TestHelp(CommandLineTest):
    """The help teaches: units, frame, defaults, examples."""

    def test_overview(self):
        words = self.done("--help")
        for expected in ("scan", "compare", "view", "emulate", "demo", "metres", "degrees", "z up",
                         "clockwise", "exit codes", "examples"):
            self.assertIn(expected, words)

    def test_each_command_has_an_example_and_each_option_a_text(self):
        for command in ("scan", "compare", "view", "emulate", "demo"):
            with self.subTest(command):
                words = self.done(command, "--help", COLUMNS="100")
                self.assertIn(f"  lms3d {command} ", words)
                self.assertNotRegex(words, r"\n  -[^\n]+\n  -(?!-)\S+\n")

    def test_defaults_are_the_papers(self):
        words = " ".join(self.done("scan", "--help").split())
        for default in ("-90 90", "361", "0 360", "360", "80", "0.01", "0.1", "1600 620"):
            self.assertRegex(words, rf"default: {re.escape(default)}[),]")

    def test_version(self):
        self.assertEqual(self.done("--version"), f"lms3d {lms3d.__version__}\n")


class TestView(CommandLineTest):
    """The window's picture."""

    def test_the_screenshot_is_the_picture_of_a_scan(self):
        arguments = (ROOM, *POSE, *COARSE, "--size", 400, 160)
        self.done("view", *arguments, "--screenshot", self.folder / "view.png")
        self.done("scan", *arguments, "--picture", self.folder / "scan.png")
        view, scan = (pixels(self.folder / f"{name}.png") for name in ("view", "scan"))
        self.assertEqual(view.shape, (160, 400, 3))
        np.testing.assert_array_equal(view, scan)

    def test_edges_of_the_map(self):
        arguments = (ROOM, *POSE, "--size", 400, 160, "--screenshot")
        self.done("view", *arguments, self.folder / "plain.png")
        self.done("view", *arguments, self.folder / "edges.png", "--edges")
        plain, edges = (pixels(self.folder / f"{name}.png") for name in ("plain", "edges"))
        np.testing.assert_array_equal(plain[:, :200], edges[:, :200])
        dark = [(half[:, 200:].sum(axis=2) < 260).mean() for half in (plain, edges)]
        self.assertGreater(dark[1], dark[0] + 0.02)

    def test_without_a_position_the_sensor_stands_in_the_middle(self):
        self.done("view", ROOM, *COARSE, "--size", 400, 160,
                  "--screenshot", self.folder / "middle.png")
        self.assertLess(pixels(self.folder / "middle.png").min(), 200)


class TestDemo(CommandLineTest):
    """Both figures of the paper, and the pictures of a real device's errors and map."""

    def test_files_and_table(self):
        words = self.done("demo", "--data", DATA, "--output", self.folder / "demo")
        for name in ("room", "teapot"):
            scan = read(vtkXMLPolyDataReader(), self.folder / "demo" / f"{name}_scan.vtp")
            local_map = read(vtkXMLPolyDataReader(), self.folder / "demo" / f"{name}_map.vtp")
            image = read(vtkXMLImageDataReader(), self.folder / "demo" / f"{name}_range.vti")
            self.assertEqual(np.isfinite(array(image, "Range")).sum(), scan.GetNumberOfPoints())
            row = next(line.split() for line in words.splitlines() if line.startswith(name))
            self.assertEqual(row[2], f"{image.GetNumberOfPoints():,}")
            self.assertEqual(row[3], f"{scan.GetNumberOfPoints():,}")
            self.assertEqual(row[5], f"{local_map.GetNumberOfPolys():,}")
        for name in ("figure5_room.png", "figure6_teapot.png", "device_room.png",
                     "device_map_room.png"):
            self.assertEqual(pixels(self.folder / "demo" / name).shape, (620, 1600, 3))
            self.assertIn(name, words)
        self.assertEqual(len(list((self.folder / "demo").iterdir())), 12)
        self.assertIn("z is up", words)
        self.check_reported(words)

    def check_reported(self, words):
        """The reported scan has the errors of an LMS 200."""
        ideal, reported = (read(vtkXMLPolyDataReader(), self.folder / "demo" / f"room_{name}.vtp")
                           for name in ("scan", "reported"))
        beams, error = array(reported, "BeamId"), array(reported, "RangeError")
        ranges = np.full(361 * 360, np.nan)
        ranges[array(ideal, "BeamId")] = array(ideal, "Range")
        np.testing.assert_array_equal(error, array(reported, "Range") - ranges[beams])
        millimetres = 1000 * array(reported, "Range")
        np.testing.assert_allclose(millimetres, np.round(millimetres), atol=1e-9)
        self.assertTrue(0.003 < np.nanmedian(abs(error)) < 0.004)  # 0.67 standard deviations
        self.assertIn(f"lms200-mm: {len(error):,} returns", words)
        local_map = read(vtkXMLPolyDataReader(), self.folder / "demo" / "room_reported_map.vtp")
        self.assertIn(f"{local_map.GetNumberOfPolys():,} map triangles", words)
        self.assertLess(local_map.GetNumberOfPolys(), 10_000)


if __name__ == "__main__":
    unittest.main()
