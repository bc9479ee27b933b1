#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Devices: the arguments of lms3d.scan, lms3d.set_device, and the options of the command line."""

import inspect
import unittest
from types import SimpleNamespace
from unittest import mock

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import lms3d
from command_line import COARSE, POSE, POSITION, ROOM, CommandLineTest, array, read, room, run
from lms3d import scanning
from lms3d.cli import build_parser
from lms3d.commands import device_options
from lms3d.properties import MOUNTINGS
from lms3d.simulation import Simulation

GRID = {"alpha_range": (-60, 60), "alpha_resolution": 31, "beta_resolution": 24}
SENSOR = ("MaximumRange", "BeamDiameter", "BeamDivergence", "BeamSamples", "PulseLength",
          "RangeAtTenPercent")
ERRORS = ("RangeBias", "RangeNoise", "RangeResolution")

# A value of each argument that no device has.
OTHERS = {"maximum_range": 7.0, "beam_diameter": 0.1, "beam_divergence": 0.2, "beam_samples": 13,
          "pulse_length": 0.5, "range_at_ten_percent": 5.0, "range_bias": 0.1, "range_noise": 0.2,
          "range_resolution": 0.3}
RIG = {"mounting": "pitching", "axis_offset": (0.1, 0.2, 0.3), "turn_rate": 37.5,
       "reflectance": "Color"}
ARRAYS = ("incidence", "intensity", "time", "status", "poses")


def in_vtk(name):
    """The property of an argument."""
    return {"reflectance": "ReflectanceArray", "seed": "NoiseSeed"}.get(
        name, f"Compute{name.title()}" if name in ARRAYS else name.title().replace("_", ""))


def values_of(device, names):
    """The values that a device gives to properties."""
    number = lms3d.DEVICES[device]
    return {name: lms3d.vtkLMS3DScanFilter.GetDeviceValue(number, name) for name in names}


def values_in(target, names):
    """The values of properties of a filter."""
    return {name: getattr(target, f"Get{name}")() for name in names}


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


class TestOptions(CommandLineTest):
    """The options of the command line reach the filters."""

    def options(self, *words, command="scan"):
        return build_parser().parse_args(
            [command, str(ROOM), *map(str, POSE), *(["-o", "-"] if command == "scan" else []),
             *map(str, words)])

    def simulation(self, *words, **more):
        simulation = Simulation(mock.Mock(data=room()))
        device_options.apply(simulation, self.options(*words, **more))
        return simulation

    def test_each_device_sets_its_properties(self):
        for device in lms3d.DEVICES:
            for command in ("scan", "view"):
                with self.subTest(device, command=command):
                    simulation = self.simulation("--device", device, command=command)
                    self.assertEqual(values_in(simulation.sensor, SENSOR),
                                     values_of(device, SENSOR))
                    self.assertEqual(simulation.errors is None, device == "ideal")
                    if simulation.errors:
                        self.assertEqual(values_in(simulation.errors, ERRORS),
                                         values_of(device, ERRORS))

    def test_an_option_replaces_the_value_of_the_device(self):
        for name, value in OTHERS.items():
            with self.subTest(name):
                option = "--" + name.replace("_", "-")
                simulation = self.simulation("--device", "lms200-mm", option, value)
                values = {**values_in(simulation.sensor, SENSOR),
                          **values_in(simulation.errors, ERRORS)}
                self.assertEqual(
                    values, {**values_of("lms200-mm", SENSOR + ERRORS), in_vtk(name): value})

    def test_the_rig(self):
        sensor = self.simulation("--mounting", "pitching", "--axis-offset", 0.1, 0.2, 0.3,
                                 "--turn-rate", 37.5, "--reflectance", "Color").sensor
        self.assertEqual(
            (sensor.GetMounting(), sensor.GetAxisOffset(), sensor.GetTurnRate(),
             sensor.GetReflectanceArray()),
            (MOUNTINGS["pitching"], (0.1, 0.2, 0.3), 37.5, "Color"))

    def test_a_scan_is_that_of_python(self):
        self.done("scan", ROOM, *POSE, *COARSE, "--device", "lms200-mm", "--seed", 1,
                  "-o", self.folder / "scan.vtp")
        scan = read(vtkXMLPolyDataReader(), self.folder / "scan.vtp")
        expected = lms3d.scan(room(), POSITION, **GRID, device="lms200-mm", seed=1)
        np.testing.assert_array_equal(array(scan, "Range"), array(expected.poly, "Range"))

    def test_the_words_of_a_command_repeat_it(self):
        words = ["--device", "lms200-mm", "--beam-samples", "19", "--reflectance", "Color",
                 "--range-bias", "-0.01", "--seed", "3", "--mounting", "rolling",
                 "--axis-offset", "0.1", "0", "-0.2", "--turn-rate", "37.5"]
        self.assertEqual(device_options.given(self.options(
            *(f" {word}" if word[:2] == "-0" else word for word in words))), words)
        self.assertEqual(device_options.given(self.options()), [])

    def test_invalid_options(self):
        path = self.folder / "scan.vtp"
        for option, value in (("--device", "lms"), ("--beam-diameter", -1), ("--beam-samples", 0),
                              ("--beam-samples", 1001), ("--beam-divergence", 1.5),
                              ("--pulse-length", "nan"), ("--range-at-ten-percent", -1),
                              ("--mounting", "up"), ("--turn-rate", "inf")):
            with self.subTest(option, value=value):
                self.assertIn(option, self.refused(2, "scan", ROOM, *POSE, option, value, "-o", path))

    def test_options_that_need_others(self):
        csv, image = self.folder / "scan.csv", self.folder / "image.vti"
        for option, output in (("--motion-during-scan", ("-o", csv)), ("--poses", ("-o", csv)),
                               ("--status", ("-o", csv)), ("--time", ("--range-image", image))):
            with self.subTest(option):
                self.assertIn(option, self.refused(2, "scan", ROOM, *POSE, option, *output))
        self.assertIn("--device: the server has its own sensor", self.refused(
            2, "view", "--server", "corbaloc::x/y", "--device", "lms200-mm"))
        self.assertIn("--mounting: needs --position", self.refused(
            2, "compare", ROOM, ROOM, "--mounting", "rolling"))

    def test_the_help_has_units_and_defaults(self):
        words = " ".join(run("scan", "--help", COLUMNS="1000").stdout.split())
        for option, unit in (("beam-diameter M", "metres"), ("beam-divergence D", "metres for each"),
                             ("pulse-length M", "metres"), ("range-at-ten-percent M", "metres"),
                             ("axis-offset X Y Z", "metres"), ("turn-rate DEG", "degrees a second")):
            self.assertRegex(words, rf"--{option} {unit}")
        self.assertEqual(words.count("default: the device's; ideal: "), 6)
        for name in inspect.signature(lms3d.scan).parameters:
            if name not in ("mesh", "start_time"):
                self.assertIn("--" + name.replace("_", "-"), words)


if __name__ == "__main__":
    unittest.main()
