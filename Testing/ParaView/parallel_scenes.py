# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes and trajectories for the tests of several processes."""

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter


def write(data, path, writer_class=vtkXMLPolyDataWriter):
    """Write data so that every VTK reads it."""
    writer = writer_class()
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    writer.SetDataModeToBinary()
    writer.Write()


def lattice():
    """Half a ball of triangles and a floor of squares. All of them face the origin."""
    ball = vtkSphereSource()
    ball.SetRadius(3)
    ball.SetThetaResolution(36)
    ball.SetPhiResolution(37)
    floor = vtkPlaneSource()
    floor.SetOrigin(-2, -2, -1)
    floor.SetPoint1(2, -2, -1)
    floor.SetPoint2(-2, 2, -1)
    floor.SetResolution(16, 16)
    both = vtkAppendPolyData()
    both.AddInputConnection(floor.GetOutputPort())
    both.AddInputConnection(ball.GetOutputPort())
    both.Update()
    return both.GetOutput()


def volume():
    """A block of cubes."""
    image = vtkImageData()
    image.SetDimensions(5, 5, 5)
    cubes = vtkAppendFilter()
    cubes.AddInputData(image)
    cubes.Update()
    return cubes.GetOutput()


def journey(*places):
    """A trajectory of points."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for place in places:
        points.InsertNextPoint(place)
    poses = vtkPolyData()
    poses.SetPoints(points)
    return poses
