# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""How well a local map shows the scene that was scanned."""

from typing import NamedTuple

from . import vtkLMS3DMapComparison
from .execution import update

POSE_ARRAYS = ("SensorToWorld", "AlphaAngles", "BetaAngles")


class Errors(NamedTuple):
    """Many errors in four numbers, metres or degrees."""

    mean: float
    rms: float
    percentile_95: float
    maximum: float


class Comparison:
    """The results of vtkLMS3DMapComparison, which explains them.

    `map` is the map with the arrays Error and LargestError, `scene_points` are points of the
    visible scene with the array Error (vtkPolyData, metres). Lengths are in metres, areas in square
    metres, angles in degrees, shares from 0 to 1. The two numbers on returns are None where no scan
    was compared.
    """

    def __init__(self, algorithm):
        self.map = algorithm.GetOutput()
        self.scene_points = algorithm.GetOutputDataObject(1)
        self.tolerance = algorithm.GetTolerance()
        self.triangles = int(self._number("MapTriangles"))
        self.map_area = self._number("MapArea")
        self.visible_area = self._number("VisibleArea")
        self.area_in_free_space = self._number("AreaInFreeSpace")
        self.map_to_scene = self._errors("MapToScene")
        self.scene_to_map = self._errors("SceneToMap")
        self.normal_error = self._errors("NormalError")
        self.correctness = self._number("Correctness")
        self.completeness = self._number("Completeness")
        self.f_score = self._number("FScore")
        self.returns_within_tolerance = self._number("ReturnsWithinTolerance")
        self.largest_return_distance = self._number("LargestReturnDistance")

    def _number(self, name):
        array = self.map.GetFieldData().GetArray(name)
        return array.GetValue(0) if array else None

    def _errors(self, name):
        return Errors(*self.map.GetFieldData().GetArray(name).GetTuple4(0))


def compare(local_map, scene, scan=None, tolerance=0.01, samples=None, ranges=None, threads=0,
            label="comparing", share=(0.0, 1.0)):
    """Compare a map with the scene that was scanned; returns a Comparison or raises Problem.

    `local_map` is vtkPolyData, `scene` what vtkLMS3DScanFilter scans. `scan` tells where the sensor
    was if the map does not; its returns are compared with the map, too. `ranges` are those between
    which the sensor measures, metres (default: 0 to 80). `label` stands before the progress bar, of
    which this takes the part from the start to the end of `share`.
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
    """Whether a map or scan says where its sensor was and what its beams covered."""
    return all(data.GetFieldData().HasArray(name) for name in POSE_ARRAYS)


def pass_pose(scan, local_map):
    """Tell a map where the sensor of a scan was."""
    for name in POSE_ARRAYS:
        local_map.GetFieldData().AddArray(scan.GetFieldData().GetArray(name))
