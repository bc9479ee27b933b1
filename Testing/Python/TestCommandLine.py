#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command line as a user meets it: run as a process, judged by exit code, words and files.

The scenes lie in the folder LMS3D_DATA_DIR, or in ../../Data as seen from here.
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT, VTK_ID_TYPE, VTK_INT
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkImplicitPolyDataDistance
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataReader,
    vtkXMLMultiBlockDataWriter,
    vtkXMLPolyDataReader,
    vtkXMLPolyDataWriter,
    vtkXMLUnstructuredGridWriter,
    vtkXMLWriter,
)

import lms3d

DATA = Path(os.environ.get("LMS3D_DATA_DIR") or Path(__file__).resolve().parents[2] / "Data")
ROOM = DATA / "room.wrl"
TRIANGLES = 804
POSITION = np.array((0.3, -0.2, 1.0))
POSE = ("--position", *POSITION)
BEAMS, TURNS = 361, 360

COARSE_BEAMS, COARSE_TURNS = 31, 24
COARSE = ("--alpha-range", -60, 60, "--alpha-resolution", COARSE_BEAMS,
          "--beta-resolution", COARSE_TURNS)


def run(*arguments, **environment):
    """The finished process of `lms3d ARGUMENTS`; None takes a variable away."""
    variables = {**os.environ, **environment}
    return subprocess.run(
        [sys.executable, "-m", "lms3d", *map(str, arguments)], capture_output=True, text=True,
        env={name: text for name, text in variables.items() if text is not None}, timeout=300)


def read(reader, path):
    """What a VTK reader finds in a file."""
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def write(writer, data, path):
    """Write with a VTK writer."""
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    if isinstance(writer, vtkXMLWriter):
        writer.SetDataModeToBinary()  # not every VTK reads what its writers append by default
    writer.Write()


def array(data, name):
    """An array of the point data as numpy."""
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def points(data):
    """The coordinates as numpy."""
    return vtk_to_numpy(data.GetPoints().GetData())


def field(data, name):
    """An array of the field data as numpy, flat."""
    return vtk_to_numpy(data.GetFieldData().GetArray(name)).ravel()


def triangles(data):
    """The corners of each triangle, as numbers of points."""
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def pixels(path):
    """A picture as rows of colours, 0 to 255."""
    image = read(vtkPNGReader(), path)
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3).astype(int)


def room():
    """The scene of most tests."""
    return read(lms3d.vtkVRMLImporterSource(), ROOM)


class CommandLineTest(unittest.TestCase):
    """A folder of its own for each class, and what holds for every run."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)

    def done(self, *arguments, **environment):
        """Run a command that must succeed."""
        result = run(*arguments, **environment)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        return result.stdout

    def refused(self, code, *arguments, **environment):
        """Run a command that must fail with a code, in one line of words and without traces."""
        before = sorted(self.folder.iterdir())
        result = run(*arguments, **environment)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stderr, r"\Alms3d: error: [^\n]+\n\Z")
        self.assertEqual(sorted(self.folder.iterdir()), before)
        return result.stderr

    def coarse_ranges(self, name, *arguments):
        """The grid of ranges of a small scan, row for row the beams of a turn."""
        path = self.folder / f"{name}.vti"
        self.done("scan", *arguments, *COARSE, "--range-image", path)
        return array(read(vtkXMLImageDataReader(), path), "Range").reshape(COARSE_TURNS, -1)


class TestScan(CommandLineTest):
    """One scan of the room with the paper's grid, everything written."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        names = {"-o": "scan.vtp", "--range-image": "image.vti", "--map": "map.vtp",
                 "--picture": "picture.png"}
        options = [word for option, name in names.items() for word in (option, cls.folder / name)]
        cls.result = run("scan", ROOM, *POSE, *options)
        if cls.result.returncode != 0:
            raise AssertionError(cls.result.stderr)
        cls.scan = read(vtkXMLPolyDataReader(), cls.folder / "scan.vtp")
        cls.image = read(vtkXMLImageDataReader(), cls.folder / "image.vti")
        cls.map = read(vtkXMLPolyDataReader(), cls.folder / "map.vtp")

    def test_the_four_files_and_no_other(self):
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         ["image.vti", "map.vtp", "picture.png", "scan.vtp"])

    def test_the_summary_tells_numbers_axes_and_files(self):
        for words in (f"{TRIANGLES} triangles", "z is up", f"{BEAMS * TURNS:,} beams",
                      f"{self.scan.GetNumberOfPoints():,} returns",
                      f"{self.map.GetNumberOfPolys():,} triangles", "map.vtp"):
            self.assertIn(words, self.result.stdout)
        self.assertEqual(self.result.stderr, "")

    def test_arrays_of_the_scan(self):
        types = {"Range": VTK_DOUBLE, "Alpha": VTK_FLOAT, "Beta": VTK_FLOAT, "BeamId": VTK_INT,
                 "CellId": VTK_ID_TYPE}
        for name, expected in types.items():
            values = self.scan.GetPointData().GetArray(name)
            self.assertEqual(values.GetDataType(), expected, name)
            self.assertEqual(values.GetNumberOfTuples(), BEAMS * TURNS, name)
        self.assertEqual(self.scan.GetPoints().GetDataType(), VTK_DOUBLE)
        self.assertEqual(self.scan.GetNumberOfVerts(), BEAMS * TURNS)

    def test_a_closed_room_answers_every_beam_in_order(self):
        np.testing.assert_array_equal(array(self.scan, "BeamId"), np.arange(BEAMS * TURNS))
        self.assertLess(array(self.scan, "CellId").max(), TRIANGLES)
        self.assertGreaterEqual(array(self.scan, "CellId").min(), 0)

    def test_points_lie_where_the_papers_formula_says(self):
        turn, beam = np.divmod(array(self.scan, "BeamId"), BEAMS)
        alpha = np.radians(field(self.scan, "AlphaAngles"))[beam]
        beta = np.radians(field(self.scan, "BetaAngles"))[turn]
        direction = np.stack((np.cos(alpha) * np.cos(beta), -np.cos(alpha) * np.sin(beta),
                              np.sin(alpha)), axis=1)
        expected = POSITION + array(self.scan, "Range")[:, None] * direction
        np.testing.assert_allclose(points(self.scan), expected, atol=1e-9)

    def test_angles_and_pose(self):
        np.testing.assert_allclose(field(self.scan, "AlphaAngles"), np.linspace(-90, 90, BEAMS))
        np.testing.assert_allclose(field(self.scan, "BetaAngles"), np.arange(TURNS))
        pose = field(self.scan, "SensorToWorld").reshape(4, 4)
        np.testing.assert_array_equal(pose[:3, 3], POSITION)
        np.testing.assert_array_equal(pose[:3, :3], np.eye(3))

    def test_floor_and_ceiling_are_where_they_are(self):
        ranges = array(self.scan, "Range").reshape(TURNS, BEAMS)
        np.testing.assert_allclose(ranges[:, 0], 1.0, rtol=1e-12)
        np.testing.assert_allclose(ranges[:, -1], 2.0, rtol=1e-12)

    def test_the_range_image_is_the_scan_as_a_grid(self):
        self.assertEqual(self.image.GetDimensions(), (BEAMS, TURNS, 1))
        np.testing.assert_array_equal(array(self.image, "Range"), array(self.scan, "Range"))

    def test_the_map_is_triangles_that_face_the_sensor(self):
        corners = points(self.map)[triangles(self.map)]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        facing = np.einsum("ij,ij->i", normals, POSITION - corners[:, 0])
        self.assertGreaterEqual(facing.min(), -1e-12)
        self.assertIsNotNone(self.map.GetCellData().GetNormals())
        np.testing.assert_allclose(np.linalg.norm(points(self.map) - POSITION, axis=1),
                                   array(self.map, "Range"), atol=1e-9)

    def test_a_few_triangles_are_within_a_centimetre_of_every_return(self):
        self.assertLess(self.map.GetNumberOfPolys(), 3000)
        self.assertLessEqual(field(self.map, "LargestDeviation"), 0.01)
        distance = vtkImplicitPolyDataDistance()
        distance.SetInput(self.map)
        farthest = max(abs(distance.EvaluateFunction(point)) for point in points(self.scan)[::97])
        self.assertLessEqual(farthest, 0.01 + 1e-6)

    def test_the_picture_is_blue_left_and_green_right(self):
        picture = pixels(self.folder / "picture.png")
        self.assertEqual(picture.shape, (620, 1600, 3))
        red, green, blue = np.moveaxis(picture, 2, 0)
        is_blue = (blue > green + 20) & (green > red)
        is_green = (green > red + 20) & (green > blue + 20)
        self.assertGreater(is_blue[:, :800].mean(), 0.3)
        self.assertGreater(is_green[:, 800:].mean(), 0.3)
        self.assertLess(is_blue[:, 800:].mean(), 0.02)
        self.assertLess(is_green[:, :800].mean(), 0.02)


class TestOptions(CommandLineTest):
    """What each option does to a small scan."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.plain = cls().coarse_ranges("plain", ROOM, *POSE)

    def test_turning_the_sensor_about_z_shifts_the_turns(self):
        turned = self.coarse_ranges("turned", ROOM, *POSE, "--orientation", 0, 0, 45)
        same = np.isclose(turned, np.roll(self.plain, 3, axis=0), atol=1e-9)
        self.assertGreater(same.mean(), 0.99)
        self.assertLess(np.isclose(turned, self.plain, atol=1e-9).mean(), 0.9)

    def test_moving_the_sensor_up_moves_floor_and_ceiling(self):
        path = self.folder / "up.csv"
        self.done("scan", ROOM, "--position", 0.3, -0.2, "1.25e0", "-o", path)
        up = np.genfromtxt(path, delimiter=",", names=True)
        self.assertAlmostEqual(up["Range"][up["Alpha"] == -90][0], 1.25, places=12)
        self.assertAlmostEqual(up["Range"][up["Alpha"] == 90][0], 1.75, places=12)

    def test_ranges_cut_and_the_image_keeps_the_misses(self):
        cut = self.coarse_ranges("cut", ROOM, *POSE, "--minimum-range", 1.5,
                                 "--maximum-range", 3)
        inside = (self.plain >= 1.5) & (self.plain <= 3)
        np.testing.assert_array_equal(np.isfinite(cut), inside)
        np.testing.assert_array_equal(cut[inside], self.plain[inside])
        self.assertTrue(0 < inside.sum() < inside.size)

    def test_one_thread_and_many_write_the_same_bytes(self):
        for threads in (1, 2, 7):
            result = run("scan", ROOM, *POSE, *COARSE, "--threads", threads,
                         "-o", self.folder / f"threads{threads}.csv")
            self.assertEqual(result.returncode, 0, result.stderr)
        one, *others = [(self.folder / f"threads{n}.csv").read_bytes() for n in (1, 2, 7)]
        self.assertEqual(others, [one, one])

    def test_fast_agrees_with_exact(self):
        fast = self.coarse_ranges("fast", ROOM, *POSE, "--method", "fast")
        self.assertGreater(np.isclose(fast, self.plain, atol=1e-5).mean(), 0.99)

    def test_a_larger_depth_step_tears_less(self):
        counts = []
        for step in (0.01, 0.1, 100):
            path = self.folder / "step.vtp"
            self.done("scan", ROOM, *POSE, *COARSE, "--depth-step", step, "--maximum-error", 0,
                      "--map", path)
            counts.append(read(vtkXMLPolyDataReader(), path).GetNumberOfPolys())
        self.assertEqual(counts, sorted(counts))
        self.assertLess(counts[0], counts[2])
        self.assertEqual(counts[2], 2 * (COARSE_BEAMS - 1) * COARSE_TURNS)

    def test_a_larger_maximum_error_takes_fewer_triangles(self):
        counts = []
        for error in (0.001, 0.01, 0.1):
            path = self.folder / "error.vtp"
            self.done("scan", ROOM, *POSE, "--maximum-error", error, "--map", path)
            local_map = read(vtkXMLPolyDataReader(), path)
            counts.append(local_map.GetNumberOfPolys())
            self.assertLessEqual(field(local_map, "LargestDeviation"), error)
        self.assertEqual(counts, sorted(counts, reverse=True))
        self.assertLess(counts[2], counts[0])

    def test_without_a_maximum_error_every_return_is_a_corner(self):
        scan_path, map_path = self.folder / "all.vtp", self.folder / "all_map.vtp"
        self.done("scan", ROOM, *POSE, *COARSE, "--maximum-error", 0, "-o", scan_path,
                  "--map", map_path)
        np.testing.assert_array_equal(points(read(vtkXMLPolyDataReader(), map_path)),
                                      points(read(vtkXMLPolyDataReader(), scan_path)))

    def test_the_largest_numbers_that_are_taken(self):
        self.done("scan", ROOM, *POSE, *COARSE, "--threads", 1024, "--maximum-range", "1e18",
                  "-o", self.folder / "largest.vtp")

    def test_numbers_below_zero_in_any_notation(self):
        self.done("scan", ROOM, "--position", "-1e-1", "-.5", "+1", *COARSE,
                  "-o", self.folder / "negative.vtp")
        scan = read(vtkXMLPolyDataReader(), self.folder / "negative.vtp")
        np.testing.assert_array_equal(field(scan, "SensorToWorld")[3:12:4], (-0.1, -0.5, 1))


class TestFormats(CommandLineTest):
    """Each ending, to write and to read."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for ending in ("vtp", "ply", "csv"):
            cls().done("scan", ROOM, *POSE, *COARSE, "-o", cls.folder / f"scan.{ending}")
        for ending in ("vtp", "ply", "stl"):
            cls().done("scan", ROOM, *POSE, *COARSE, "--map", cls.folder / f"map.{ending}")
        cls.scan = read(vtkXMLPolyDataReader(), cls.folder / "scan.vtp")
        cls.map = read(vtkXMLPolyDataReader(), cls.folder / "map.vtp")

    def test_csv_keeps_every_bit(self):
        table = np.genfromtxt(self.folder / "scan.csv", delimiter=",", names=True)
        names = ("x", "y", "z", "Range", "Alpha", "Beta", "BeamId", "CellId")
        self.assertEqual(table.dtype.names, names)
        np.testing.assert_array_equal(np.stack([table[name] for name in "xyz"], axis=1),
                                      points(self.scan))
        for name in names[3:]:
            expected = array(self.scan, name)
            np.testing.assert_array_equal(table[name].astype(expected.dtype), expected)

    def test_ply_points(self):
        cloud = read(vtkPLYReader(), self.folder / "scan.ply")
        np.testing.assert_allclose(points(cloud), points(self.scan), rtol=1e-6, atol=1e-6)

    def test_ply_map(self):
        surface = read(vtkPLYReader(), self.folder / "map.ply")
        np.testing.assert_array_equal(triangles(surface), triangles(self.map))
        np.testing.assert_allclose(points(surface), points(self.map), rtol=1e-6, atol=1e-6)

    def test_stl_map(self):
        reader = vtkSTLReader()
        reader.MergingOff()
        surface = read(reader, self.folder / "map.stl")
        corners = points(self.map)[triangles(self.map)].reshape(-1, 3)
        np.testing.assert_allclose(points(surface), corners, rtol=1e-6, atol=1e-6)

    def test_every_scene_format_gives_the_same_ranges(self):
        expected = self.coarse_ranges("wrl", ROOM, *POSE)
        scenes = self._copies_of_the_room()
        for path in scenes:
            with self.subTest(path.suffix):
                ranges = self.coarse_ranges("copy", path, *POSE)
                # Copies in single precision may decide otherwise where a beam grazes an edge.
                self.assertGreater(np.isclose(ranges, expected, atol=1e-4).mean(), 0.99)

    def test_a_scene_with_y_up_is_turned_on_demand(self):
        expected = self.coarse_ranges("z_up", ROOM, *POSE)
        for ending in ("vtp", "wrl"):
            with self.subTest(ending):
                path = self.folder / f"y_up.{ending}"
                {"vtp": self._write_y_up_vtp, "wrl": self._write_y_up_vrml}[ending](path)
                ranges = self.coarse_ranges("y_up", path, *POSE, "--up-axis", "y")
                self.assertGreater(np.isclose(ranges, expected, atol=1e-6).mean(), 0.99)
        words = self.done("scan", path, *POSE, *COARSE, "--up-axis", "y",
                          "-o", self.folder / "words.vtp")
        self.assertIn("turned from y-up to z-up", words)

    @staticmethod
    def _write_y_up_vtp(path):
        z_to_y = vtkTransform()
        z_to_y.RotateX(-90)
        turn = vtkTransformFilter()
        turn.SetTransform(z_to_y)
        turn.SetInputData(room())
        turn.Update()
        write(vtkXMLPolyDataWriter(), turn.GetOutput(), path)

    @staticmethod
    def _write_y_up_vrml(path):
        """The room again as one face set, written by hand."""
        surface = room()
        turned = points(surface)[:, (0, 2, 1)] * (1, 1, -1)
        coordinates = ", ".join("%.9g %.9g %.9g" % tuple(point) for point in turned)
        faces = ", ".join("%d, %d, %d, -1" % tuple(corners) for corners in triangles(surface))
        path.write_text(
            "#VRML V2.0 utf8\nShape { geometry IndexedFaceSet {\n"
            f"coord Coordinate {{ point [ {coordinates} ] }}\ncoordIndex [ {faces} ] }} }}\n")

    def _copies_of_the_room(self):
        surface = room()
        append = vtkAppendFilter()
        append.SetInputData(surface)
        append.Update()
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, surface)
        writers = {"vtp": (vtkXMLPolyDataWriter(), surface), "stl": (vtkSTLWriter(), surface),
                   "ply": (vtkPLYWriter(), surface), "obj": (vtkOBJWriter(), surface),
                   "vtu": (vtkXMLUnstructuredGridWriter(), append.GetOutput()),
                   "vtm": (vtkXMLMultiBlockDataWriter(), blocks)}
        for ending, (writer, data) in writers.items():
            write(writer, data, self.folder / f"room.{ending}")
        (self.folder / "room.vrml").write_bytes(ROOM.read_bytes())
        return [self.folder / f"room.{ending}" for ending in (*writers, "vrml")]


class TestCompare(CommandLineTest):
    """The errors of maps of the room, and those of a wall that was moved by hand."""

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

    def test_a_map_that_has_lost_the_pose_is_told_it(self):
        told = self.compare("map.stl", ROOM, *POSE)
        known = self.compare("map.vtp", ROOM)
        for name in ("map to scene", "visible scene to map", "normals"):
            np.testing.assert_allclose(self.errors(told, name), self.errors(known, name), rtol=0.01)

    def test_results_for_scripts(self):
        from lms3d.comparison import compare

        wall, near = (read(vtkOBJReader(), self.folder / f"{name}.obj") for name in ("wall", "near"))
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
            "does not say where the sensor was": (2, wall, wall, *output),
            "leave one": (2, wall, wall, *pose, "--scan", self.folder / "scan.vtp"),
            "--orientation: of no use": (2, wall, wall, "--orientation", 0, 0, 9, *output),
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
            "not all of the field data": (1, wall, wall, "--scan", self.folder / "bare.vtp"),
            "sees nothing of the scene": (1, self.folder / "map.vtp", wall, "--maximum-range", 0.1,
                                          *output),
        }
        write(vtkXMLPolyDataWriter(), room(), self.folder / "bare.vtp")
        for expected, (code, *arguments) in cases.items():
            with self.subTest(expected):
                self.assertIn(expected, self.refused(code, "compare", *arguments))


class TestProblems(CommandLineTest):
    """What is refused: the exit code, the words, and that no file appears."""

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
            "no depth": ("scan", ROOM, *POSE, *output, "--depth-step", 0),
            "one name twice": ("scan", ROOM, *POSE, *output, "--map", self.target),
            "no step": ("view", ROOM, "--step", 0),
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


class TestLosses(CommandLineTest):
    """A scene that cannot be read whole is scanned, and said to be so."""

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
        self.assertEqual(lines[0], f"lms3d: warning: {path} is not whole: 2 of its parts are lost")
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
        path = self.write("Group { children [ USE Floor Shape { geometry Box { } } ] } USE Missing\n")
        result = run("info", path)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(result.stdout.splitlines(), [
            "scene    scene.wrl: 16 triangles, axes as in the file, z is up",
            "x        -9 to 9 m", "y        -9 to 9 m", "z        -1 to 1 m",
            "shapes   3", "  Floor: 2 with 4 triangles", "  (no name): 1 with 12 triangles",
            "messages 1", f"  error: {path}:3: USE Missing: no earlier node has this name"])

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
        self.assertIn("is no folder", result.stderr)
        self.assertNotEqual(result.returncode, 0)

    def test_scene_root_of_other_formats(self):
        path = self.folder / "ball.vtp"
        self._write(path)
        result = run("info", path, "--scene-root", self.folder)
        self.assertIn("is no VRML file", result.stderr)
        self.assertNotEqual(result.returncode, 0)

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


class TestHelp(CommandLineTest):
    """The help teaches: units, frame, defaults, examples."""

    def test_overview(self):
        words = self.done("--help")
        for expected in ("scan", "compare", "view", "demo", "metres", "degrees", "z up", "clockwise",
                         "exit codes", "examples"):
            self.assertIn(expected, words)

    def test_each_command_has_an_example_and_each_option_a_text(self):
        for command in ("scan", "compare", "view", "demo"):
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
    """Both figures of the paper."""

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
        for name in ("figure5_room.png", "figure6_teapot.png"):
            self.assertEqual(pixels(self.folder / "demo" / name).shape, (620, 1600, 3))
            self.assertIn(name, words)
        self.assertEqual(len(list((self.folder / "demo").iterdir())), 8)
        self.assertIn("z is up", words)


if __name__ == "__main__":
    unittest.main()
