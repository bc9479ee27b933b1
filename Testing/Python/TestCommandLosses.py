#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""How the command line reports the losses of a scene."""

import unittest

from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import lms3d
from command_line import COARSE, ROOM, CommandLineTest, run


class TestLosses(CommandLineTest):
    """A scene with faults is scanned as far as it can be read, and its losses are reported."""

    SQUARE = ("DEF Floor Shape { geometry IndexedFaceSet { coord Coordinate { point "
              "[ -9 -9 0, 9 -9 0, 9 9 0, -9 9 0 ] } coordIndex [ 0 1 2 3 -1 ] } }\n")

    def setUp(self):
        super().setUp()
        self.target = self.folder / "out.vtp"

    def write(self, text):
        path = self.folder / "scene.wrl"
        path.write_text("#VRML V2.0 utf8\n" + self.SQUARE + text)
        return path

    def test_a_scan_tells_what_is_lost(self):
        path = self.write('Inline { url "walls.wrl" }\nBox { length 3 }\n')
        result = run("scan", path, "--position", 0, 0, 1, *COARSE, "-o", self.target)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(self.target.exists())
        lines = result.stderr.splitlines()
        self.assertEqual(lines[0], f"lms3d: warning: {path} is incomplete: 2 of its parts are lost")
        self.assertEqual(lines[1], f'lms3d: error: {path}:3: an Inline is lost: "walls.wrl" '
                                   "does not exist or is not a regular file")
        self.assertIn(f"lms3d: warning: {path}:4: Box has no field", lines[3])

    def test_many_losses_are_a_few_lines(self):
        path = self.write("".join(f"USE A{i}\n" for i in range(100)))
        result = run("scan", path, "--position", 0, 0, 1, *COARSE, "-o", self.target)
        self.assertEqual(len(result.stderr.splitlines()), 12)
        self.assertIn("90 more messages", result.stderr)

    def test_a_whole_scene_needs_no_words(self):
        result = run("scan", self.write(""), "--position", 0, 0, 1, *COARSE, "-o", self.target)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_info(self):
        path = self.write("Group { children [ USE Floor Shape { geometry Box { } } ] }"
                          " USE Unknown\n")
        result = run("info", path)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(result.stdout.splitlines(), [
            "scene    scene.wrl: 16 triangles, axes as in the file, z is up",
            "x        -9 to 9 m", "y        -9 to 9 m", "z        -1 to 1 m",
            "shapes   3", "  Floor: 2 with 4 triangles", "  (no name): 1 with 12 triangles",
            "messages 1", f"  error: {path}:3: USE Unknown: no earlier node has this name"])

    def test_scene_root(self):
        scenes = self.folder / "scenes"
        scenes.mkdir()
        self.write("").rename(self.folder / "above.wrl")
        path = self.write('Inline { url "../above.wrl" }').rename(scenes / "scene.wrl")
        self.assertIn("--scene-root", run("info", path).stdout)
        result = run("info", path, "--scene-root", self.folder)
        self.assertIn("messages 0", result.stdout)
        scan = ("scan", path, "--position", 0, 0, 1, *COARSE, "-o", self.target)
        result = run(*scan, "--scene-root", self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        result = run(*scan, "--scene-root", self.folder / "nowhere")
        self.assertIn("is not a folder", result.stderr)
        self.assertNotEqual(result.returncode, 0)

    def test_scene_root_of_other_formats(self):
        path = self.folder / "ball.vtp"
        self._write(path)
        for option in ("--scene-root", self.folder), ("--scene-nodes", 100):
            result = run("info", path, *option)
            self.assertIn("is not a VRML file", result.stderr)
            self.assertNotEqual(result.returncode, 0)

    def test_limits_of_the_scene(self):
        path = self.write("USE Floor " * 9)
        self.assertIn("messages 0", run("info", path, "--scene-triangles", 20).stdout)
        for option, value in (("nodes", 9), ("triangles", 19)):
            with self.subTest(option):
                words = run("info", path, f"--scene-{option}", value).stdout
                self.assertIn(f"(on the command line --scene-{option})", words)
                self.assertIn("messages 1", words)

    def test_info_of_other_formats(self):
        path = self.folder / "ball.vtp"
        self._write(path)
        result = run("info", path)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("scene    ball.vtp: 804 triangles", result.stdout)
        self.assertIn("messages 0", result.stdout)

    @staticmethod
    def _write(path):
        reader = lms3d.vtkVRMLImporterSource()
        reader.SetFileName(str(ROOM))
        writer = vtkXMLPolyDataWriter()
        writer.SetInputConnection(reader.GetOutputPort())
        writer.SetDataModeToAscii()
        writer.SetFileName(str(path))
        writer.Write()


if __name__ == "__main__":
    unittest.main()
