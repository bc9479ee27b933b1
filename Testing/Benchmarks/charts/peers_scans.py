# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scans of "./run bench map" once more, for libraries that are called from Python."""

import numpy
from lms3d import vtkLMS3DScanFilter, vtkVRMLImporterSource
from places import DATA
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkBoxMuellerRandomSequence, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

SENSORS = {"room": (0.3, -0.2, 1.0), "teapot": (0.10, -0.33, 0.30)}
HILLS = {"terrain1e5": (200, 250)}  # columns and rows of squares
NOISE = 0.005  # standard deviation, metres


def make_scan(name):
    """Return the surface of a scene, its scan and the sensor's position."""
    surface, sensor = _make_hills(*HILLS[name]) if name in HILLS else _read(name)
    scan = vtkLMS3DScanFilter()
    scan.SetInputData(surface)
    scan.SetPosition(sensor)
    scan.Update()
    return surface, scan.GetOutput(), sensor


def _read(name):
    reader = vtkVRMLImporterSource()
    reader.SetFileName(str(DATA / f"{name}.wrl"))
    reader.Update()
    return reader.GetOutput(), numpy.array(SENSORS[name])


def _make_hills(columns, rows):
    x, y = numpy.meshgrid(200 * (numpy.arange(columns + 1) / columns - 0.5),
                          200 * (numpy.arange(rows + 1) / rows - 0.5))
    points = numpy.stack([x, y, _get_height(x, y)], axis=-1).reshape(-1, 3)
    number = numpy.arange(len(points)).reshape(rows + 1, columns + 1)
    a, b = number[:-1, :-1], number[:-1, 1:]
    c, d = number[1:, 1:], number[1:, :-1]
    triangles = numpy.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    sensor = numpy.array([0.013, 0.021, _get_height(0.013, 0.021) + 2.0])
    # The benchmark keeps its points in single precision.
    return make_surface(points.astype(numpy.float32), triangles), sensor


def _get_height(x, y):
    height = 0.0
    length, amplitude = 60.0, 4.0
    for octave in range(6):
        u = x * numpy.cos(octave) + y * numpy.sin(octave)
        v = y * numpy.cos(octave) - x * numpy.sin(octave)
        height += (amplitude * numpy.sin(2 * numpy.pi * u / length + octave)
                   * numpy.cos(2 * numpy.pi * v / length + 2 * octave))
        length, amplitude = 0.45 * length, 0.4 * amplitude
    return height


def make_surface(points, triangles):
    """Return vtkPolyData of the arrays, its points in double precision."""
    vertices = vtkPoints()
    vertices.SetData(numpy_to_vtk(numpy.asarray(points, dtype=float), deep=True))
    cells = vtkCellArray()
    corners = numpy.asarray(triangles, dtype=numpy.int64)
    cells.SetData(3, numpy_to_vtkIdTypeArray(corners.ravel(), deep=True))
    surface = vtkPolyData()
    surface.SetPoints(vertices)
    surface.SetPolys(cells)
    return surface


def add_noise(scan, sensor):
    """Return the scan with the errors along the beams that "./run bench map" adds."""
    noisy = vtkPolyData()
    noisy.DeepCopy(scan)
    points = vtk_to_numpy(noisy.GetPoints().GetData())
    ranges = vtk_to_numpy(noisy.GetPointData().GetArray("Range"))
    errors = _make_errors(len(ranges))
    points += (points - sensor) * (errors / ranges)[:, None]
    ranges += errors
    return noisy


def _make_errors(count):
    """Return normally distributed errors, metres."""
    random = vtkBoxMuellerRandomSequence()
    errors = numpy.empty(count)
    for number in range(count):
        errors[number] = random.GetScaledValue(0.0, NOISE)
        random.Next()
    return errors
