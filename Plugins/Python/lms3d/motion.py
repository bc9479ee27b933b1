# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A sensor that moves: trajectories from arrays, and scans without the distortion of the motion."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

from .measurements import get_array, get_field

_MIRROR_RATE = 75.0  # turns a second

# F, S and A of each mounting (Filters/Device/lms3dPlatform.h) as rows in the sensor's axes, and
# whether the middle of the fan is on the axis, in the order of vtkLMS3DScanFilter.Mountings.
_X, _Y, _Z = np.eye(3)
_PLATFORMS = (
    ((_X, _Y, _Z), False),
    ((_X, _Y, _Z), True),
    ((_X, -_Z, _Y), False),
    ((_Y, _Z, _X), True),
)


class Platform:
    """How a scan's platform carried and turned the fan (Filters/Device/lms3dPlatform.h).

    axes: F, S and A at the platform angle 0, as rows in the sensor's axes. offset: of the mirror's
    centre at that angle, metres. turn_rate: degrees a second during a fan.
    """

    def __init__(self, poly):
        axes, self.is_fan_along_axis = _PLATFORMS[int(_get(poly, "Mounting", [0])[0])]
        self.axes = np.array(axes)
        self.offset = _get(poly, "AxisOffset", np.zeros(3))
        self.turn_rate = float(_get(poly, "TurnRate", [0.0])[0])

    def get_fan(self, angle):
        """The matrix from a fan at a platform angle to the sensor's axes, and the mirror's place.

        The columns are the directions of the elevations alpha 0 and 90 degrees, and their product.
        """
        sine, cosine = np.sin(np.radians(angle)), np.cos(np.radians(angle))
        turn = self.axes.T @ np.array(((cosine, sine, 0), (-sine, cosine, 0), (0, 0, 1)))
        first, second = turn[:, 0], turn[:, 2]
        if self.is_fan_along_axis:
            first, second = second, first
        matrix = np.stack((first, second, np.cross(first, second)), axis=1)
        return matrix, turn @ self.axes @ self.offset


def to_trajectory(trajectory):
    """The vtkPolyData of a trajectory: itself, or that of (times, positions[, orientations]).

    Raises ValueError if it is neither.
    """
    if isinstance(trajectory, vtkDataObject):
        return trajectory
    if not isinstance(trajectory, (tuple, list)) or len(trajectory) not in (2, 3):
        raise ValueError("trajectory must be a vtkPolyData, or a tuple (times, positions) or (times, "
                         f"positions, orientations) of arrays, not {type(trajectory).__name__}")
    times = _to_table("times of the trajectory", trajectory[0])
    path = vtkPolyData()
    positions = _to_table("positions of the trajectory", trajectory[1], len(times), 3)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(positions, deep=True))
    path.SetPoints(points)
    _add(path, "Time", times)
    if len(trajectory) == 3:
        _add(path, "Orientation",
             _to_table("orientations of the trajectory", trajectory[2], len(times), 4))
    return path


def undistort(scan):
    """The points of a Scan, N x 3, from ranges, angles and the pose of each beam.

    A sensor that moves or turns during a scan puts the points where a sensor at rest would have
    measured them (`scan.points`). This function puts them where the beams hit the mesh. The scan
    needs the poses of its beams (`lms3d.scan(..., poses=True)`), unless the sensor was at rest.
    Any mounting, offset of the mirror and turn rate is possible, and ranges may have errors.

    scan: a Scan, or the vtkPolyData of vtkLMS3DScanFilter or vtkLMS3DRangeErrorFilter.

    Raises ValueError if the scan lacks an array that this needs.
    """
    poly = getattr(scan, "poly", scan)
    alpha, beta = _need(poly, "AlphaAngles"), _need(poly, "BetaAngles")
    turns, beams = np.divmod(get_array(poly, "BeamId"), len(alpha))
    platform = Platform(poly)
    elevations = np.radians(90.0 - alpha if platform.is_fan_along_axis else alpha)[beams]
    angles = np.radians(beta[turns] + platform.turn_rate * _fan_times(alpha)[beams])
    # Beam and mirror in the frame of the turn, as components along F and A, and along F, S and A.
    axes = platform.axes
    offset = axes @ platform.offset
    ranges = get_array(poly, "Range").astype(np.float64)
    forward = ranges * np.cos(elevations) + offset[0]
    along = ranges * np.sin(elevations) + offset[2]
    sines, cosines = np.sin(angles), np.cos(angles)
    in_frame = np.stack((cosines * forward + sines * offset[1],
                         cosines * offset[1] - sines * forward, along), axis=1)
    return _to_world(poly, in_frame @ axes)


def _fan_times(alpha):
    """Seconds from the start of the fan to each of its beams (Filters/Device/lms3dFan.h)."""
    step = abs(alpha[-1] - alpha[0]) / max(1, len(alpha) - 1)
    turns = round(1 / step) if 0 < step <= 1 and abs(round(1 / step) * step - 1) <= 1e-6 else 1
    laps, places = np.arange(len(alpha)) % turns, np.arange(len(alpha)) // turns
    return laps / _MIRROR_RATE + places * (turns * step) / (360 * _MIRROR_RATE)


def _to_world(poly, points):
    """Points of the sensor frame at the poses of their beams."""
    positions = get_array(poly, "SensorPosition")
    quaternions = get_array(poly, "SensorOrientation")
    if positions is not None and quaternions is not None:
        return positions + _rotate(quaternions, points)
    if get_field(poly, "TurnToWorld") is not None:
        raise ValueError("the scan is of a sensor that moves, and does not have the pose of each "
                         "beam: scan with poses=True (ComputePoses)")
    pose = _need(poly, "SensorToWorld").reshape(4, 4)
    return points @ pose[:3, :3].T + pose[:3, 3]


def _rotate(quaternions, vectors):
    """Vectors, each turned by a quaternion w x y z of any length."""
    unit = quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)
    scalars, axes = unit[:, :1], unit[:, 1:]
    doubled = 2 * np.cross(axes, vectors)
    return vectors + scalars * doubled + np.cross(axes, doubled)


def _get(poly, name, default):
    values = get_field(poly, name)
    return np.asarray(default) if values is None else values.ravel()


def _need(poly, name):
    values = get_field(poly, name)
    if values is None:
        raise ValueError(f"the scan does not have the field data {name}")
    return values.ravel()


def _add(path, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    path.GetPointData().AddArray(array)


def _to_table(name, values, count=None, width=None):
    """Numbers in double precision: one column, or `count` rows of `width`."""
    try:
        table = np.ascontiguousarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        table = np.empty(0)
    is_right = (table.ndim == 1 and len(table) > 0 if width is None
                else table.shape == (count, width))
    if not is_right:
        shape = "a row of N numbers" if width is None else f"{count} x {width} numbers"
        raise ValueError(f"the {name} must be {shape}, not {table.shape}")
    return table
