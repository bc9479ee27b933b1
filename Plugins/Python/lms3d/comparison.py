# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""How well a local map shows the scene that was scanned."""

import math
from typing import NamedTuple

from . import vtkLMS3DMapComparison
from .execution import update

POSE_ARRAYS = ("SensorToWorld", "AlphaAngles", "BetaAngles")
# A scan has these arrays only if they differ from their defaults.
PLATFORM_ARRAYS = ("Mounting", "AxisOffset", "TurnRate")


class Errors(NamedTuple):
    """A summary of errors, in metres or degrees."""

    mean: float
    rms: float
    percentile_95: float
    maximum: float


class Comparison:
    """The results of vtkLMS3DMapComparison; its documentation defines them.

    `map` is the map with the arrays Error and LargestError. `scene_points` are points of the
    visible scene with the array Error (both vtkPolyData, metres). Lengths are in metres, areas in
    square metres, angles in degrees, shares from 0 to 1. Without a scan that has returns,
    `returns_within_tolerance` and `largest_return_distance` are None.
    """

    def __init__(self, algorithm):
        self.map = algorithm.GetOutput()
        self.scene_points = algorithm.GetOutputDataObject(1)
        self.tolerance = algorithm.GetTolerance()
        self.triangles = algorithm.GetMapTriangles()
        self.map_area = algorithm.GetMapArea()
        self.visible_area = algorithm.GetVisibleArea()
        self.area_in_free_space = algorithm.GetAreaInFreeSpace()
        self.closed_gap_area_in_free_space = algorithm.GetClosedGapAreaInFreeSpace()
        self.map_to_scene = _errors(algorithm, "MapToScene")
        self.scene_to_map = _errors(algorithm, "SceneToMap")
        self.normal_error = _errors(algorithm, "NormalError")
        self.correctness = algorithm.GetCorrectness()
        self.completeness = algorithm.GetCompleteness()
        self.f_score = algorithm.GetFScore()
        self.returns_within_tolerance = _measured(algorithm.GetReturnsWithinTolerance())
        self.largest_return_distance = _measured(algorithm.GetLargestReturnDistance())


def _errors(algorithm, name):
    statistics = ("Mean", "RMS", "Percentile95", "Maximum")
    return Errors(*(getattr(algorithm, f"Get{name}{statistic}")() for statistic in statistics))


def _measured(value):
    return None if math.isnan(value) else value


def compare(local_map, scene, scan=None, tolerance=0.01, samples=None, ranges=None, threads=0,
            label="comparing", share=(0.0, 1.0)):
    """Compare a map with the scene that was scanned; returns a Comparison or raises Problem.

    `local_map` is vtkPolyData, `scene` any input of vtkLMS3DScanFilter. `scan` is needed if the map
    has no pose; its returns are compared with the map, too. `tolerance` is in metres, `samples` the
    number of points on each surface (default: 200,000). `ranges` are the sensor's minimum and
    maximum range, metres (default: 0 to 80). `label` is the text before the progress bar; `share`
    are the start and end of the bar's part that the comparison fills.
    """
    comparison = vtkLMS3DMapComparison()
    comparison.SetInputData(local_map)
    comparison.SetSceneData(scene)
    if scan:
        comparison.SetScanData(scan)
    comparison.SetTolerance(tolerance)
    if samples:
        comparison.SetNumberOfSamples(samples)
    if ranges:
        comparison.SetMinimumRange(ranges[0])
        comparison.SetMaximumRange(ranges[1])
    comparison.SetNumberOfThreads(threads)
    update(comparison, label, "cannot compare", share=share)
    return Comparison(comparison)


def has_pose(data):
    """Whether a map or scan has its sensor's pose and angles."""
    return all(data.GetFieldData().HasArray(name) for name in POSE_ARRAYS)


def copy_pose(scan, local_map):
    """Copy the sensor's pose, angles and platform from a scan to a map."""
    for name in POSE_ARRAYS + PLATFORM_ARRAYS:
        local_map.GetFieldData().RemoveArray(name)
        if scan.GetFieldData().HasArray(name):
            local_map.GetFieldData().AddArray(scan.GetFieldData().GetArray(name))
