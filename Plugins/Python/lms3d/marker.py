# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The sensor in pictures."""

from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkAssembly, vtkPolyDataMapper

_RED = (0.85, 0.10, 0.10)
_AXES = ((0.85, 0.10, 0.10), (0.10, 0.50, 0.10), (0.10, 0.20, 0.80))


def make_marker(size):
    """A red ball with the sensor's axes: x red, y green, z blue."""
    ball = vtkSphereSource()
    ball.SetRadius(0.3 * size)
    ball.SetThetaResolution(24)
    ball.SetPhiResolution(16)
    marker = vtkAssembly()
    marker.AddPart(_make_part(ball, _RED))
    for color, turn in zip(_AXES, ((0, 0, 0), (0, 0, 90), (0, -90, 0))):
        arrow = vtkArrowSource()
        arrow.SetTipResolution(16)
        arrow.SetShaftResolution(12)
        arrow.SetShaftRadius(0.05)
        arrow.SetTipRadius(0.14)
        axis = _make_part(arrow, color)
        axis.SetScale(1.6 * size)
        axis.SetOrientation(turn)
        marker.AddPart(axis)
    return marker


def _make_part(source, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    part = vtkActor()
    part.SetMapper(mapper)
    part.GetProperty().SetColor(*color)
    return part
