#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of one scan twice: ideal, and as a device reports it. Needs a display."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

import lms3d
from command_line import DATA, POSITION, ROOM, array
from lms3d.commands.demo import ROOM as EXPERIMENT
from lms3d.commands.demo import report, simulate
from lms3d.device_figure import DeviceFigure, range_errors
from lms3d.scene import read_scene
from lms3d.simulation import Simulation

SIZE = (800, 310)


class Reported:
    """A coarse scan of the room, and the same with changed ranges."""

    def __init__(self, **errors):
        self.simulation = Simulation(read_scene(ROOM))
        self.simulation.sensor.SetPosition(POSITION)
        self.simulation.sensor.SurfaceAttributesOn()
        self.simulation.run()
        self.filter = lms3d.vtkLMS3DRangeErrorFilter()
        self.filter.SetInputConnection(self.simulation.sensor.GetOutputPort())
        for name, value in errors.items():
            getattr(self.filter, f"Set{name}")(value)
        self.filter.Update()
        self.scan = self.filter.GetOutput()

    def picture(self):
        """Pixels: rows from below, columns, channels."""
        image = DeviceFigure(self.simulation, self.scan, "device", SIZE).image()
        width, height, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3).astype(int)


def count(pixels, is_color):
    """Pixels above the legend that have a colour."""
    red, green, blue = np.moveaxis(pixels[60:], 2, 0)
    return is_color(red, green, blue).sum()


def is_reddish(red, green, blue):
    return (red > green + 60) & (red > blue + 60)


def is_bluish(red, green, blue):
    return (blue > red + 60) & (blue > green + 40)


def is_purple(red, green, blue):
    return (red > green + 60) & (blue > green + 50)


class TestErrors(unittest.TestCase):
    """The errors of reported ranges."""

    def test_a_bias(self):
        reported = Reported(RangeBias=0.25)
        np.testing.assert_allclose(
            range_errors(reported.simulation.scan, reported.scan), 0.25, atol=1e-14)

    def test_lost_returns(self):
        reported = Reported(RangeBias=-2.0)
        errors = range_errors(reported.simulation.scan, reported.scan)
        self.assertLess(len(errors), reported.simulation.returns)
        np.testing.assert_allclose(errors, -2, atol=1e-14)
        # An ideal scan without some of the reported returns.
        backwards = range_errors(reported.scan, reported.simulation.scan)
        self.assertEqual(np.isnan(backwards).sum(), reported.simulation.returns - len(errors))

    def test_the_demo_leaves_an_ideal_sensor(self):
        simulation = simulate(EXPERIMENT, DATA)
        before = array(simulation.scan, "Range").copy()
        reported = report(simulation)
        np.testing.assert_array_equal(array(simulation.scan, "Range"), before)
        self.assertGreater((array(reported, "RangeError") != 0).mean(), 0.9)


class TestPicture(unittest.TestCase):
    """Colours show the errors."""

    def halves(self, **errors):
        pixels = Reported(**errors).picture()
        return pixels[:, :SIZE[0] // 2], pixels[:, SIZE[0] // 2:]

    def test_colours(self):
        for bias, is_color in ((0.02, is_reddish), (-0.02, is_bluish), (0.1, is_purple),
                               (-0.1, is_purple)):
            with self.subTest(bias):
                _, right = self.halves(RangeBias=bias)
                self.assertGreater(count(right, is_color), 8000)

    def test_the_ideal_half_is_blue_without_errors(self):
        left, right = self.halves()
        self.assertGreater(count(left, is_bluish), 8000)
        for is_color in (is_reddish, is_purple):
            self.assertLess(count(right, is_color), 1000)  # the sensor's own marker

    def test_the_ceiling_is_not_drawn(self):
        reported = Reported()
        figure = DeviceFigure(reported.simulation, reported.scan, "device", SIZE)
        drawn = [actor.GetMapper().GetInput() for actor in
                 figure.window.GetRenderers().GetFirstRenderer().GetActors()
                 if isinstance(actor.GetMapper().GetInput(), vtkPolyData)
                 and actor.GetMapper().GetInput().GetNumberOfVerts() > 0]
        self.assertEqual(len(drawn), 1)
        heights = vtk_to_numpy(drawn[0].GetPoints().GetData())[:, 2]
        self.assertTrue(0.2 < len(heights) / reported.simulation.returns < 0.8)
        self.assertLess((heights > 2.999).mean(), 0.01)


if __name__ == "__main__":
    unittest.main()
