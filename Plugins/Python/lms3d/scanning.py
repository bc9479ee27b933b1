# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A scan in one call, with numpy arrays."""

import math
import operator
import warnings
from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .interruption import abortable
from .mesh import from_vtk, to_vtk
from .messages import VTKMessages
from .problems import Problem
from .properties import MAXIMUM_COUNT, MAXIMUM_THREADS, METHODS, MINIMUM_SEED
from .vtkLMS3DFilters import (
    vtkLMS3DRangeErrorFilter,
    vtkLMS3DScanFilter,
    vtkLMS3DSurfaceReconstructionFilter,
)


@dataclass(frozen=True, eq=False, repr=False)
class Scan:
    """What a scan measured: lengths in metres, angles in degrees.

    points: N x 3, where the beams hit the mesh, in its coordinates, ordered by turn, then by beam.
    ranges: turns x beams, the distances from the sensor, NaN for beams without a return.
    cells: N, the number of the triangle that was hit, for each point. (For a vtkPolyData it is the
        array CellId of vtkLMS3DScanFilter.)
    beams: N, the beam of each point: `ranges.ravel()[beams]` are the ranges of the points.
    alpha: the elevation of each column of ranges. beta: the platform angle of each row.
    poly: the scan as vtkPolyData, for VTK's filters.
    """

    points: np.ndarray
    ranges: np.ndarray
    cells: np.ndarray
    beams: np.ndarray
    alpha: np.ndarray
    beta: np.ndarray
    poly: vtkPolyData

    def __repr__(self):
        turns, beams = self.ranges.shape
        return f"<lms3d.Scan: {turns} x {beams} beams, {len(self.points)} returns>"


def scan(mesh, position, *, orientation=(0.0, 0.0, 0.0), alpha_range=(-90.0, 90.0),
         alpha_resolution=361, beta_range=(0.0, 360.0), beta_resolution=360, minimum_range=0.0,
         maximum_range=80.0, method="exact", threads=0, surface_attributes=False,
         range_bias=0.0, range_noise=0.0, range_resolution=0.0, seed=0):
    """Scan a mesh from a position and return a Scan, whose fields are numpy arrays.

    Lengths are in metres, angles in degrees; z is up. Further scans of one mesh are faster with
    vtkLMS3DScanFilter, which keeps its acceleration structure.

    mesh: a vtkPolyData or another data set of VTK, or a pair (vertices, triangles) of an N x 3
        array of coordinates and an M x 3 array of numbers of vertices.
    position: x, y, z of the sensor.
    orientation: of the sensor, about x, y and z, applied as in vtkProp3D: z, then x, then y.
    alpha_range, alpha_resolution: first and last elevation of the fan, within -90 to 90, both
        included, and the number of beams in the fan.
    beta_range, beta_resolution: first and last angle of the platform, clockwise seen from above,
        and the number of turns. The end of a full circle is excluded.
    minimum_range, maximum_range: a surface nearer or farther gives no return.
    method: exact, fast, angle-sum, moller-trumbore or static-cell-locator.
    threads: 1 to 1024; 0 stands for all cores. The result does not depend on it.
    surface_attributes: whether the point data of `poly` also has what the beams hit: Normals,
        Incidence, and the cell arrays of the mesh.
    range_bias, range_noise, range_resolution: the errors of the device, metres, in this order: a
        constant, one standard deviation of normally distributed noise, and the step that ranges are
        rounded to. By default there are none. A range that would be 0 or less is no return.
    seed: the number of the noise; the same seed gives the same noise.

    Raises ValueError if an argument is invalid or the mesh has no polygons.
    """
    if method not in list(METHODS):
        raise ValueError(f"method must be one of {', '.join(METHODS)}, not {method!r}")
    sensor = vtkLMS3DScanFilter()
    sensor.SetInputDataObject(to_vtk(mesh))
    sensor.SetPosition(_to_numbers("position", position, 3))
    sensor.SetOrientation(_to_numbers("orientation", orientation, 3))
    sensor.SetAlphaRange(_to_numbers("alpha_range", alpha_range, 2))
    sensor.SetAlphaResolution(_to_count("alpha_resolution", alpha_resolution))
    sensor.SetBetaRange(_to_numbers("beta_range", beta_range, 2))
    sensor.SetBetaResolution(_to_count("beta_resolution", beta_resolution))
    sensor.SetMinimumRange(_to_number("minimum_range", minimum_range))
    sensor.SetMaximumRange(_to_number("maximum_range", maximum_range))
    sensor.SetIntersectionMethod(METHODS[method])
    sensor.SetSurfaceAttributes(bool(surface_attributes))
    sensor.SetNumberOfThreads(_to_count("threads", threads, 0, MAXIMUM_THREADS))
    errors = vtkLMS3DRangeErrorFilter()
    errors.SetRangeBias(_to_finite("range_bias", range_bias))
    errors.SetRangeNoise(_to_bound("range_noise", range_noise))
    errors.SetRangeResolution(_to_bound("range_resolution", range_resolution))
    errors.SetNoiseSeed(_to_count("seed", seed, MINIMUM_SEED))
    errors.SetNumberOfThreads(sensor.GetNumberOfThreads())
    _update(sensor, "cannot scan")
    if not (range_bias or range_noise or range_resolution):
        return _result(sensor)
    errors.SetInputConnection(sensor.GetOutputPort())
    _update(errors, "cannot add errors to the ranges")
    return _result(errors)


def reconstruct(scan, *, maximum_error=0.01, depth_step=0.1):
    """Return the local map of a Scan: a Mesh of few triangles, which face the sensor.

    maximum_error: bound on the distance of every return from the map, metres; 0 makes every return
        a vertex.
    depth_step: the map has a gap where neighbouring ranges differ by more than this, metres.

    Raises ValueError if an argument is invalid.
    """
    mapping = vtkLMS3DSurfaceReconstructionFilter()
    mapping.SetInputDataObject(scan.poly)
    mapping.SetMaximumError(_to_bound("maximum_error", maximum_error))
    mapping.SetDepthStep(_to_bound("depth_step", depth_step))
    _update(mapping, "cannot build the local map")
    return from_vtk(mapping.GetOutput())


def _result(last):
    poly, image = last.GetOutput(), last.GetOutputDataObject(1)

    def point_array(name):
        return vtk_to_numpy(poly.GetPointData().GetArray(name))

    def field(name):
        return vtk_to_numpy(poly.GetFieldData().GetArray(name))

    alpha, beta = field("AlphaAngles"), field("BetaAngles")
    ranges = vtk_to_numpy(image.GetPointData().GetArray("Range")).reshape(len(beta), len(alpha))
    return Scan(vtk_to_numpy(poly.GetPoints().GetData()), ranges, point_array("CellId"),
                point_array("BeamId"), alpha, beta, poly)


def _update(algorithm, failure):
    """Update; raises VTK's errors as ValueError, and repeats its warnings as Python's.

    Ctrl-C aborts the algorithm and raises KeyboardInterrupt.
    """
    with VTKMessages() as messages, abortable(algorithm):
        algorithm.Update()
    if messages.errors:
        try:
            messages.report(failure)
        except Problem as problem:
            raise ValueError(str(problem)) from None
    for text in messages.warnings:
        warnings.warn(text, stacklevel=3)


def _to_numbers(name, values, count):
    try:
        numbers = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        numbers = np.empty(0)
    if numbers.shape != (count,) or not np.isfinite(numbers).all():
        raise ValueError(f"{name} must be {count} finite numbers, not {values!r}")
    return numbers.tolist()


def _to_number(name, value):
    try:
        return float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name} must be a number, not {value!r}") from None


def _to_finite(name, value):
    number = _to_number(name, value)
    if not math.isfinite(number):
        raise ValueError(f"{name} must be finite, not {value!r}")
    return number


def _to_bound(name, value):
    bound = _to_number(name, value)
    if not 0 <= bound < math.inf:
        raise ValueError(f"{name} must be 0 or more, and finite, not {value!r}")
    return bound


def _to_count(name, value, minimum=1, maximum=MAXIMUM_COUNT):
    try:
        count = operator.index(value)
    except TypeError:
        count = minimum - 1
    if not minimum <= count <= maximum:
        raise ValueError(f"{name} must be a whole number from {minimum} to {maximum}, not "
                         f"{value!r}")
    return count
