#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d scan: its results, and the effect of its options."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT, VTK_ID_TYPE, VTK_INT
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

from command_line import (
    BEAMS,
    COARSE,
    COARSE_BEAMS,
    COARSE_TURNS,
    POSE,
    POSITION,
    ROOM,
    TRIANGLES,
    TURNS,
    CommandLineTest,
    array,
    field,
    pixels,
    points,
    read,
    room,
    run,
    triangles,
)


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

    def test_a_closed_room_returns_every_beam_in_order(self):
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
    """The effect of each option on a small scan."""

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

    def test_closes_gaps_where_surfaces_are_too_dark(self):
        counts = []
        for size in (-1, 0, 1000000):
            path = self.folder / "gaps.vtp"
            self.done("scan", ROOM, *POSE, "--range-noise", 0.005, "--maximum-error", 0.02,
                      "--maximum-gap-size", size, "--maximum-speckle-size", 4,
                      "--drop-speckles", "--map", path)
            local_map = read(vtkXMLPolyDataReader(), path)
            counts.append(local_map.GetNumberOfPolys())
            self.assertEqual(local_map.GetFieldData().HasArray("NumberOfClosedGaps"), size > 0)
            self.assertTrue(local_map.GetFieldData().HasArray("NumberOfSpeckles"))
        self.assertEqual(counts[0], counts[1])

    def test_without_a_maximum_error_every_return_is_a_corner(self):
        scan_path, map_path = self.folder / "all.vtp", self.folder / "all_map.vtp"
        self.done("scan", ROOM, *POSE, *COARSE, "--maximum-error", 0, "-o", scan_path,
                  "--map", map_path)
        np.testing.assert_array_equal(points(read(vtkXMLPolyDataReader(), map_path)),
                                      points(read(vtkXMLPolyDataReader(), scan_path)))

    def test_surface_attributes_label_the_points(self):
        plain_path, path = self.folder / "plain.vtp", self.folder / "labelled.vtp"
        self.done("scan", ROOM, *POSE, *COARSE, "-o", plain_path)
        self.done("scan", ROOM, *POSE, *COARSE, "-o", path, "--surface-attributes")
        plain, labelled = (read(vtkXMLPolyDataReader(), name) for name in (plain_path, path))
        self.assertFalse(plain.GetPointData().HasArray("ShapeId"))
        for i in range(plain.GetPointData().GetNumberOfArrays()):
            name = plain.GetPointData().GetArrayName(i)
            np.testing.assert_array_equal(array(labelled, name), array(plain, name))
        scene = room()
        cells = array(labelled, "CellId")
        for name in ("ShapeId", "Color"):
            np.testing.assert_array_equal(
                array(labelled, name), vtk_to_numpy(scene.GetCellData().GetArray(name))[cells])
        names = labelled.GetFieldData().GetAbstractArray("ShapeNames")
        self.assertIn("Table", {names.GetValue(i) for i in array(labelled, "ShapeId")})
        towards = POSITION - points(labelled)
        towards /= np.linalg.norm(towards, axis=1)[:, None]
        cosine = np.einsum("ij,ij->i", towards, array(labelled, "Normals"))
        self.assertGreater(cosine.min(), 0)
        np.testing.assert_allclose(np.cos(np.radians(array(labelled, "Incidence"))), cosine,
                                   atol=1e-6)

    def test_the_summary_counts_triangles(self):
        """Three of four beams meet the first triangle, and all the second one."""
        scene = self.folder / "triangle.obj"
        grid = [word for axis in ("alpha", "beta")
                for word in (f"--{axis}-range", -20, 20, f"--{axis}-resolution", 2)]
        for size, words in ((1, "1 triangle"), (9, "2 triangles")):
            scene.write_text(f"v 2 {-1.2 * size} -1\nv 2 1 -1\nv 2 1 {1.2 * size}\nf 1 2 3\n")
            printed = self.done("scan", scene, "--position", 0, 0, 0, *grid, "--maximum-error", 0,
                                "--map", self.folder / "triangle.vtp")
            self.assertIn(f"map      {words}\n", printed)

    def test_the_largest_numbers_that_are_taken(self):
        self.done("scan", ROOM, *POSE, *COARSE, "--threads", 1024, "--maximum-range", "1e18",
                  "-o", self.folder / "largest.vtp")

    def test_numbers_below_zero_in_any_notation(self):
        self.done("scan", ROOM, "--position", "-1e-1", "-.5", "+1", *COARSE,
                  "-o", self.folder / "negative.vtp")
        scan = read(vtkXMLPolyDataReader(), self.folder / "negative.vtp")
        np.testing.assert_array_equal(field(scan, "SensorToWorld")[3:12:4], (-0.1, -0.5, 1))


if __name__ == "__main__":
    unittest.main()
