#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The arrays that a device adds to a scan: in files, in maps, and as fields of lms3d.Scan."""

import unittest
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPolyData

import lms3d
from command_line import POSITION, room
from device_cases import GRID, in_vtk
from lms3d.comparison import copy_pose
from lms3d.formats import encode
from lms3d.measurements import read_scan


class TestArrays(unittest.TestCase):
    """Files and maps keep what a device adds to a scan."""

    def setUp(self):
        self.scan = lms3d.scan(room(), POSITION, **GRID).poly

    def add(self, data, **arrays):
        """Add arrays to point data or field data."""
        for name, values in arrays.items():
            added = numpy_to_vtk(np.asarray(values), deep=True)
            added.SetName(name)
            data.AddArray(added)

    def columns(self, ending):
        """The columns of a file of the points."""
        content = b"".join(encode(self.scan, ending, "cannot write"))
        if ending == ".csv":
            return content.split(b"\n", 1)[0].decode().split(",")
        header = content.split(b"end_header")[0].decode().splitlines()
        return [line.split()[-1] for line in header if line.startswith("property")]

    def test_columns(self):
        plain = ["x", "y", "z", "Range", "Alpha", "Beta", "BeamId", "CellId"]
        more = ["Incidence", "Intensity", "Time"]
        for ending in (".csv", ".ply"):
            self.assertEqual(self.columns(ending), plain)
        zeros = np.zeros(self.scan.GetNumberOfPoints())
        self.add(self.scan.GetPointData(), **{name: zeros for name in reversed(more)},
                 SensorPosition=np.zeros((len(zeros), 3)))
        for ending in (".csv", ".ply"):
            self.assertEqual(self.columns(ending), plain + more)

    def test_a_map_gets_the_platform(self):
        local_map = vtkPolyData()
        copy_pose(self.scan, local_map)
        self.assertFalse(local_map.GetFieldData().HasArray("Mounting"))
        self.add(self.scan.GetFieldData(), Mounting=np.array([2], np.int32),
                 AxisOffset=[0.1, 0.0, 0.2], TurnRate=[37.5])
        copy_pose(self.scan, local_map)
        fields = local_map.GetFieldData()
        self.assertEqual(fields.GetArray("Mounting").GetValue(0), 2)
        self.assertEqual(fields.GetArray("AxisOffset").GetValue(2), 0.2)
        self.assertEqual(fields.GetArray("TurnRate").GetValue(0), 37.5)

    def test_fields_of_a_scan(self):
        """The further arrays of a scan are fields."""
        status = np.arange(31 * 24, dtype=np.uint8) % 5
        count = self.scan.GetNumberOfPoints()
        self.add(self.scan.GetFieldData(), Status=status)
        self.add(self.scan.GetPointData(), Incidence=np.ones(count, np.float32), Time=np.ones(count),
                 SensorPosition=np.ones((count, 3)), SensorOrientation=np.ones((count, 4)))
        image = lms3d.vtkLMS3DScanFilter()
        image.SetInputData(room())
        image.SetPosition(POSITION)
        for name, value in GRID.items():
            getattr(image, f"Set{in_vtk(name)}")(value)
        image.Update()
        scan = read_scan(mock.Mock(GetOutput=lambda: self.scan,
                                   GetOutputDataObject=image.GetOutputDataObject))
        self.assertEqual(scan.status.shape, scan.ranges.shape)
        np.testing.assert_array_equal(scan.status.ravel(), status)
        self.assertEqual((scan.incidence.shape, scan.times.shape), ((count,), (count,)))
        self.assertEqual((scan.positions.shape, scan.orientations.shape), ((count, 3), (count, 4)))
        self.assertIsNone(scan.intensity)


if __name__ == "__main__":
    unittest.main()
