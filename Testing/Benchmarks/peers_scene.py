# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes and beams that compare_peers.py gives to every peer."""

import math
import pathlib

import numpy

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
BEAMS = 361
TURNS = 360
MAXIMUM_RANGE = 80.0
SENSORS = {"room": (0.3, -0.2, 1.0), "teapot": (0.10, -0.33, 0.30)}
TERRAINS = {"terrain1e4": (50, 100), "terrain1e5": (200, 250), "terrain1e6": (500, 1000)}
NAMES = (*SENSORS, *TERRAINS)


def make(name):
    """Return points (float64), triangles (int32) and the sensor's position."""
    if name in SENSORS:
        return *_read(name), numpy.array(SENSORS[name])
    return _make_terrain(*TERRAINS[name])


def make_directions():
    """Return the directions of the default grid, those of the filter to the bit."""
    alpha_sine, alpha_cosine = _sines_and_cosines(i / 2 - 90 for i in range(BEAMS))
    beta_sine, beta_cosine = _sines_and_cosines(range(TURNS))
    directions = numpy.empty((TURNS, BEAMS, 3))
    directions[:, :, 0] = numpy.outer(beta_cosine, alpha_cosine)
    directions[:, :, 1] = numpy.outer(-beta_sine, alpha_cosine)
    directions[:, :, 2] = alpha_sine
    return directions.reshape(-1, 3)


def _sines_and_cosines(angles):
    """Sines and cosines of degrees, exact at the multiples of 90."""
    table = []
    for degrees in angles:
        reduced = math.fmod(degrees, 360.0)
        # As C's lround: halves go away from zero.
        quarter = int(math.copysign(math.floor(abs(reduced) / 90.0 + 0.5), reduced))
        rest = reduced - 90.0 * quarter
        sine, cosine = math.sin(rest * (math.pi / 180)), math.cos(rest * (math.pi / 180))
        if abs(rest) == 45.0:
            cosine = math.sqrt(0.5)
            sine = math.copysign(cosine, rest)
        for _ in range(quarter % 4):
            sine, cosine = cosine, -sine
        table.append((sine + 0.0, cosine + 0.0))
    return numpy.array(table).T


def _read(name):
    from lms3d import vtkVRMLImporterSource
    from vtkmodules.util.numpy_support import vtk_to_numpy

    reader = vtkVRMLImporterSource()
    reader.SetFileName(str(DATA / f"{name}.wrl"))
    reader.Update()
    surface = reader.GetOutput()
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(numpy.float64)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    return points, triangles.reshape(-1, 3).astype(numpy.int32)


def _height(x, y):
    height = 0.0
    length, amplitude = 60.0, 4.0
    for octave in range(6):
        u = x * numpy.cos(octave) + y * numpy.sin(octave)
        v = y * numpy.cos(octave) - x * numpy.sin(octave)
        height += (amplitude * numpy.sin(2 * numpy.pi * u / length + octave)
                   * numpy.cos(2 * numpy.pi * v / length + 2 * octave))
        length, amplitude = 0.45 * length, 0.4 * amplitude
    return height


def _make_terrain(columns, rows):
    """The hills of the C++ benchmarks."""
    x, y = numpy.meshgrid(200 * (numpy.arange(columns + 1) / columns - 0.5),
                          200 * (numpy.arange(rows + 1) / rows - 0.5))
    points = numpy.stack([x, y, _height(x, y)], axis=-1).reshape(-1, 3)
    number = numpy.arange(len(points), dtype=numpy.int32).reshape(rows + 1, columns + 1)
    a, b = number[:-1, :-1], number[:-1, 1:]
    c, d = number[1:, 1:], number[1:, :-1]
    triangles = numpy.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    sensor = numpy.array([0.013, 0.021, _height(0.013, 0.021) + 2.0])
    return points.astype(numpy.float32).astype(numpy.float64), triangles, sensor
