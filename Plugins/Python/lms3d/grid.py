# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A scan as the grid of its beams, for formats that keep the order of the beams or the pose."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkMath

from .motion import Platform


class Grid:
    """All beams of a scan, turn by turn, with and without a return.

    alpha, beta: the angles of the beams of a turn, and of the turns, degrees.
    rotation, position: the pose: the sensor's axes (columns), and where the sensor is.
    platform: how the platform carries and turns the fan.
    ids: the beam of each return, increasing.
    """

    def __init__(self, scan):
        self.alpha = _field(scan, "AlphaAngles")
        self.beta = _field(scan, "BetaAngles")
        pose = _field(scan, "SensorToWorld").reshape(4, 4)
        self.rotation, self.position = pose[:3, :3], pose[:3, 3]
        self.platform = Platform(scan)
        points = scan.GetPoints()
        self._points = vtk_to_numpy(points.GetData()) if points else np.empty((0, 3))
        self.ids = _array(scan, "BeamId", np.int32)
        self._ranges = _array(scan, "Range", np.float64)

    @property
    def beams(self):
        """Number of all beams."""
        return len(self.alpha) * len(self.beta)

    @property
    def returns(self):
        """Number of beams with a return."""
        return len(self.ids)

    @property
    def quaternion(self):
        """The rotation from the sensor's frame to the world as w, x, y, z."""
        return quaternion(self.rotation)

    def local_points(self, rows):
        """Points of a slice of the returns in the sensor's frame."""
        return (self._points[rows] - self.position) @ self.rotation

    def points_of_beams(self, beams, missing, local):
        """A point for each beam of a slice of all beams; `missing` without a return."""
        rows, places = self._returns_of(beams)
        found = np.full((beams.stop - beams.start, 3), missing)
        found[places] = self.local_points(rows) if local else self._points[rows]
        return found

    def ranges_of_beams(self, beams, missing):
        """A range for each beam of a slice of all beams; `missing` without a return."""
        rows, places = self._returns_of(beams)
        found = np.full(beams.stop - beams.start, missing)
        found[places] = self._ranges[rows]
        return found

    def _returns_of(self, beams):
        """The returns of a slice of all beams, and their places within this slice."""
        rows = slice(*np.searchsorted(self.ids, (beams.start, beams.stop)))
        return rows, self.ids[rows] - beams.start


def quaternion(rotation):
    """The quaternion w, x, y, z of a rotation matrix."""
    result = [0.0] * 4
    vtkMath.Matrix3x3ToQuaternion(rotation.tolist(), result)
    return result


def _field(scan, name):
    return vtk_to_numpy(scan.GetFieldData().GetArray(name)).ravel()


def _array(scan, name, kind):
    """An array of the returns; a scan without returns may have none."""
    array = scan.GetPointData().GetArray(name)
    return vtk_to_numpy(array) if array else np.empty(0, kind)
