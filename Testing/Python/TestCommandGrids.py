#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The formats of points that keep the grid: PCD and PTX.

pypcd4 reads the PCD. For PTX there is no independent reader: this file has one for the tests.
"""

import unittest
from itertools import islice

import numpy as np

from command_line import COARSE_BEAMS, COARSE_TURNS, CommandLineTest
from optional_libraries import needs
from scan_pieces import TURNED, ScanWithMisses


class TestGrids(ScanWithMisses, CommandLineTest):
    """A scan from a turned sensor with beams that do not return."""

    @needs("pypcd4")
    def test_pcd(self):
        import pypcd4

        cloud = pypcd4.PointCloud.from_path(self.written("pcd"))
        self.assertEqual(cloud.fields, ("x", "y", "z"))
        self.assertEqual((cloud.metadata.width, cloud.metadata.height),
                         (COARSE_BEAMS, COARSE_TURNS))
        self.assertEqual(cloud.metadata.data.value, "binary")
        np.testing.assert_array_equal(cloud.numpy(), self.points.astype(np.float32))
        np.testing.assert_array_equal(cloud.metadata.viewpoint[:3], self.position)
        np.testing.assert_allclose(self.rotate(cloud.metadata.viewpoint[3:]), self.rotation,
                                   atol=1e-14)

    def test_pcd_has_a_point_for_each_beam(self):
        header, _, binary = self.written("pcd").read_bytes().partition(b"DATA binary\n")
        self.assertIn(b"\nWIDTH %d\nHEIGHT %d\n" % (COARSE_BEAMS, COARSE_TURNS), header)
        np.testing.assert_array_equal(np.frombuffer(binary, "<f4").reshape(-1, 3),
                                      self.points.astype(np.float32))

    def test_ptx(self):
        with open(self.written("ptx"), encoding="ascii") as file:
            size = [int(next(file)) for _ in range(2)]
            pose, matrix = (np.loadtxt(islice(file, 4)) for _ in range(2))
            table = np.loadtxt(file)
        self.assertEqual(size, [COARSE_TURNS, COARSE_BEAMS])
        np.testing.assert_array_equal(pose[0], self.position)
        np.testing.assert_array_equal(pose[1:], self.rotation.T)
        local, intensity = table[:, :3], table[:, 3]
        is_missing = np.isnan(self.ranges)
        self.assertTrue((local[is_missing] == 0).all())
        self.assertTrue((intensity == 0.5).all())
        returned = local[~is_missing]
        np.testing.assert_allclose(np.linalg.norm(returned, axis=1), self.ranges[~is_missing],
                                   rtol=1e-8)
        world = np.column_stack((returned, np.ones(len(returned)))) @ matrix
        np.testing.assert_allclose(world[:, :3], self.points[~is_missing], atol=1e-7)
        np.testing.assert_array_equal(world[:, 3], 1)

    def test_the_grid_of_a_file_that_is_written_in_pieces(self):
        """A scan of more beams than are converted at once."""
        self.done("scan", *TURNED, "--alpha-resolution", 500, "--beta-resolution", 600,
                  "-o", self.folder / "long.pcd")
        binary = (self.folder / "long.pcd").read_bytes().partition(b"DATA binary\n")[2]
        points = np.frombuffer(binary, "<f4").reshape(600, 500, 3)
        lengths = np.linalg.norm(points - self.position, axis=2)
        # The elevation is the angle to the axis of the platform: the beam keeps its column.
        height = (points - self.position) @ self.rotation[:, 2] / lengths
        columns = np.broadcast_to(np.sin(np.radians(np.linspace(-90, 90, 500))), height.shape)
        is_return = np.isfinite(height)
        self.assertTrue(0.1 < is_return.mean() < 0.9)
        np.testing.assert_allclose(height[is_return], columns[is_return], atol=1e-5)


if __name__ == "__main__":
    unittest.main()
