# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The effects of chart F: what an LMS 200 does, one at a time and all together."""

import dataclasses

from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

POSITION = (0.3, -0.2, 1.0)
MAXIMUM_ERROR = 0.02
DEPTH_STEP = 0.1
DURATION = 10.0  # seconds; a scan takes 9.6


@dataclasses.dataclass(frozen=True, eq=False)
class Effect:
    """The properties of the scan filter and of the range error filter, and the speed, m/s."""

    name: str
    value: str
    sensor: dict = dataclasses.field(default_factory=dict)
    errors: dict = dataclasses.field(default_factory=dict)
    speed: float = 0.0


_NOISE = {"RangeNoise": 0.005}
_STEPS = {"RangeResolution": 0.001}
_BIAS = {"RangeBias": 0.015}
_WIDTH = {"BeamDiameter": 0.012, "BeamDivergence": 0.0044, "BeamSamples": 7}
_REFLECTANCE = {"RangeAtTenPercent": 10.0, "ReflectanceArray": "Color"}
_TURNING = {"TurnRate": 37.5}
_OFFSET = {"AxisOffset": (0.1, 0.0, 0.0)}
_SPEED = 0.05

IDEAL = Effect("ideal", "-")
EFFECTS = (
    IDEAL,
    Effect("noise", "5 mm", errors=_NOISE),
    Effect("steps", "1 mm", errors=_STEPS),
    Effect("steps", "10 mm", errors={"RangeResolution": 0.01}),
    Effect("bias", "15 mm", errors=_BIAS),
    Effect("width of the beam", "12 mm + 4.4 mrad", _WIDTH),
    Effect("reflectance", "10 % at 10 m", _REFLECTANCE),
    Effect("turning platform", "37.5 degrees/s", _TURNING),
    Effect("mirror off the axis", "0.1 m", _OFFSET),
    Effect("motion", f"{_SPEED:g} m/s", speed=_SPEED),
    Effect("LMS 200 at rest", "mm mode", {**_WIDTH, **_REFLECTANCE},
           {**_NOISE, **_STEPS}),
    Effect("motion, width and noise", "-", _WIDTH, _NOISE, _SPEED),
    Effect("all", "-", {**_WIDTH, **_REFLECTANCE, **_TURNING, **_OFFSET},
           {**_NOISE, **_STEPS, **_BIAS}, _SPEED),
)


def make_path(speed):
    """Return a trajectory from the sensor's position along x, with the sensor's axes at rest."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    x, y, z = POSITION
    points.InsertNextPoint(x, y, z)
    points.InsertNextPoint(x + speed * DURATION, y, z)
    path = vtkPolyData()
    path.SetPoints(points)
    times = numpy_to_vtk([0.0, DURATION], deep=True)
    times.SetName("Time")
    path.GetPointData().AddArray(times)
    return path
