#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The interactive window: its size, its camera, and the keys that move and turn the sensor."""

import os
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonTransforms import vtkTransform

from lms3d.camera import level_axes, reframe
from lms3d.commands.demo import ROOM, simulate
from lms3d.viewer import Viewer

DATA = os.environ.get("LMS3D_DATA_DIR") or Path(__file__).resolve().parents[2] / "Data"

SIZE = (400, 160)
STEP = 0.25
TURN = 15.0
LETTER = 7.5  # pixels
BEAMS, TURNS = 31, 24  # a turn is as large as the turn of a key

_windows = []


def rotation(*turns):
    """The matrix of turns about the sensor's own axes, one after the other."""
    transform = vtkTransform()
    for degrees, axis in turns:
        transform.RotateWXYZ(degrees, *axis)
    return matrix(transform.GetMatrix())[:3, :3]


def matrix(elements):
    """A vtkMatrix4x4 as numpy."""
    return np.array([[elements.GetElement(i, j) for j in range(4)] for i in range(4)])


class WindowTest(unittest.TestCase):
    """A window on the room."""

    def setUp(self):
        self.simulation = simulate(ROOM, DATA, maximum_error=0.0)  # the map's vertices are returns
        self.simulation.sensor.SetAlphaResolution(BEAMS)
        self.simulation.sensor.SetBetaResolution(TURNS)
        self.open(SIZE)

    def open(self, size):
        """Open a window."""
        self.viewer = Viewer(self.simulation, size, step=STEP)
        self.viewer.refresh()
        self.window = self.viewer.interactor.GetRenderWindow()
        self.camera = self.window.GetRenderers().GetFirstRenderer().GetActiveCamera()
        # VTK 9.2 crashes if a second window is made after one was destroyed.
        _windows.append(self.viewer)

    def press(self, key, with_shift=False):
        """Press a key."""
        self.viewer.interactor.SetShiftKey(with_shift)
        self.viewer.interactor.SetKeySym(key)
        self.viewer.interactor.InvokeEvent("KeyPressEvent")

    def position(self):
        """Where the sensor is."""
        return np.array(self.simulation.sensor.GetPosition())

    def look(self, azimuth, elevation):
        """Look at the sensor from an azimuth and an elevation, degrees."""
        azimuth, elevation = np.radians((azimuth, elevation))
        towards = np.array((np.cos(elevation) * np.cos(azimuth),
                            np.cos(elevation) * np.sin(azimuth), np.sin(elevation)))
        self.camera.SetFocalPoint(self.position())
        self.camera.SetPosition(self.position() + 20 * towards)
        self.camera.SetViewUp(0, 0, 1)

    def project(self, points):
        """Where points are in the picture of a half, -1 to 1 to the right and up."""
        width, height = self.window.GetSize()
        projection = matrix(self.camera.GetCompositeProjectionTransformMatrix(
            0.5 * width / height, -1, 1))
        projected = np.column_stack((points, np.ones(len(points)))) @ projection.T
        return projected[:, :2] / projected[:, 3:]


class TestSize(WindowTest):
    """The window fits the screen, and the scene fits the window."""

    def scene_extent(self):
        """The largest distance of the scene from the middle of the picture; 1 is the border."""
        points = vtk_to_numpy(self.simulation.scene.surface.GetPoints().GetData())
        return np.abs(self.project(points)).max()

    def test_the_window_is_not_larger_than_the_screen(self):
        self.open((5000, 4000))
        for pixels, limit in zip(self.window.GetSize(), self.window.GetScreenSize()):
            self.assertGreater(pixels, 0.8 * limit)
            self.assertLess(pixels, limit)
        self.assertLess(self.scene_extent(), 1)

    def test_a_smaller_window_keeps_its_size(self):
        self.assertEqual(self.window.GetSize(), SIZE)

    def test_the_whole_scene_stays_in_view(self):
        for size in ((160, 400), (900, 200), (300, 300), SIZE):
            with self.subTest(size):
                self.viewer.interactor.UpdateSize(*size)
                self.assertEqual(self.window.GetSize(), size)
                self.assertLess(self.scene_extent(), 1)
                self.assertGreater(self.scene_extent(), 0.9)

    def test_the_whole_scene_stays_in_view_from_another_side(self):
        self.look(20, 70)
        self.camera.Dolly(0.5)
        self.assertLess(self.scene_extent(), 1)
        direction = self.camera.GetDirectionOfProjection()
        self.viewer.interactor.UpdateSize(160, 400)
        self.assertLess(self.scene_extent(), 1)
        np.testing.assert_allclose(self.camera.GetDirectionOfProjection(), direction, atol=1e-12)

    def test_the_zoom_comes_back(self):
        self.camera.Dolly(3)
        position = self.camera.GetPosition()
        self.viewer.interactor.UpdateSize(160, 400)
        self.assertGreater(np.linalg.norm(np.subtract(self.camera.GetPosition(), position)), 1)
        self.viewer.interactor.UpdateSize(*SIZE)
        np.testing.assert_allclose(self.camera.GetPosition(), position, atol=1e-9)

    def test_a_single_point_has_no_zoom(self):
        position = self.camera.GetPosition()
        reframe(self.camera, np.array([[1.0, 2.0, 3.0]]), 1.0, 2.0)
        self.assertEqual(self.camera.GetPosition(), position)

    def test_the_text_fits_the_window(self):
        parts = ("sensor 0.30  -0.20  1.00 m", "returns", "arrows", "x y z", "q: quit")
        for width in (400, 1000):
            with self.subTest(width):
                self.viewer.interactor.UpdateSize(width, 300)
                lines = self.viewer.text.splitlines()
                self.assertLess(max(map(len, lines)) * LETTER, width)
                for part in parts:
                    self.assertTrue(any(part in line for line in lines), part)
        self.assertLess(len(lines), 4)


class TestKeys(WindowTest):
    """The keys."""

    def test_keys_move_the_sensor_and_the_map_follows(self):
        start = np.array(ROOM.position)
        for key, move in {"Left": (-1, 0, 0), "Right": (1, 0, 0), "Down": (0, -1, 0),
                          "Up": (0, 1, 0), "Next": (0, 0, -1), "Prior": (0, 0, 1)}.items():
            with self.subTest(key):
                self.look(-90, 38)
                self.press(key)
                position = start + STEP * np.array(move)
                np.testing.assert_allclose(self.position(), position)
                self.assertAlmostEqual(self.simulation.ranges()[0], position[2], places=12)
                self.assertEqual(self.simulation.map.GetPointData().GetArray("Range").GetRange(),
                                 self.simulation.scan.GetPointData().GetArray("Range").GetRange())
                self.press("r")
                np.testing.assert_array_equal(self.position(), start)

    def test_arrows_follow_the_view(self):
        keys = {"Left": (-1, 0), "Right": (1, 0), "Down": (0, -1), "Up": (0, 1)}
        for azimuth in (-118, 0, 77, 180):
            for elevation in (85, 38, 5, -30):
                for key, direction in keys.items():
                    with self.subTest(key, azimuth=azimuth, elevation=elevation):
                        self.look(azimuth, elevation)
                        start = self.position()
                        self.press(key)
                        self.assertEqual(self.position()[2], start[2])
                        self.assertAlmostEqual(np.linalg.norm(self.position() - start), STEP)
                        shift = self.project([self.position()])[0]
                        np.testing.assert_allclose(shift / np.linalg.norm(shift), direction,
                                                   atol=1e-6)
                        self.press({"Left": "Right", "Right": "Left", "Down": "Up",
                                    "Up": "Down"}[key])

    def test_the_default_view_is_one_of_them(self):
        start = self.project([self.position()])[0]
        self.press("Right")
        shift = self.project([self.position()])[0] - start
        self.assertGreater(shift[0], 20 * abs(shift[1]))

    def test_at_eye_level_up_leads_away(self):
        self.look(77, 0)
        _, up = level_axes(self.camera)
        np.testing.assert_allclose(up, self.camera.GetDirectionOfProjection(), atol=1e-12)

    def test_a_rolled_camera(self):
        self.look(77, 0)
        self.camera.Roll(90)
        right, up = level_axes(self.camera)
        self.assertAlmostEqual(abs(self.camera.GetViewUp()[2]), 0)
        np.testing.assert_allclose(up, self.camera.GetViewUp(), atol=1e-12)
        self.assertAlmostEqual(right @ up, 0)

    def test_a_sensor_outside_sees_the_room_from_there(self):
        self.look(-90, 38)
        for _ in range(60):
            self.press("Left")
        self.assertLess(self.position()[0], -14)
        self.assertLess(self.simulation.returns, self.simulation.beams / 2)

    def test_keys_turn_the_sensor(self):
        """An upper case letter stands for a key with shift, which X11 names z and others Z."""
        x, y, z = np.eye(3)
        for keys, turns in {"x": [(TURN, x)], "Y": [(-TURN, y)], "zzZ": [(TURN, z)],
                            "xz": [(TURN, x), (TURN, z)], "yxX": [(TURN, y)]}.items():
            for change in (str.lower, str):
                with self.subTest(keys, change=change):
                    for key in keys:
                        self.press(change(key), key.isupper())
                    angles = self.simulation.sensor.GetOrientation()
                    np.testing.assert_allclose(
                        rotation((angles[2], z), (angles[0], x), (angles[1], y)),
                        rotation(*turns), atol=1e-12)
                    self.assertIn("{} {} {} degrees".format(*map(round, angles)), self.viewer.text)
                    self.press("r")
                    self.assertEqual(self.simulation.sensor.GetOrientation(), (0, 0, 0))
                    self.assertNotIn("degrees", self.viewer.text)

    def test_the_scan_turns_with_the_sensor(self):
        before = self.simulation.ranges().reshape(TURNS, BEAMS).copy()
        self.press("z")
        after = self.simulation.ranges().reshape(TURNS, BEAMS)
        self.assertGreater(np.isclose(after, np.roll(before, 1, axis=0)).mean(), 0.99)
        self.assertLess(np.isclose(after, before).mean(), 0.9)


class TestKeep(WindowTest):
    """The key that keeps what was seen."""

    def setUp(self):
        super().setUp()
        self.simulation.reconstruction.SetMaximumError(0.02)

    def shown(self):
        """The map in the right half."""
        right = list(self.window.GetRenderers())[1]
        mapper = right.GetActors().GetItemAsObject(0).GetMapper()
        mapper.Update()
        return mapper.GetInput()

    def kept(self):
        """The number of scans that the shown map has, None for a local map."""
        array = self.shown().GetFieldData().GetArray("NumberOfScans")
        return array and array.GetValue(0)

    def test_the_map_grows_with_each_pose(self):
        self.assertIsNone(self.kept())
        self.press("k")
        self.assertEqual(self.kept(), 1)
        sizes = [self.shown().GetNumberOfCells()]
        for number in range(2, 5):
            self.press("Left")
            self.assertEqual(self.kept(), number)
            self.assertIn(f"kept: {number} scans, {self.shown().GetNumberOfCells():,} triangles",
                          self.viewer.text)
            sizes.append(self.shown().GetNumberOfCells())
        self.assertGreater(sizes[-1], sizes[0])

    def test_a_pose_counts_once_until_the_sensor_moves(self):
        self.press("k")
        for _ in range(3):
            self.viewer.refresh()
        self.assertEqual(self.kept(), 1)

    def test_the_key_again_shows_the_local_map_alone(self):
        for key in ("k", "Left", "k"):
            self.press(key)
        self.assertIsNone(self.kept())
        self.assertEqual(self.shown().GetNumberOfCells(), self.simulation.map.GetNumberOfCells())
        self.assertNotIn("kept:", self.viewer.text)
        self.press("k")
        self.assertEqual(self.kept(), 1)

    def test_the_window_names_the_key(self):
        self.assertIn("k: keep what was seen", self.viewer.text)

    def test_a_map_without_a_bound_gives_a_reason(self):
        self.simulation.reconstruction.SetMaximumError(0)
        self.press("k")
        self.assertIn("MaximumError", self.viewer.text)
        self.assertEqual(self.shown().GetNumberOfCells(), 0)


if __name__ == "__main__":
    unittest.main()
