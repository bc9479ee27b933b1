# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A scan in one call, with numpy arrays."""

import warnings

from .arguments import to_bound, to_choice, to_count, to_number, to_numbers
from .device import set_arrays, set_errors, set_platform, set_sensor
from .interruption import abortable
from .measurements import Scan, read_scan  # noqa: F401 Scan is part of this interface
from .mesh import from_vtk, to_vtk
from .messages import VTKMessages
from .motion import to_trajectory
from .problems import Problem
from .properties import MAXIMUM_GROUP, MAXIMUM_THREADS, METHODS, MINIMUM_SEED
from .vtkLMS3DFilters import (
    vtkLMS3DRangeErrorFilter,
    vtkLMS3DScanFilter,
    vtkLMS3DSurfaceReconstructionFilter,
)


def scan(mesh, position=None, *, orientation=(0.0, 0.0, 0.0), alpha_range=(-90.0, 90.0),
         alpha_resolution=361, beta_range=(0.0, 360.0), beta_resolution=360, minimum_range=0.0,
         maximum_range=None, method="exact", threads=0, surface_attributes=False,
         device="ideal", beam_diameter=None, beam_divergence=None, beam_samples=None,
         pulse_length=None, range_at_ten_percent=None, reflectance=None,
         range_bias=None, range_noise=None, range_resolution=None, seed=0,
         mounting="yawing", axis_offset=(0.0, 0.0, 0.0), turn_rate=0.0,
         trajectory=None, start_time=None, motion_during_scan=False,
         incidence=False, intensity=False, time=False, status=False, poses=False):
    """Scan a mesh from a position and return a Scan, whose fields are numpy arrays.

    Lengths are in metres, angles in degrees, times in seconds; z is up. Further scans of one mesh
    are faster with vtkLMS3DScanFilter, which keeps its acceleration structure.

    mesh: a vtkPolyData or another data set of VTK, or a pair (vertices, triangles) of an N x 3
        array of coordinates and an M x 3 array of numbers of vertices.
    position: x, y, z of the sensor. A trajectory replaces it.
    orientation: of the sensor, about x, y and z, applied as in vtkProp3D: z, then x, then y.
    alpha_range, alpha_resolution: first and last elevation of the fan, within -90 to 90, both
        included, and the number of beams in the fan.
    beta_range, beta_resolution: first and last angle of the platform, clockwise seen from above,
        and the number of turns. The end of a full circle is excluded.
    minimum_range, maximum_range: a surface nearer or farther gives no return. By default the maximum
        is that of the device, 80 for an ideal one.
    method: exact, fast, angle-sum, moller-trumbore or static-cell-locator.
    threads: 1 to 1024; 0 stands for all cores. The result does not depend on it.
    surface_attributes: whether the point data of `poly` also has what the beams hit: Normals,
        Incidence, and the cell arrays of the mesh.

    device: ideal, lms200-mm, lms200-cm or lms291. The device chooses maximum_range and the following
        arguments until seed. An argument that is given replaces the value of the device.
    beam_diameter, beam_divergence: diameter of the beam at the sensor, and its growth for each metre.
    beam_samples: rays that stand for a beam, 1 to 1000; 1 is a beam without width, 7 and 19 complete
        a ring.
    pulse_length: surfaces within this of the nearest mix to one range; else the larger part counts.
    range_at_ten_percent: range at which the device still sees a surface that reflects 10 percent; 0
        sees every surface.
    reflectance: name of the cell array of the mesh with the reflectance, 0.1 for 10 percent, or of an
        array of colours, which stand for their luminance. By default every surface reflects all.
    range_bias, range_noise, range_resolution: the errors of ranges, in this order: a constant, one
        standard deviation of normally distributed noise, and the step that ranges are rounded to. A
        range that would be 0 or less is no return.
    seed: the number of the noise; the same seed gives the same noise.

    mounting: yawing, yawing-top, pitching or rolling: the axis that the platform turns.
    axis_offset: the centre of the mirror, relative to the position, along the sensor's axes while the
        platform's angle is 0. It turns with the platform.
    turn_rate: how fast the platform turns during each fan, degrees a second.
    trajectory: poses of the sensor: a vtkPolyData as for vtkLMS3DScanFilter, or a tuple of arrays
        (times, positions) or (times, positions, orientations as quaternions w x y z).
    start_time: when the scan starts; by default at the first pose. Without motion, the scan is from
        the last pose that is not later.
    motion_during_scan: whether each beam leaves from the pose at its own time. The points are where
        a sensor at rest would put them, so they are skewed. `undistort` corrects them; it needs
        poses.
    incidence, intensity, time, status, poses: whether the Scan has these fields.

    Raises ValueError if an argument is invalid or the mesh has no polygons.
    """
    given = dict(locals())
    sensor = vtkLMS3DScanFilter()
    sensor.SetIntersectionMethod(to_choice("method", method, METHODS))
    sensor.SetInputDataObject(to_vtk(mesh))
    _set_poses(sensor, given)
    sensor.SetOrientation(to_numbers("orientation", orientation, 3))
    sensor.SetAlphaRange(to_numbers("alpha_range", alpha_range, 2))
    sensor.SetAlphaResolution(to_count("alpha_resolution", alpha_resolution))
    sensor.SetBetaRange(to_numbers("beta_range", beta_range, 2))
    sensor.SetBetaResolution(to_count("beta_resolution", beta_resolution))
    sensor.SetMinimumRange(to_number("minimum_range", minimum_range))
    set_sensor(sensor, device, given)
    sensor.SetReflectanceArray(reflectance)
    set_platform(sensor, mounting, axis_offset, turn_rate)
    set_arrays(sensor, incidence, intensity, time, status, poses)
    sensor.SetSurfaceAttributes(bool(surface_attributes))
    sensor.SetNumberOfThreads(to_count("threads", threads, 0, MAXIMUM_THREADS))
    errors = vtkLMS3DRangeErrorFilter()
    has_errors = set_errors(errors, device, given)
    errors.SetNoiseSeed(to_count("seed", seed, MINIMUM_SEED))
    errors.SetNumberOfThreads(sensor.GetNumberOfThreads())
    start = None if start_time is None else to_number("start_time", start_time)
    _update(sensor, "cannot scan", start)
    if not has_errors:
        return read_scan(sensor)
    errors.SetInputConnection(sensor.GetOutputPort())
    _update(errors, "cannot add errors to the ranges", start)
    return read_scan(errors)


def _set_poses(sensor, given):
    """Set the position or the trajectory."""
    if given["trajectory"] is not None:
        sensor.SetTrajectoryData(to_trajectory(given["trajectory"]))
        sensor.SetMotionDuringScan(bool(given["motion_during_scan"]))
    elif given["motion_during_scan"] or given["start_time"] is not None:
        raise ValueError("motion_during_scan and start_time need a trajectory")
    else:
        sensor.SetPosition(to_numbers("position", given["position"], 3))


def reconstruct(scan, *, maximum_error=0.01, depth_step=0.1, maximum_gap_size=-1,
                maximum_speckle_size=0, keep_speckles=True):
    """Return the local map of a Scan: a Mesh of few triangles, which face the sensor.

    maximum_error: bound on the distance of every return from the map, metres; 0 makes every return
        a vertex.
    depth_step: the map has a gap where neighbouring ranges differ by more than this, metres.
    maximum_gap_size: the surface goes on across groups of at most this number of neighbouring beams without
        a return, if the returns around a group lie on one plane. -1 stands for 25 if the scan has its
        status, otherwise for 0.
    maximum_speckle_size: the surface goes on behind groups of at most this number of neighbouring returns
        that lie off the plane of the returns around them.
    keep_speckles: whether each return of these groups gets a small triangle; if not, the map leaves
        them out.

    Raises ValueError if an argument is invalid.
    """
    return from_vtk(make_map(scan, locals()))


def make_map(scan, given):
    """The local map of a Scan as vtkPolyData; `given` are the arguments of `reconstruct` by name."""
    mapping = vtkLMS3DSurfaceReconstructionFilter()
    mapping.SetInputDataObject(scan.poly)
    mapping.SetMaximumError(to_bound("maximum_error", given["maximum_error"]))
    mapping.SetDepthStep(to_bound("depth_step", given["depth_step"]))
    mapping.SetMaximumGapSize(to_count("maximum_gap_size", given["maximum_gap_size"], -1,
                                       MAXIMUM_GROUP))
    mapping.SetMaximumSpeckleSize(to_count("maximum_speckle_size", given["maximum_speckle_size"], 0,
                                           MAXIMUM_GROUP))
    mapping.SetKeepSpeckles(bool(given["keep_speckles"]))
    _update(mapping, "cannot build the local map", stack_level=4)
    return mapping.GetOutput()


def _update(algorithm, failure, time=None, stack_level=3):
    """Update, for a time if given; repeats VTK's warnings as Python's, and its errors as ValueError.

    Ctrl-C aborts the algorithm and raises KeyboardInterrupt.
    """
    with VTKMessages() as messages, abortable(algorithm):
        if time is None:
            algorithm.Update()
        else:
            algorithm.UpdateTimeStep(time)
    if messages.errors:
        try:
            messages.report(failure)
        except Problem as problem:
            raise ValueError(str(problem)) from None
    for text in messages.warnings:
        warnings.warn(text, stacklevel=stack_level)
