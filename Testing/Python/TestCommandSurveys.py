#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The formats of surveyors: LAS and LAZ, read by laspy, and E57, read by pye57."""

import tempfile
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPolyData

from command_line import COARSE_BEAMS, COARSE_TURNS, CommandLineTest, points
from optional_libraries import needs
from scan_pieces import ScanWithMisses

# What a step of 0.1 mm leaves.
STEP = 0.5e-4 + 1e-9


class TestSurveys(ScanWithMisses, CommandLineTest):
    """A scan from a turned sensor with beams that do not return."""

    @needs("laspy", "lazrs")
    def test_las_and_laz(self):
        import laspy

        for ending in ("las", "laz"):
            with self.subTest(ending):
                cloud = laspy.read(self.written(ending))
                self.assertEqual(str(cloud.header.version), "1.4")
                np.testing.assert_allclose(cloud.xyz, points(self.scan), rtol=0, atol=STEP)
                np.testing.assert_array_equal(cloud["BeamId"], self.ids)
                self.assertNotIn("gps_time", cloud.point_format.dimension_names)
                self.assertTrue(cloud.header.generating_software.startswith("LMS3D "))
                np.testing.assert_allclose(cloud.header.mins, cloud.xyz.min(axis=0), atol=1e-6)

    @needs("laspy", "lazrs")
    def test_laz_is_smaller(self):
        sizes = [self.written(ending).stat().st_size for ending in ("laz", "las")]
        self.assertLess(sizes[0], 0.8 * sizes[1])

    @needs("laspy")
    def test_las_has_the_times_of_the_beams(self):
        import laspy

        time = np.linspace(0, 9.6, len(self.ids))
        scan = vtkPolyData()
        scan.DeepCopy(self.scan)
        self._add(scan, "Time", time)
        cloud = self._las(scan)
        np.testing.assert_array_equal(cloud.gps_time, time)
        np.testing.assert_array_equal(cloud["BeamId"], self.ids)
        self.assertIsInstance(cloud, laspy.LasData)

    @needs("laspy")
    def test_las_far_away(self):
        """The steps grow if the cloud is too large for 0.1 mm, and offsets keep them small."""
        for factor, shift, step in ((1, 1e7, 1e-4), (1e6, 0, 1e-2)):
            with self.subTest(factor=factor, shift=shift):
                scan = vtkPolyData()
                scan.DeepCopy(self.scan)
                moved = points(self.scan) * factor + shift
                scan.GetPoints().SetData(numpy_to_vtk(moved, deep=True))
                np.testing.assert_allclose(self._las(scan).xyz, moved, rtol=0, atol=0.51 * step)

    @staticmethod
    def _add(scan, name, values):
        column = numpy_to_vtk(values, deep=True)
        column.SetName(name)
        scan.GetPointData().AddArray(column)

    @staticmethod
    def _las(scan):
        import laspy
        from lms3d.results import save

        with tempfile.TemporaryDirectory() as folder:
            save(scan, Path(folder) / "scan.las")
            return laspy.read(Path(folder) / "scan.las")

    @needs("pye57")
    def test_e57(self):
        import pye57

        with pye57.E57(str(self.written("e57"))) as file:
            self.assertEqual(file.scan_count, 1)
            header, local = file.get_header(0), file.read_scan_raw(0)
            world = file.read_scan(0, ignore_missing_fields=True)
            self.assertEqual([node["rowMaximum"].value() for node in [header["indexBounds"]]],
                             [COARSE_BEAMS - 1])
            self.assertEqual(header["indexBounds"]["columnMaximum"].value(), COARSE_TURNS - 1)
            np.testing.assert_array_equal(header.translation, self.position)
            np.testing.assert_allclose(self.rotate(header.rotation), self.rotation, atol=1e-14)
            bounds = header["cartesianBounds"]
            self.assertEqual(bounds["zMaximum"].value(), local["cartesianZ"].max())
        np.testing.assert_array_equal(
            local["columnIndex"].astype(int) * COARSE_BEAMS + local["rowIndex"], self.ids)
        local = np.stack([local[f"cartesian{axis}"] for axis in "XYZ"], axis=1)
        np.testing.assert_allclose(np.linalg.norm(local, axis=1), self.ranges[self.ids], rtol=1e-13)
        world = np.stack([world[f"cartesian{axis}"] for axis in "XYZ"], axis=1)
        np.testing.assert_allclose(world, points(self.scan), atol=1e-13)


if __name__ == "__main__":
    unittest.main()
