# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The poses of a sensor that moves while its platform turns steadily: one for each mirror turn."""

import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkMath
from vtkmodules.vtkFiltersSources import vtkPlaneSource

from .. import vtkLMS3DScanFilter
from ..execution import update
from ..motion import to_trajectory
from ..problems import Problem
from .variants import TURNS_PER_SECOND

_MAXIMUM_TIME = 3600.0  # seconds; an hour has 270,000 turns


def interpolate_poses(trajectory, orientation, times):
    """A trajectory (vtkPolyData) with the pose at the start of each mirror turn.

    trajectory: a vtkPolyData with the poses at a few `times`. orientation: the sensor's, for a
    trajectory without orientations. The interpolation is that of
    vtkLMS3DScanFilter.SetMotionDuringScan. A pose begins half a turn before its mirror turn, so no
    rounding of times changes the pose. Raises Problem if the trajectory takes too long.
    """
    span = times[-1] - times[0]
    if span > _MAXIMUM_TIME:
        raise Problem(f"the trajectory takes {span:g} s; with --turn RATE it may take "
                      f"{_MAXIMUM_TIME:g} s: shorten it, or leave out --turn")
    matrices = _measure(trajectory, orientation, times[0],
                        math.ceil(span * TURNS_PER_SECOND) + 1)
    starts = times[0] + (np.arange(len(matrices)) - 0.5) / TURNS_PER_SECOND
    return to_trajectory((starts, matrices[:, :3, 3], _to_quaternions(matrices[:, :3, :3])))


def _measure(trajectory, orientation, time, count):
    """The poses as matrices. A scan measures them: its fan has one beam, and takes one mirror turn."""
    plane = vtkPlaneSource()  # a scan needs a scene
    scan = vtkLMS3DScanFilter()
    scan.SetInputConnection(plane.GetOutputPort())
    scan.SetTrajectoryData(trajectory)
    scan.SetOrientation(orientation)
    scan.SetMotionDuringScan(True)
    scan.SetAlphaRange(0.0, 0.0)
    scan.SetAlphaResolution(1)
    scan.SetBetaResolution(count)
    update(scan, "interpolating poses", "cannot interpolate the trajectory", time=time)
    poses = scan.GetOutput().GetFieldData().GetArray("TurnToWorld")
    return vtk_to_numpy(poses).reshape(-1, 4, 4)


def _to_quaternions(rotations):
    """Quaternions w, x, y, z."""
    quaternions = np.empty((len(rotations), 4))
    found = [0.0] * 4
    for i, rotation in enumerate(rotations.tolist()):
        vtkMath.Matrix3x3ToQuaternion(rotation, found)
        quaternions[i] = found
    return quaternions
