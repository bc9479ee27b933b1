#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Devices: the arguments of lms3d.scan, and lms3d.set_device."""

import unittest
from types import SimpleNamespace
from unittest import mock

import numpy as np

import lms3d
from command_line import POSITION, array, room
from device_cases import ARRAYS, ERRORS, GRID, OTHERS, RIG, SENSOR, in_vtk, values_in, values_of
from lms3d import scanning
from lms3d.properties import MOUNTINGS


class TestSetDevice(unittest.TestCase):
    """lms3d.set_device."""

    def test_filters(self):
        for make, names in ((lms3d.vtkLMS3DScanFilter, SENSOR), (lms3d.vtkLMS3DRangeErrorFilter,
                                                                ERRORS)):
            for device in lms3d.DEVICES:
                with self.subTest(make.__name__, device=device):
                    target = make()
                    lms3d.set_device(target, device)
                    self.assertEqual(values_in(target, names), values_of(device, names))

    def test_proxies(self):
        """A proxy of ParaView has properties, some with the names of the device's."""
        proxy = SimpleNamespace(Position=0, BeamSamples=1, RangeNoise=0.0)
        proxy.ListProperties = lambda: ["Position", "BeamSamples", "RangeNoise"]
        lms3d.set_device(proxy, "lms200-mm")
        self.assertEqual((proxy.Position, proxy.BeamSamples, proxy.RangeNoise), (0, 7, 0.005))
        self.assertIsInstance(proxy.BeamSamples, int)

    def test_an_unknown_device(self):
        with self.assertRaisesRegex(ValueError, "device must be one of ideal, lms200-mm, .*'LMS'"):
            lms3d.set_device(lms3d.vtkLMS3DScanFilter(), "LMS")


class TestArguments(unittest.TestCase):
    """The arguments of lms3d.scan reach the filters."""

    @classmethod
    def setUpClass(cls):
        cls.room = room()

    def filters(self, **arguments):
        """The filters of a call, with the arguments of their last update."""
        kept = []
        with mock.patch.object(scanning, "_update",
                               lambda algorithm, *_: kept.append(algorithm)), \
                mock.patch.object(scanning, "read_scan"):
            lms3d.scan(self.room, POSITION, **arguments)
        return kept

    def test_each_device_sets_its_properties(self):
        for device in lms3d.DEVICES:
            with self.subTest(device):
                sensor, *errors = self.filters(device=device)
                self.assertEqual(values_in(sensor, SENSOR), values_of(device, SENSOR))
                self.assertEqual(len(errors), device != "ideal")
                for filter_ in errors:
                    self.assertEqual(values_in(filter_, ERRORS), values_of(device, ERRORS))

    def test_an_argument_replaces_the_value_of_the_device(self):
        for name, value in OTHERS.items():
            with self.subTest(name):
                sensor, errors = self.filters(device="lms200-mm", **{name: value})
                values = {**values_in(sensor, SENSOR), **values_in(errors, ERRORS)}
                expected = {**values_of("lms200-mm", SENSOR + ERRORS), in_vtk(name): value}
                self.assertEqual(values, expected)

    def test_zero_replaces_it_too(self):
        (sensor,) = self.filters(device="lms200-mm", range_noise=0, range_resolution=0)
        self.assertEqual(values_in(sensor, SENSOR), values_of("lms200-mm", SENSOR))

    def test_the_rig_and_the_arrays(self):
        flags = {name: True for name in ARRAYS}
        (sensor,) = self.filters(**RIG, **flags)
        self.assertEqual(sensor.GetMounting(), MOUNTINGS["pitching"])
        self.assertEqual(sensor.GetAxisOffset(), RIG["axis_offset"])
        self.assertEqual(sensor.GetTurnRate(), 37.5)
        self.assertEqual(sensor.GetReflectanceArray(), "Color")
        for name in ARRAYS:
            self.assertTrue(getattr(sensor, f"Get{in_vtk(name)}")(), name)
            (plain,) = self.filters()
            self.assertFalse(getattr(plain, f"Get{in_vtk(name)}")(), name)

    def test_invalid_arguments(self):
        for text, arguments in {
            "device must be one of ideal, lms200-mm, lms200-cm, lms291": {"device": "lms"},
            "mounting must be one of yawing, yawing-top,": {"mounting": "Yawing"},
            "beam_diameter must be 0 or more": {"beam_diameter": -1},
            "beam_samples must be a whole number from 1 to 1000": {"beam_samples": 1001},
            "BeamDivergence": {"beam_divergence": 2.0},
            "pulse_length must be 0 or more": {"pulse_length": np.inf},
            "range_at_ten_percent must be a number": {"range_at_ten_percent": "x"},
            "axis_offset must be 3 finite numbers": {"axis_offset": 0.1},
            "turn_rate must be finite": {"turn_rate": np.nan},
            "motion_during_scan and start_time need a trajectory": {"motion_during_scan": True},
        }.items():
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                lms3d.scan(self.room, POSITION, **GRID, **arguments)

    def test_ranges_are_those_of_the_filters(self):
        scan = lms3d.scan(self.room, POSITION, **GRID, device="lms200-cm", seed=4)
        sensor, errors = lms3d.vtkLMS3DScanFilter(), lms3d.vtkLMS3DRangeErrorFilter()
        sensor.SetInputData(self.room)
        sensor.SetPosition(POSITION)
        for name, value in GRID.items():
            getattr(sensor, f"Set{in_vtk(name)}")(value)
        errors.SetInputConnection(sensor.GetOutputPort())
        errors.SetNoiseSeed(4)
        for target in (sensor, errors):
            target.SetDeviceToLMS200Centimetres()
        errors.Update()
        np.testing.assert_array_equal(
            scan.ranges.ravel(), array(errors.GetOutputDataObject(1), "Range"))
        steps = 100 * scan.ranges[np.isfinite(scan.ranges)]
        np.testing.assert_allclose(steps, np.round(steps), atol=1e-9)

    def test_the_ideal_device_changes_nothing(self):
        plain, ideal = (lms3d.scan(self.room, POSITION, **GRID, **more)
                        for more in ({}, {"device": "ideal", "seed": 5}))
        np.testing.assert_array_equal(plain.points, ideal.points)


if __name__ == "__main__":
    unittest.main()
