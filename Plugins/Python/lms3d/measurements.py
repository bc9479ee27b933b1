# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The measurements of a scan as numpy arrays."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData


@dataclass(frozen=True, eq=False, repr=False)
class Scan:
    """What a scan measured: lengths in metres, angles in degrees, times in seconds.

    points: N x 3, where the beams hit the mesh, in its coordinates, ordered by turn, then by beam.
    ranges: turns x beams, the distances from the sensor, NaN for beams without a return.
    cells: N, the number of the triangle that was hit, for each point. (For a vtkPolyData it is the
        array CellId of vtkLMS3DScanFilter.)
    beams: N, the beam of each point: `ranges.ravel()[beams]` are the ranges of the points.
    alpha: the elevation of each column of ranges. beta: the platform angle of each row.
    poly: the scan as vtkPolyData, for VTK's filters.

    The others are None unless `scan` was asked for them:

    incidence: N, the angle between beam and normal, 0 to 90.
    intensity: N, reflectance times the cosine of the incidence.
    times: N, when the beam of each point left.
    status: turns x beams, why a beam gave a return or none: the numbers of
        vtkLMS3DScanFilter.BeamStatus (0 return, 1 nothing met, 2 beyond the range, 3 too weak,
        4 too near).
    positions, orientations: N x 3 and N x 4, the sensor's pose when the beam left; orientations
        are quaternions w x y z.
    """

    points: np.ndarray
    ranges: np.ndarray
    cells: np.ndarray
    beams: np.ndarray
    alpha: np.ndarray
    beta: np.ndarray
    poly: vtkPolyData
    incidence: Optional[np.ndarray] = None
    intensity: Optional[np.ndarray] = None
    times: Optional[np.ndarray] = None
    status: Optional[np.ndarray] = None
    positions: Optional[np.ndarray] = None
    orientations: Optional[np.ndarray] = None

    def __repr__(self):
        turns, beams = self.ranges.shape
        return f"<lms3d.Scan: {turns} x {beams} beams, {len(self.points)} returns>"


def read_scan(algorithm):
    """The Scan of the filter's two outputs."""
    poly, image = algorithm.GetOutput(), algorithm.GetOutputDataObject(1)
    alpha, beta = get_field(poly, "AlphaAngles"), get_field(poly, "BetaAngles")
    shape = (len(beta), len(alpha))
    status = get_field(poly, "Status")
    return Scan(
        vtk_to_numpy(poly.GetPoints().GetData()),
        vtk_to_numpy(image.GetPointData().GetArray("Range")).reshape(shape),
        get_array(poly, "CellId"), get_array(poly, "BeamId"), alpha, beta, poly,
        get_array(poly, "Incidence"), get_array(poly, "Intensity"), get_array(poly, "Time"),
        None if status is None else status.reshape(shape),
        get_array(poly, "SensorPosition"), get_array(poly, "SensorOrientation"))


def get_array(poly, name):
    """An array of the points, or None."""
    return _to_numpy(poly.GetPointData().GetArray(name))


def get_field(poly, name):
    """An array of the field data, or None."""
    return _to_numpy(poly.GetFieldData().GetArray(name))


def _to_numpy(array):
    return None if array is None else vtk_to_numpy(array)
