#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d.FusedMap and vtkLMS3DMapFusion in Python: one map of scans from several places of the room."""

import inspect
import unittest
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

import lms3d
from command_line import field, points, room, triangles
from journeys import PLACES, trajectory

RESOLUTION = {"alpha_resolution": 91, "beta_resolution": 90}


def cell_array(data, name):
    """An array of the cell data as numpy; empty if there are no cells."""
    array = data.GetCellData().GetArray(name)
    return vtk_to_numpy(array) if array else np.empty(0, int)


def corners(data):
    """Each triangle with its region, as a sorted list."""
    regions = cell_array(data, "RegionId")
    places = points(data)[triangles(data)].reshape(len(regions), -1) if len(regions) else []
    return sorted((region, *place) for region, place in zip(regions.tolist(), map(tuple, places)))


class TestFusedMap(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scans = [lms3d.scan(room(), place, **RESOLUTION) for place in PLACES]

    def fuse(self, **arguments):
        """The map of all scans."""
        fused = lms3d.FusedMap(**arguments)
        for scan in self.scans:
            fused.add(scan)
        return fused

    def test_every_return_of_every_scan_is_near_the_map(self):
        for bound in (0.01, 0.05):
            fused = self.fuse(maximum_error=bound)
            distance = vtkImplicitPolyDataDistance()
            distance.SetInput(fused.poly)
            for number, scan in enumerate(self.scans):
                with self.subTest(bound, scan=number):
                    farthest = max(abs(distance.EvaluateFunction(place)) for place in scan.points)
                    self.assertLessEqual(farthest, bound + 1e-9)

    def test_the_mesh_has_what_the_filter_puts_out(self):
        fused = self.fuse()
        np.testing.assert_array_equal(fused.mesh.vertices, points(fused.filter.GetOutput()))
        np.testing.assert_array_equal(fused.mesh.triangles, triangles(fused.filter.GetOutput()))
        self.assertEqual(field(fused.poly, "NumberOfScans"), [3])
        np.testing.assert_array_equal(field(fused.poly, "SensorPositions").reshape(-1, 3), PLACES)

    def test_it_grows(self):
        fused = lms3d.FusedMap()
        self.assertEqual(fused.mesh.triangles.shape, (0, 3))
        sizes = []
        for scan in self.scans:
            fused.add(scan)
            sizes.append(len(fused.mesh.triangles))
        self.assertEqual(sizes, sorted(sizes))
        self.assertGreater(sizes[0], 0)

    def test_a_pipeline_that_plays_the_trajectory_gives_the_same(self):
        sensor, mapping = lms3d.vtkLMS3DScanFilter(), lms3d.vtkLMS3DSurfaceReconstructionFilter()
        sensor.SetInputData(room())
        sensor.SetTrajectoryData(trajectory())
        sensor.SetAlphaResolution(RESOLUTION["alpha_resolution"])
        sensor.SetBetaResolution(RESOLUTION["beta_resolution"])
        mapping.SetInputConnection(sensor.GetOutputPort())
        fusion = lms3d.vtkLMS3DMapFusion()
        fusion.SetInputConnection(mapping.GetOutputPort())
        fusion.SetScanConnection(sensor.GetOutputPort())
        for time in (0, 1, 2, 1):
            fusion.UpdateTimeStep(time)
        self.assertEqual(fusion.GetNumberOfScans(), 3)
        expected = self.fuse(threads=1).poly
        np.testing.assert_array_equal(points(fusion.GetOutput()), points(expected))
        np.testing.assert_array_equal(triangles(fusion.GetOutput()), triangles(expected))

    def test_changes_make_the_next_map_of_one_before(self):
        fused = lms3d.FusedMap()
        fused.add(self.scans[0])
        before, revision = corners(fused.poly), fused.revision
        for scan in self.scans[1:]:
            fused.add(scan)
        changes = fused.changes(revision)
        changed = set(field(changes, "ChangedRegions").tolist())
        patched = [each for each in before if each[0] not in changed] + corners(changes)
        self.assertEqual(sorted(patched), corners(fused.poly))
        self.assertGreater(len(corners(changes)), 0)
        self.assertEqual(fused.changes(fused.revision).GetNumberOfCells(), 0)

    def test_defaults_are_the_filters(self):
        filters = (lms3d.vtkLMS3DMapFusion(), lms3d.vtkLMS3DSurfaceReconstructionFilter())
        for name, parameter in inspect.signature(lms3d.FusedMap).parameters.items():
            getter = "Get" + name.title().replace("_", "")
            getter = {"GetThreads": "GetNumberOfThreads"}.get(getter, getter)
            values = [getattr(each, getter)() for each in filters if hasattr(each, getter)]
            with self.subTest(name):
                self.assertGreater(len(values), 0)
                self.assertEqual(set(values), {parameter.default})

    def test_arguments_reach_the_filters(self):
        fused = lms3d.FusedMap(maximum_error=0.3, keep_returns=False, forget_seen_through=True,
                               threads=3)
        self.assertEqual((fused.filter.GetMaximumError(), fused.filter.GetKeepReturns(),
                          fused.filter.GetForgetSeenThrough(), fused.filter.GetNumberOfThreads()),
                         (0.3, False, True, 3))
        coarse = self.fuse(depth_step=10, maximum_error=0.05)
        self.assertNotEqual(len(coarse.mesh.triangles),
                            len(self.fuse(maximum_error=0.05).mesh.triangles))

    def test_invalid_arguments(self):
        for name, value in (("maximum_error", 0), ("maximum_error", -1), ("maximum_error", np.nan),
                            ("threads", 1025), ("threads", 0.5)):
            with self.subTest(name, value=value), self.assertRaisesRegex(ValueError, name):
                lms3d.FusedMap(**{name: value})
        for name, value in (("depth_step", "x"), ("maximum_gap_size", -2)):
            with self.subTest(name, value=value), self.assertRaisesRegex(ValueError, name):
                lms3d.FusedMap(**{name: value}).add(self.scans[0])
        with self.assertRaisesRegex(ValueError, "since"):
            lms3d.FusedMap().changes(-1)

    def test_what_the_filter_refuses_is_an_error_and_adds_nothing(self):
        fused = self.fuse()
        before = points(fused.poly).copy()
        broken = vtkPolyData()
        with mock.patch("lms3d.fusion.make_map", lambda scan, _: broken), \
                self.assertRaisesRegex(ValueError, "cannot join the map of this scan"):
            fused.add(self.scans[0])
        np.testing.assert_array_equal(points(fused.poly), before)
        self.assertEqual(fused.filter.GetNumberOfScans(), 3)


if __name__ == "__main__":
    unittest.main()
