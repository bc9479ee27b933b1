#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of ranges: the arguments of lms3d.scan, the options of lms3d scan, and the class itself."""

import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import lms3d
from command_line import (
    COARSE,
    POSE,
    POSITION,
    ROOM,
    CommandLineTest,
    array,
    points,
    read,
    room,
    run,
    write,
)

NOISE = 0.005
ERRORS = ("--range-bias", 0.01, "--range-noise", NOISE, "--range-resolution", 0.001, "--seed", 7)
ARGUMENTS = {"range_bias": 0.01, "range_noise": NOISE, "range_resolution": 0.001, "seed": 7}
GRID = {"alpha_range": (-60, 60), "alpha_resolution": 31, "beta_resolution": 24}


def two_poses():
    """A trajectory that stands still."""
    coordinates = vtkPoints()
    coordinates.SetDataTypeToDouble()
    for _ in range(2):
        coordinates.InsertNextPoint(POSITION)
    poses = vtkPolyData()
    poses.SetPoints(coordinates)
    return poses


class TestArguments(unittest.TestCase):
    """lms3d.scan adds errors."""

    @classmethod
    def setUpClass(cls):
        cls.room = room()
        cls.ideal = lms3d.scan(cls.room, POSITION)

    def scan(self, **errors):
        return lms3d.scan(self.room, POSITION, **errors)

    def test_a_bias_moves_every_point_along_its_beam(self):
        scan = self.scan(range_bias=0.25)
        np.testing.assert_array_equal(scan.ranges, self.ideal.ranges + 0.25)
        beams = (self.ideal.points - POSITION) / self.ideal.ranges.ravel()[scan.beams, None]
        np.testing.assert_allclose(scan.points, self.ideal.points + 0.25 * beams, atol=1e-13)

    def test_noise_has_its_standard_deviation(self):
        errors = self.scan(range_noise=NOISE, seed=1).ranges - self.ideal.ranges
        bound = 4 / np.sqrt(errors.size)
        self.assertLess(abs(errors.mean()), bound * NOISE)
        self.assertLess(abs(errors.var() / NOISE**2 - 1), np.sqrt(2) * bound)

    def test_the_seed_chooses_the_noise(self):
        one, other = (self.scan(range_noise=NOISE, seed=seed).ranges for seed in (1, -1))
        self.assertFalse((one == other).any())
        np.testing.assert_array_equal(one, self.scan(range_noise=NOISE, seed=1, threads=3).ranges)

    def test_the_resolution_comes_last(self):
        ranges = self.scan(**ARGUMENTS).ranges
        exact = self.scan(**{**ARGUMENTS, "range_resolution": 0}).ranges
        np.testing.assert_array_equal(ranges, np.round(exact * 1000) / 1000)

    def test_a_range_of_zero_is_no_return(self):
        scan = self.scan(range_bias=-2.0)
        np.testing.assert_array_equal(np.isnan(scan.ranges), self.ideal.ranges <= 2)
        self.assertEqual(len(scan.points), np.isfinite(scan.ranges).sum())

    def test_the_map_takes_the_ranges(self):
        local_map = lms3d.reconstruct(self.scan(range_noise=NOISE), maximum_error=0.03)
        self.assertGreater(len(local_map.triangles), 500)

    def test_invalid_arguments(self):
        for errors, words in (({"range_bias": np.inf}, "range_bias must be finite"),
                              ({"range_noise": -1}, "range_noise must be 0 or more"),
                              ({"range_noise": np.nan}, "range_noise must be 0 or more"),
                              ({"range_resolution": "x"}, "range_resolution must be a number"),
                              ({"seed": 0.5}, "seed must be a whole number"),
                              ({"seed": 2**31}, "seed must be a whole number")):
            with self.subTest(errors), self.assertRaisesRegex(ValueError, words):
                self.scan(**errors)


class TestFilter(unittest.TestCase):
    """vtkLMS3DRangeErrorFilter in a pipeline of Python."""

    def test_it_stands_between_scan_and_map(self):
        scan = lms3d.vtkLMS3DScanFilter()
        scan.SetInputDataObject(room())
        scan.SetPosition(POSITION)
        errors = lms3d.vtkLMS3DRangeErrorFilter()
        errors.SetInputConnection(scan.GetOutputPort())
        local_map = lms3d.vtkLMS3DSurfaceReconstructionFilter()
        local_map.SetInputConnection(errors.GetOutputPort())
        local_map.Update()
        without = local_map.GetOutput().GetNumberOfPolys()
        errors.SetRangeNoise(0.002)
        local_map.Update()
        self.assertNotEqual(local_map.GetOutput().GetNumberOfPolys(), without)
        self.assertFalse((array(errors.GetOutput(), "Range")
                          == array(scan.GetOutput(), "Range")).any())
        np.testing.assert_array_equal(
            array(errors.GetRangeImage(), "Range")[array(errors.GetOutput(), "BeamId")],
            array(errors.GetOutput(), "Range"))
        self.assertIn("RangeNoise: 0.002", str(errors))


class TestOptions(CommandLineTest):
    """lms3d scan adds errors before anything is written."""

    def test_all_results_have_the_ranges(self):
        names = {"-o": "scan.vtp", "--range-image": "image.vti", "--map": "map.vtp"}
        files = [word for option, name in names.items() for word in (option, self.folder / name)]
        words = self.done("scan", ROOM, *POSE, *COARSE, *ERRORS, "--maximum-error", 0, *files)
        scan = read(vtkXMLPolyDataReader(), self.folder / "scan.vtp")
        image = read(vtkXMLImageDataReader(), self.folder / "image.vti")
        local_map = read(vtkXMLPolyDataReader(), self.folder / "map.vtp")
        expected = lms3d.scan(room(), POSITION, **GRID, **ARGUMENTS)
        np.testing.assert_array_equal(points(scan), expected.points)
        np.testing.assert_array_equal(array(image, "Range"), expected.ranges.ravel())
        np.testing.assert_array_equal(array(local_map, "Range"), array(scan, "Range"))
        self.assertIn(f"ranges {np.nanmin(expected.ranges):.3f} to", words)

    def test_without_errors_nothing_changes(self):
        plain = self.coarse_ranges("plain", ROOM, *POSE)
        same = self.coarse_ranges("same", ROOM, *POSE, "--range-noise", 0, "--seed", 3)
        np.testing.assert_array_equal(plain, same)

    def test_each_scan_of_a_trajectory_has_its_own_noise(self):
        poses = self.folder / "poses.vtp"
        write(vtkXMLPolyDataWriter(), two_poses(), poses)
        self.done("scan", ROOM, "--trajectory", poses, *COARSE, *ERRORS,
                  "-o", self.folder / "scans.pvd", "--map", self.folder / "maps.pvd")
        first, second = (array(read(vtkXMLPolyDataReader(), self.folder / f"scans_000{i}.vtp"),
                               "Range") for i in (0, 1))
        self.assertEqual(first.shape, second.shape)
        self.assertGreater((first != second).mean(), 0.8)

    def test_a_scan_that_loses_all_returns(self):
        words = self.refused(1, "scan", ROOM, *POSE, *COARSE, "--range-bias", -100,
                             "-o", self.folder / "scan.vtp")
        self.assertIn("choose a larger bias", words)

    def test_invalid_options(self):
        for option, value in (("--range-noise", -1), ("--range-noise", "nan"),
                              ("--range-resolution", -0.01), ("--range-bias", "inf"),
                              ("--seed", 0.5), ("--seed", 2**31), ("--seed", -2**31 - 1)):
            with self.subTest(option, value=value):
                self.assertIn(option, self.refused(2, "scan", ROOM, *POSE, option, value,
                                                   "-o", self.folder / "scan.vtp"))

    def test_the_help_has_units(self):
        words = " ".join(run("scan", "--help").stdout.split())
        for option in ("--range-bias M", "--range-noise M", "--range-resolution M"):
            self.assertRegex(words, f"{option} metres;")


if __name__ == "__main__":
    unittest.main()
