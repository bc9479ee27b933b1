# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A scan whose files several tests read: a turned sensor, and beams that do not return."""

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from command_line import COARSE, COARSE_BEAMS, COARSE_TURNS, POSE, ROOM, array, field, points, read

TURNED = (ROOM, *POSE, "--orientation", 10, -20, 30, "--maximum-range", 2.5)


class ScanWithMisses:
    """Scans for a class of tests. `points` and `ranges` are of all beams, NaN without a return.

    `rotation` and `position` are the pose: the sensor's axes (columns), and where the sensor is.
    """

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        scan = read(vtkXMLPolyDataReader(), cls().written("vtp"))
        cls.scan = scan
        pose = field(scan, "SensorToWorld").reshape(4, 4)
        cls.rotation, cls.position = pose[:3, :3], pose[:3, 3]
        cls.ids = array(scan, "BeamId")
        cls.points = cls.on_grid(points(scan))
        cls.ranges = cls.on_grid(array(scan, "Range"))
        assert np.isnan(cls.ranges).any() and len(cls.ids) > 100

    @classmethod
    def on_grid(cls, values):
        """Values of the returns for all beams."""
        grid = np.full((COARSE_BEAMS * COARSE_TURNS, *values.shape[1:]), np.nan)
        grid[cls.ids] = values
        return grid

    def written(self, ending):
        """The path of the scan in a format."""
        path = self.folder / f"scan.{ending}"
        if not path.exists():
            self.done("scan", *TURNED, *COARSE, "-o", path)
        return path

    @staticmethod
    def rotate(quaternion):
        """The matrix of a quaternion w, x, y, z."""
        w, *axis = quaternion
        x, y, z = axis
        cross = np.array(((0, -z, y), (z, 0, -x), (-y, x, 0)))
        return np.identity(3) + 2 * w * cross + 2 * cross @ cross
