#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d compare: its numbers, its files, and what it refuses."""

import re
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import lms3d
from command_line import (
    BEAMS,
    POSE,
    ROOM,
    TURNS,
    CommandLineTest,
    array,
    field,
    read,
    room,
    triangles,
    write,
)


class TestCompare(CommandLineTest):
    """The errors of maps of the room, and of a wall that was moved by 30 mm."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name in ("map.vtp", "map.stl"):
            cls().done("scan", ROOM, *POSE, "-o", cls.folder / "scan.vtp",
                       "--map", cls.folder / name)
        cls.write_wall("wall.obj", 2)
        cls.write_wall("near.obj", 1.97)

    @classmethod
    def write_wall(cls, name, x):
        """A square of 2 m x 2 m at x, that looks towards the origin."""
        (cls.folder / name).write_text(
            f"v {x} -1 -1\nv {x} -1 1\nv {x} 1 1\nv {x} 1 -1\nf 1 2 3 4\n")

    def compare(self, name, scene, *arguments):
        return self.done("compare", self.folder / name, scene, *arguments)

    def errors(self, words, name):
        """Mean, RMS, 95 % and maximum of a row of the table."""
        row = re.search(rf"^{name} +([\d. ]+)  (?:mm|degrees)$", words, re.MULTILINE)
        return [float(number) for number in row[1].split()]

    def test_a_wall_that_is_30_mm_too_near(self):
        words = self.compare("near.obj", self.folder / "wall.obj", "--position", 0, 0, 0)
        self.assertEqual(self.errors(words, "map to scene"), [30, 30, 30, 30])
        self.assertEqual(self.errors(words, "visible scene to map"), [30, 30, 30, 30])
        self.assertEqual(self.errors(words, "normals"), [0, 0, 0, 0])
        self.assertIn("within 10 mm: correct 0.00 %, complete 0.00 %, F 0.00 %", words)
        self.assertIn("in free space: 4 m2", words)
        self.assertIn("map      2 triangles, 4 m2; visible of the scene 4 m2", words)

    def test_a_larger_tolerance_forgives(self):
        words = self.compare("near.obj", self.folder / "wall.obj", "--position", 0, 0, 0,
                             "--tolerance", 0.05)
        self.assertIn("within 50 mm: correct 100.00 %, complete 100.00 %, F 100.00 %", words)
        self.assertIn("in free space: 0 m2", words)

    def test_the_map_of_the_room(self):
        output, points_file = self.folder / "errors.vtp", self.folder / "points.vtp"
        words = self.compare("map.vtp", ROOM, "--scan", self.folder / "scan.vtp", "-o", output,
                             "--scene-points", points_file)
        self.assertLess(self.errors(words, "map to scene")[0], 1)
        self.assertLess(self.errors(words, "normals")[0], 3)
        self.assertIn(f"returns: {BEAMS * TURNS:,}", words)
        errors = read(vtkXMLPolyDataReader(), output)
        self.assertEqual(errors.GetNumberOfPoints(), array(errors, "Error").size)
        largest = vtk_to_numpy(errors.GetCellData().GetArray("LargestError"))
        of_corners = array(errors, "Error")[triangles(errors)].max(axis=1)
        self.assertTrue(np.all(largest >= of_corners))
        self.assertGreater(largest.max(), 0.01)
        self.assertGreaterEqual(largest.max(), field(errors, "MapToScene")[3])
        self.assertAlmostEqual(1000 * field(errors, "MapToScene")[3],
                               self.errors(words, "map to scene")[3], delta=0.005)
        lacking = array(read(vtkXMLPolyDataReader(), points_file), "Error")
        self.assertAlmostEqual(1000 * lacking.mean(),
                               self.errors(words, "visible scene to map")[0], delta=0.005)

    def test_a_map_without_a_pose_gets_it_from_the_options(self):
        without = self.compare("map.stl", ROOM, *POSE)
        within = self.compare("map.vtp", ROOM)
        # STL has coordinates in single precision, so the last digit can differ.
        for name in ("map to scene", "visible scene to map", "normals"):
            np.testing.assert_allclose(self.errors(without, name), self.errors(within, name),
                                       rtol=0.01, atol=0.01)

    def test_results_for_scripts(self):
        from lms3d.comparison import compare

        wall, near = (read(vtkOBJReader(), self.folder / name) for name in ("wall.obj", "near.obj"))
        scan = lms3d.vtkLMS3DScanFilter()
        scan.SetInputData(wall)
        scan.Update()
        result = compare(near, wall, scan.GetOutput(), samples=1000, ranges=(0, 2.3))
        self.assertAlmostEqual(result.map_to_scene.maximum, 0.03)
        self.assertEqual(result.triangles, 2)
        self.assertAlmostEqual(result.map_area, 4)
        self.assertLess(result.visible_area, 4)
        self.assertEqual(result.returns_within_tolerance, 0)
        self.assertAlmostEqual(result.largest_return_distance, 0.03)

    def test_one_thread_and_many_write_the_same_bytes(self):
        for threads in (1, 2, 7):
            self.compare("map.vtp", ROOM, "--samples", 5000, "--threads", threads,
                         "-o", self.folder / f"threads{threads}.vtp")
        one, *others = [(self.folder / f"threads{n}.vtp").read_bytes() for n in (1, 2, 7)]
        self.assertEqual(others, [one, one])

    def test_what_cannot_be_compared(self):
        wall = self.folder / "wall.obj"
        empty = self.folder / "empty.obj"
        empty.write_text("v 0 0 0\n")
        pose = ("--position", 0, 0, 0)
        output = ("-o", self.folder / "out.vtp")
        cases = {
            "does not have the sensor's pose": (2, wall, wall, *output),
            "give only one": (2, wall, wall, *pose, "--scan", self.folder / "scan.vtp"),
            "--orientation: needs --position": (2, wall, wall, "--orientation", 0, 0, 9, *output),
            "ending must be .vtp": (2, wall, wall, *pose, "-o", self.folder / "out.ply"),
            "both map and map with errors": (2, self.folder / "map.vtp", ROOM, "-o",
                                             self.folder / "map.vtp"),
            "the ending is not one of .vtp .ply": (2, "map.gltf", wall, *pose, *output),
            "not above 0": (2, wall, wall, *pose, "--tolerance", 0),
            "is above 10000000": (2, wall, wall, *pose, "--samples", 10000001),
            "cannot read map 'nowhere.stl': no such": (1, "nowhere.stl", wall, *pose, *output),
            "cannot read scene 'nowhere.stl': no such": (1, wall, "nowhere.stl", *pose, *output),
            "in the map": (1, empty, wall, *pose, *output),
            "the file holds no triangles": (1, wall, empty, *pose, *output),
            "no beam returned": (1, wall, wall, "--position", 500, 0, 0, *output),
            "lacks some of the field data": (1, wall, wall, "--scan", self.folder / "bare.vtp"),
            "sees nothing of the scene": (1, self.folder / "map.vtp", wall, "--maximum-range", 0.1,
                                          *output),
        }
        write(vtkXMLPolyDataWriter(), room(), self.folder / "bare.vtp")
        for expected, (code, *arguments) in cases.items():
            with self.subTest(expected):
                self.assertIn(expected, self.refused(code, "compare", *arguments))


if __name__ == "__main__":
    unittest.main()
