# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Poses of a sensor: a position in metres, and an orientation in degrees, as in vtkProp3D."""

from vtkmodules.vtkCommonTransforms import vtkTransform

TURN_STEP = 15.0  # degrees


def turn(orientation, axis, degrees):
    """The orientation after a turn about one of the sensor's own axes: 0 is x, 1 is y, 2 is z."""
    transform = vtkTransform()
    transform.RotateZ(orientation[2])
    transform.RotateX(orientation[0])
    transform.RotateY(orientation[1])
    transform.RotateWXYZ(degrees, *(float(i == axis) for i in range(3)))
    return transform.GetOrientation()


def describe(pose):
    """The pose with centimetres, and with degrees if it is turned."""
    position, orientation = pose
    text = "  ".join(f"{round(x, 2) + 0.0:.2f}" for x in position) + " m"
    degrees = [round(x) for x in orientation]
    return text + ("  {} {} {} degrees".format(*degrees) if any(degrees) else "")
