# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Places a camera so that it shows a whole scene, and names the directions in its picture."""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkBoundingBox

_VIEW_ANGLE = 25.0  # degrees, vertical
_MARGIN = 1.05
_ELEVATION = 38.0  # degrees above the horizon
_AZIMUTH = -118.0  # degrees about z, from x
_OFFSET = 25.0  # degrees about z, from a sensor outside the scene

_EYE_LEVEL = 0.01  # the sine of the elevation above which a camera looks down


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
    camera.SetViewAngle(_VIEW_ANGLE)
    focus, distance = _fit(points, (right, np.cross(direction, right), direction), _VIEW_ANGLE,
                           aspect)
    camera.SetFocalPoint(focus)
    camera.SetPosition(focus + distance * direction)
    camera.SetViewUp(0, 0, 1)


def reframe(camera, points, old_aspect, aspect):
    """Move the camera after its picture got another aspect.

    The camera keeps its direction, and the user's zoom relative to the whole scene. If its view is
    centred on the points and holds them all, they stay in it. If all points coincide, the camera
    stays.
    """
    if not np.ptp(points, axis=0).any():
        return
    axes = _axes(camera)
    old_focus, old_distance = _fit(points, axes, camera.GetViewAngle(), old_aspect)
    new_focus, new_distance = _fit(points, axes, camera.GetViewAngle(), aspect)
    focus = camera.GetFocalPoint() + new_focus - old_focus
    camera.SetPosition(focus + camera.GetDistance() * new_distance / old_distance * axes[2])
    camera.SetFocalPoint(focus)


def level_axes(camera):
    """The horizontal directions that lead right and up in the camera's picture, unit vectors.

    At eye level no horizontal direction leads up. Up is then the direction away from the camera.
    """
    right, up, _ = _axes(camera)
    if np.hypot(*right[:2]) >= np.hypot(*up[:2]):
        right = _level(right)
        away = np.cross((0, 0, 1), right)
        return right, away if away @ up >= -_EYE_LEVEL else -away
    up = _level(up)
    side = np.cross(up, (0, 0, 1))
    return side if side @ right >= 0 else -side, up


def _axes(camera):
    """The camera's axes in the world: right, up, and towards the camera."""
    matrix = camera.GetViewTransformMatrix()
    return np.array([[matrix.GetElement(i, j) for j in range(3)] for i in range(3)])


def _level(vector):
    flat = np.array((vector[0], vector[1], 0.0))
    return flat / np.linalg.norm(flat)


def _fit(points, axes, view_angle, aspect):
    """The focal point and the distance of the nearest camera that has all points in its view."""
    right, up, direction = axes
    height = points @ direction
    slope = np.tan(np.radians(view_angle / 2)) / _MARGIN
    across, distance_across = _fit_axis(points @ right, height, slope * aspect)
    upward, distance_upward = _fit_axis(points @ up, height, slope)
    depth = height.mean()
    return (across * right + upward * up + depth * direction,
            max(distance_across, distance_upward) - depth)


def _fit_axis(offset, height, slope):
    """The camera's position along an axis of the picture, and its height, to show every point.

    A point is visible if abs(offset - position) <= slope * (camera height - height).
    """
    high = (offset + slope * height).max()
    low = (offset - slope * height).min()
    return (high + low) / 2, (high - low) / (2 * slope)
