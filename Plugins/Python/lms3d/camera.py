# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The camera of figures: from a side that the sensor sees, as near as possible."""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkBoundingBox

_VIEW_ANGLE = 25.0  # degrees, vertical
_MARGIN = 1.05
_ELEVATION = 38.0  # degrees above the horizon
_AZIMUTH = -118.0  # degrees about z, from x
_OFFSET = 25.0  # degrees about z, from a sensor outside the scene


def get_direction(bounds, sensor):
    """Unit vector from the scene to the camera.

    If the sensor is inside the scene, a fixed direction from above. If it is outside, it sees only
    one side of the scene, and the camera shows that side.
    """
    if vtkBoundingBox(bounds).ContainsPoint(sensor):
        azimuth, elevation = np.radians((_AZIMUTH, _ELEVATION))
    else:
        x, y, z = np.subtract(sensor, np.reshape(bounds, (3, 2)).mean(axis=1))
        azimuth = np.arctan2(y, x) + np.radians(_OFFSET)
        elevation = np.clip(np.arctan2(z, np.hypot(x, y)), *np.radians((10, 60)))
    flat = np.cos(elevation)
    return np.array((flat * np.cos(azimuth), flat * np.sin(azimuth), np.sin(elevation)))


def frame(camera, points, direction, aspect):
    """Place the camera in a direction, as near as possible so that all points are in the view."""
    right = np.cross((0, 0, 1), direction)
    right /= np.linalg.norm(right)
    up = np.cross(direction, right)
    slope = np.tan(np.radians(_VIEW_ANGLE / 2)) / _MARGIN

    height = points @ direction
    across, distance_across = _fit(points @ right, height, slope * aspect)
    upward, distance_upward = _fit(points @ up, height, slope)
    depth = height.mean()
    focus = across * right + upward * up + depth * direction

    camera.SetViewAngle(_VIEW_ANGLE)
    camera.SetFocalPoint(focus)
    camera.SetPosition(focus + (max(distance_across, distance_upward) - depth) * direction)
    camera.SetViewUp(0, 0, 1)


def _fit(offset, height, slope):
    """The camera's position along an axis of the picture, and its height, to show every point.

    A point is visible if abs(offset - position) <= slope * (camera height - height).
    """
    high = (offset + slope * height).max()
    low = (offset - slope * height).min()
    return (high + low) / 2, (high - low) / (2 * slope)
