#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A sensor that moves while the emulator's platform turns steadily."""

import time
import unittest

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import lms3d
from command_line import POSITION, CommandLineTest, room, write
from emulator_process import EmulatorProcess, PortHost
from lms3d.emulation.fans import LiveFans
from lms3d.emulation.poses import interpolate_poses
from lms3d.emulation.variants import Variant
from lms3d.motion import to_trajectory
from lms3d.problems import Problem

TIMES = np.array((2.0, 4.0))
POSITIONS = np.array((POSITION, POSITION + (0.4, 0.2, 0.3)))
TURN = 1 / 75
NOTHING = (0.0, 0.0, 0.0)


def no_check():
    """All VTK calls succeed."""


def about_z(degrees):
    """A quaternion w, x, y, z."""
    half = np.radians(degrees) / 2
    return np.cos(half), 0.0, 0.0, np.sin(half)


class TestPoses(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = room()

    def cast(self, sensor, seconds, times=()):
        """The beams of a part that is measured at a time after the start."""
        sensor.SetInputDataObject(self.scene)
        return LiveFans(sensor, no_check, None, times).cast_part(Variant(), 1, 30.0, seconds, 1)

    def cast_at(self, share, angle):
        """The same at rest, at a share of the way."""
        sensor = lms3d.vtkLMS3DScanFilter()
        sensor.SetPosition(POSITIONS[0] + share * (POSITIONS[1] - POSITIONS[0]))
        sensor.SetOrientation(0.0, 0.0, angle)
        return self.cast(sensor, 0.0)

    def cast_moving(self, trajectory, seconds, orientation=NOTHING):
        sensor = lms3d.vtkLMS3DScanFilter()
        sensor.SetTrajectoryData(interpolate_poses(trajectory, orientation, TIMES))
        return self.cast(sensor, seconds, tuple(TIMES))

    def test_between_two_poses(self):
        """Positions and angles change evenly; the last pose stays."""
        trajectory = to_trajectory((TIMES, POSITIONS, np.array((about_z(0), about_z(80)))))
        self.assertGreater(np.nanmax(np.abs(self.cast_at(0.5, 40) - self.cast_at(0, 0))), 0.1)
        for turn in (0, 1, 37, 75, 149, 150, 1000):
            share = min(turn * TURN / 2.0, 1.0)
            for rounding in (-1e-9, 0.0, 1e-9):
                np.testing.assert_allclose(
                    self.cast_moving(trajectory, turn * TURN + rounding),
                    self.cast_at(share, 80 * share), rtol=1e-9)

    def test_the_orientation_of_the_sensor(self):
        """It is that of a trajectory that has positions alone."""
        trajectory = to_trajectory((TIMES, POSITIONS))
        np.testing.assert_allclose(self.cast_moving(trajectory, 1.0, (0.0, 0.0, 25.0)),
                                   self.cast_at(0.5, 25), rtol=1e-9)

    def test_one_pose(self):
        trajectory = to_trajectory((TIMES[:1], POSITIONS[:1]))
        poses = interpolate_poses(trajectory, NOTHING, TIMES[:1])
        np.testing.assert_allclose(poses.GetPoint(0), POSITION)
        self.assertEqual(poses.GetNumberOfPoints(), 1)

    def test_a_long_trajectory(self):
        for seconds in (3601.0, 1e300):
            times = np.array((0.0, seconds))
            with self.assertRaisesRegex(Problem, "with --turn RATE it may take 3600 s"):
                interpolate_poses(to_trajectory((times, POSITIONS)), NOTHING, times)


class TestMovingEmulator(CommandLineTest):
    def test_a_wall(self):
        """A sensor that moves towards a wall, 0.4 m/s: ranges are shorter by the way in the time."""
        scene, path, angles = (self.folder / name for name in ("wall.obj", "path.vtp", "angles.csv"))
        scene.write_text("v 7 -99 -99\nv 7 99 -99\nv 7 0 99\nf 1 2 3\n")
        write(vtkXMLPolyDataWriter(), to_trajectory(
            (np.array((0.0, 15.0)), np.array(((0.0, 0.0, 0.0), (6.0, 0.0, 0.0))))), path)
        ranges = []
        with EmulatorProcess(scene, "--trajectory", path, "--turn", 0,
                             "--angles", angles) as emulator, PortHost(emulator.port) as host:
            for _ in range(10):
                middle = host.ask(0x30, 1)[3 + 2 * 180:][:2]
                ranges.append(int.from_bytes(middle, "little") / 1000)
                time.sleep(0.1)
        times = np.loadtxt(angles, delimiter=",", skiprows=1)[:, 2]
        self.assertGreater(ranges[0] - ranges[-1], 0.3)
        np.testing.assert_allclose(np.diff(ranges), -0.4 * np.diff(times), atol=1.01e-3)


if __name__ == "__main__":
    unittest.main()
