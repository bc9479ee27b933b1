#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Figures 5 and 6, and their maps' triangles, compared with reviewed pictures; and their
numbers.

The baselines are in the folder LMS3D_BASELINE_DIR, by default in ../Data/Baseline. They are made
and compared with Mesa's llvmpipe. After an intended change, write new baselines and review them:

    xvfb-run -a -s "-noreset -screen 0 1280x1024x24" ./run python \\
        Testing/Python/TestFigures.py --write-baselines
"""

import os
import sys
import tempfile
import unittest
from dataclasses import replace
from pathlib import Path

from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader

from lms3d.commands.demo import ROOM, TEAPOT, simulate
from lms3d.figure import Figure
from lms3d.results import save

HERE = Path(__file__).resolve().parent
DATA = os.environ.get("LMS3D_DATA_DIR") or HERE.parents[1] / "Data"
BASELINES = Path(os.environ.get("LMS3D_BASELINE_DIR") or HERE.parent / "Data" / "Baseline")
OUTPUT = Path(os.environ.get("LMS3D_TEST_OUTPUT_DIR") or tempfile.gettempdir())

SIZE = (800, 310)

# A pixel counts if a channel differs by more than THRESHOLD; ALLOWED bounds the sum.
THRESHOLD = 16
ALLOWED = 50

FIGURES = {"Figure5": ROOM, "Figure6": TEAPOT}

# Maps within the bound of their experiment, and plain grids: bound, and zoom to show the triangles.
TRIANGLES = {"RoomMap": (ROOM, None, 1.0), "RoomGrid": (ROOM, 0.0, 4.0),
             "TeapotMap": (TEAPOT, None, 1.0), "TeapotGrid": (TEAPOT, 0.0, 10.0)}

# Triangles of the plain grids, and of a plain grid without depth steps.
ROOM_GRID, TEAPOT_GRID, CLOSED_GRID = 254833, 119147, 258480


def draw(simulation):
    """The figure of a simulation in the size of the baselines."""
    return Figure(simulation, SIZE).image()


def draw_triangles(experiment, maximum_error, zoom):
    """The middle of a figure, with the edges of the map's triangles."""
    figure = Figure(simulate(experiment, DATA, maximum_error), SIZE, edges=True)
    figure.camera.Zoom(zoom)
    return figure.image()


def difference(image, baseline):
    """The strict difference of two pictures, as a number and as a picture."""
    compare = vtkImageDifference()
    compare.SetInputData(image)
    compare.SetImageData(baseline)
    compare.SetThreshold(THRESHOLD)
    compare.AllowShiftOff()
    compare.AveragingOff()
    compare.Update()
    return compare.GetThresholdedError(), compare.GetOutput()


def load_baselines(name):
    """The baselines: NAME.png, and NAME_1.png and so on for other drivers."""
    pictures = []
    for path in sorted(BASELINES.glob(f"{name}*.png")):
        reader = vtkPNGReader()
        reader.SetFileName(str(path))
        reader.Update()
        pictures.append(reader.GetOutput())
    return pictures


class FigureTest(unittest.TestCase):
    """Compares a picture with its baseline; writes it and the difference if they differ."""

    def check_picture(self, name, image):
        """Expect a strict match with one of the baselines of that name."""
        baselines = load_baselines(name)
        for baseline in baselines:
            self.assertEqual(image.GetDimensions(), baseline.GetDimensions())
        error, picture = min((difference(image, baseline) for baseline in baselines),
                             key=lambda result: result[0])
        if error > ALLOWED:
            save(image, OUTPUT / f"{name}.png")
            save(picture, OUTPUT / f"{name}.difference.png")
        self.assertLessEqual(error, ALLOWED, f"see {name}.difference.png in {OUTPUT}")


class TestFigure5(FigureTest):
    """The room."""

    @classmethod
    def setUpClass(cls):
        cls.simulation = simulate(ROOM, DATA)

    def test_numbers(self):
        self.assertEqual(self.simulation.scene.triangles, 804)
        self.assertEqual(self.simulation.beams, 361 * 360)
        self.assertEqual(self.simulation.returns, self.simulation.beams)
        self.assertLess(self.simulation.map.GetNumberOfCells(), 0.008 * CLOSED_GRID)
        ranges = self.simulation.ranges()
        self.assertAlmostEqual(ranges[0], 1.0, places=12)
        self.assertAlmostEqual(ranges[360], 2.0, places=12)
        self.assertAlmostEqual(ranges.max(), 7.199, places=3)

    def test_picture(self):
        self.check_picture("Figure5", draw(self.simulation))

    def test_the_comparison_sees_a_centimetre(self):
        x, y, z = ROOM.position
        self.simulation.sensor.SetPosition(x + 0.01, y, z)
        self.simulation.run()
        moved = draw(self.simulation)
        self.simulation.sensor.SetPosition(ROOM.position)
        self.simulation.run()
        self.assertGreater(difference(moved, load_baselines("Figure5")[0])[0], 2 * ALLOWED)


class TestFigure6(FigureTest):
    """The teapot."""

    @classmethod
    def setUpClass(cls):
        cls.simulation = simulate(TEAPOT, DATA)

    def test_numbers(self):
        self.assertEqual(self.simulation.scene.triangles, 3080)
        self.assertEqual(self.simulation.beams, 401 * 701)
        self.assertEqual(self.simulation.returns, 60340)
        self.assertLess(self.simulation.map.GetNumberOfCells(), 0.1 * TEAPOT_GRID)
        ranges = self.simulation.ranges()
        self.assertAlmostEqual(ranges.min(), 0.3559, places=4)
        self.assertAlmostEqual(ranges.max(), 0.4998, places=4)

    def test_picture(self):
        self.check_picture("Figure6", draw(self.simulation))


class TestTriangles(FigureTest):
    """The triangles of maps and of plain grids."""

    def test_pictures(self):
        for name, experiment in TRIANGLES.items():
            with self.subTest(name):
                self.check_picture(name, draw_triangles(*experiment))

    def test_numbers_of_the_plain_grids(self):
        for experiment, expected in ((ROOM, ROOM_GRID), (TEAPOT, TEAPOT_GRID)):
            with self.subTest(experiment.name):
                grid = simulate(experiment, DATA, maximum_error=0.0)
                self.assertEqual(grid.map.GetNumberOfCells(), expected)

    def test_a_return_beside_its_patch_needs_a_few_triangles(self):
        """One of 52,255 returns on the floor is 1e-5 rad outside their common outline."""
        beside = replace(ROOM, position=(0.2, 0.0, 1.0), maximum_error=0.01)
        self.assertLess(simulate(beside, DATA).map.GetNumberOfCells(), 2000)


def write_baselines():
    """Draw all figures and write them as baselines."""
    BASELINES.mkdir(parents=True, exist_ok=True)
    for name, experiment in FIGURES.items():
        _write_baseline(name, draw(simulate(experiment, DATA)))
    for name, experiment in TRIANGLES.items():
        _write_baseline(name, draw_triangles(*experiment))


def _write_baseline(name, image):
    save(image, BASELINES / f"{name}.png")
    print(f"wrote {BASELINES / name}.png")


if __name__ == "__main__":
    if sys.argv[1:] == ["--write-baselines"]:
        write_baselines()
    else:
        unittest.main()
