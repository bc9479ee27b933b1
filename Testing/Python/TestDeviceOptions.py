#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The options of the command line for a device and its platform."""

import inspect
import unittest
from unittest import mock

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import lms3d
from command_line import COARSE, POSE, POSITION, ROOM, CommandLineTest, array, read, room, run
from device_cases import ERRORS, GRID, OTHERS, SENSOR, in_vtk, values_in, values_of
from lms3d.cli import build_parser
from lms3d.commands import device_options
from lms3d.properties import MOUNTINGS
from lms3d.simulation import Simulation


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
        for option, value, needed in (("--beam-diameter", 0.01, "--beam-samples"),
                                      ("--beam-divergence", 0.01, "--beam-samples"),
                                      ("--reflectance", "Color", "--range-at-ten-percent")):
            with self.subTest(option):
                words = self.refused(2, "scan", ROOM, *POSE, option, value, "-o", csv)
                self.assertIn(option, words)
                self.assertIn(needed, words)
        self.assertIn("--device: the server has its own sensor", self.refused(
            2, "view", "--server", "corbaloc::x/y", "--device", "lms200-mm"))
        self.assertIn("--mounting: needs --position", self.refused(
            2, "compare", ROOM, ROOM, "--mounting", "rolling"))

    def test_options_that_have_what_they_need(self):
        for words in (("--beam-diameter", 0.01, "--beam-samples", 7), ("--beam-diameter", 0),
                      ("--beam-divergence", 0.01, "--device", "lms291"),
                      ("--reflectance", "Color", "--device", "lms200-mm"),
                      ("--reflectance", "Color", "--range-at-ten-percent", 5),
                      ("--reflectance", "Color", "--intensity")):
            with self.subTest(words):
                device_options.check(self.options(*words))

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


class TestAdvice(unittest.TestCase):
    """lms3d advise for a real device."""

    def test_trials_have_the_errors_and_the_command_has_the_device(self):
        words = run("advise", ROOM, *POSE, "--tolerance", 0.1, "--share", 0.5, "--device",
                    "lms200-mm", "--seed", 3, "--range-noise", 0.002)
        self.assertEqual(words.returncode, 0, words.stderr)
        self.assertIn(" --device lms200-mm --range-noise 0.002 --seed 3 ", words.stdout)


if __name__ == "__main__":
    unittest.main()
