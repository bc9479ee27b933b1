#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d scan --fused: one map of all poses of a trajectory, its formats, and what is refused."""

import subprocess
import sys
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance, vtkMassProperties
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from command_line import COARSE, ROOM, field, points, read
from journeys import PLACES, TrajectoryTest

NOISE = 0.005


def area(surface):
    """Square metres."""
    properties = vtkMassProperties()
    properties.SetInputData(surface)
    return properties.GetSurfaceArea()


class TestFused(TrajectoryTest):
    """The room from three poses."""

    def fused(self, *arguments, name="fused.vtp", reader=vtkXMLPolyDataReader):
        """The map that a command writes, and the command's words."""
        words = self.done("scan", ROOM, "--trajectory", self.path(), *COARSE,
                          "--fused", self.folder / name, *arguments)
        return read(reader(), self.folder / name), words

    def assert_near(self, surface, bound):
        """Every return of scans.pvd lies within a bound of the surface, in metres."""
        distance = vtkImplicitPolyDataDistance()
        distance.SetInput(surface)
        for scan in self.steps("scans.pvd")[1]:
            offsets = np.abs([distance.EvaluateFunction(place) for place in points(scan)])
            self.assertGreater(len(offsets), 100)
            self.assertLessEqual(offsets.max(), bound)

    def test_every_return_of_every_pose_is_near_the_map(self):
        surface, words = self.fused("-o", self.folder / "scans.pvd", "--map",
                                    self.folder / "maps.pvd")
        self.assertIn(f"fused    {surface.GetNumberOfCells():,} triangles from 3 scans\n", words)
        self.assertTrue(words.endswith(f"wrote    {self.folder / 'fused.vtp'}\n"))
        self.assert_near(surface, 0.01)
        _, maps = self.steps("maps.pvd")
        self.assertGreater(area(surface), max(area(each) for each in maps))
        self.assertLess(surface.GetNumberOfCells(), sum(each.GetNumberOfCells() for each in maps) / 2)

    def test_its_arrays(self):
        surface, _ = self.fused()
        self.assertEqual(field(surface, "NumberOfScans"), [3])
        np.testing.assert_allclose(field(surface, "SensorPositions").reshape(-1, 3), PLACES)
        best = vtk_to_numpy(surface.GetCellData().GetArray("BestScan"))
        self.assertEqual(set(best), {0, 1, 2})

    def test_the_bound_and_the_errors_of_a_device(self):
        surface, _ = self.fused("-o", self.folder / "scans.pvd", "--range-noise", NOISE,
                                "--maximum-error", 0.04)
        self.assert_near(surface, 0.04)
        fine, _ = self.fused("--range-noise", NOISE, name="fine.vtp")
        self.assertGreater(fine.GetNumberOfCells(), surface.GetNumberOfCells())

    def test_a_device_that_loses_beams_says_which(self):
        """Otherwise the map would open where a beam was lost."""
        ideal, _ = self.fused()
        for options in ((), ("--range-at-ten-percent", 3), ("--minimum-range", 1.2),
                        ("--range-resolution", 0.01)):
            with self.subTest(options):
                surface, _ = self.fused("-o", self.folder / "scans.pvd", *options)
                self.assertLess(surface.GetNumberOfCells(), 1.5 * ideal.GetNumberOfCells())
                for scan in self.steps("scans.pvd")[1]:
                    self.assertEqual(scan.GetFieldData().HasArray("Status"), bool(options))

    def test_options_of_the_fusion(self):
        surface, _ = self.fused()
        for options in (("--drop-returns",), ("--forget-seen-through",), ("--threads", 1)):
            with self.subTest(options):
                other, _ = self.fused(*options, name="other.vtp")
                self.assertEqual(field(other, "NumberOfScans"), [3])
                if options[0] == "--threads":
                    np.testing.assert_array_equal(points(other), points(surface))

    def test_formats(self):
        surface, _ = self.fused()
        for name, reader in (("fused.ply", vtkPLYReader), ("fused.stl", vtkSTLReader)):
            with self.subTest(name):
                other, _ = self.fused(name=name, reader=reader)
                self.assertEqual(other.GetNumberOfCells(), surface.GetNumberOfCells())
                np.testing.assert_allclose(other.GetBounds(), surface.GetBounds(), atol=1e-5)

    def test_the_standard_output(self):
        surface, _ = self.fused()
        arguments = ("scan", ROOM, "--trajectory", self.path(), *COARSE, "--fused", "-")
        result = subprocess.run([sys.executable, "-m", "lms3d", *map(str, arguments)],
                                capture_output=True, timeout=300, check=True)
        self.assertTrue(result.stdout.startswith(b"ply\n"))
        self.assertIn(b"element face %d\n" % surface.GetNumberOfCells(), result.stdout)
        self.assertIn(b"fused    ", result.stderr)

    def test_a_pose_without_returns_adds_nothing(self):
        """Only the last pose looks down, where the floor is near."""
        path = self.path(Orientation=[(1, 0, 0, 0)] * 2 + [(0.5**0.5, 0, 0.5**0.5, 0)])
        result = self.run_from(path, "--alpha-range", -5, 5, "--alpha-resolution", 11,
                               "--beta-range", -5, 5, "--beta-resolution", 11,
                               "--maximum-range", 1.1)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("no beam returned from 2 of the poses", result.stderr)
        self.assertIn("triangles from 3 scans", result.stdout)

    def run_from(self, path, *arguments):
        """The process of a command that writes a fused map."""
        return subprocess.run(
            [sys.executable, "-m", "lms3d", "scan", str(ROOM), "--trajectory", str(path),
             "--fused", str(self.folder / "fused.vtp"), *map(str, arguments)],
            capture_output=True, text=True, timeout=300, check=False)

    def test_what_is_refused_leaves_no_files(self):
        path = self.path()
        out = self.folder / "fused.vtp"
        cases = {
            "--fused: one map is made of the maps of many poses": (2, "--position", 0, 0, 1,
                                                                   "--fused", out),
            "--drop-returns: one map": (2, "--position", 0, 0, 1, "--map", out, "--drop-returns"),
            "--forget-seen-through: only for the map that --fused writes": (
                2, "--trajectory", path, "-o", self.folder / "scans.pvd", "--forget-seen-through"),
            "--maximum-error 0: the fused map needs a bound above 0": (
                2, "--trajectory", path, "--fused", out, "--maximum-error", 0),
            "cannot write the fused map to": (2, "--trajectory", path,
                                              "--fused", self.folder / "fused.pvd"),
            "is both trajectory and fused map": (2, "--trajectory", path, "--fused", path),
            "would be replaced by a step": (2, "--trajectory", path, "-o", self.folder / "s.pvd",
                                            "--fused", self.folder / "s_0001.vtp"),
            "there is no folder": (1, "--trajectory", path, "--fused", "/nowhere/fused.vtp"),
            "no beam returned from any pose": (1, "--trajectory", path, "--fused", out,
                                               "--maximum-range", 0.01),
        }
        for words, (code, *arguments) in cases.items():
            with self.subTest(words):
                self.assertIn(words, self.refused(code, "scan", ROOM, *COARSE, *arguments))


if __name__ == "__main__":
    unittest.main()
