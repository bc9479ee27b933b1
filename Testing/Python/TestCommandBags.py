#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""ROS 2 bags. rosbags reads both storages; mcap-ros2-support reads MCAP a second time.

The laws of the device: its mirror turns 75 times a second, and sends a beam at each degree.
"""

import os
import shutil
import tempfile
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from bag_pieces import (
    BagTest,
    cloud_points,
    matrix,
    read_with_mcap,
    read_with_rosbags,
    select,
    stamp,
)
from command_line import COARSE, POSE, ROOM, CommandLineTest, array, field, points, read, run
from optional_libraries import needs

MIRROR = 10**9 / 75  # nanoseconds
BEAM_TIME = 1 / (360 * 75)  # seconds
TURNS, BEAMS = 7, 361
FINE = ("--orientation", 10, -20, 30, "--maximum-range", 2.5, "--beta-resolution", TURNS)
JOURNEY = ROOM.parent / "journey.vtp"


@needs("rosbags", "mcap_ros2")
class TestScan(BagTest):
    """A scan of half degrees from a turned sensor."""

    def test_folders(self):
        for ending in ("db3", "mcap"):
            with self.subTest(ending):
                self.scanned(f"files.{ending}", *FINE)
                folder = self.folder / f"files.{ending}"
                self.assertEqual(sorted(path.name for path in folder.iterdir()),
                                 [f"files.{ending}", "metadata.yaml"])
                for path in folder.iterdir():
                    self.assertNotIn(str(self.folder).encode(), path.read_bytes())

    def test_readers_agree(self):
        first, _ = self.scanned("fine.mcap", *FINE)
        for other in (read_with_mcap(self.folder / "fine.mcap"),
                      self.scanned("fine.db3", *FINE)[0]):
            self.assertEqual([each[:2] for each in first], [each[:2] for each in other])
            for (topic, _, a), (_, _, b) in zip(first, other):
                if topic == "/tf":
                    np.testing.assert_array_equal(self.chain(a), self.chain(b))
                    continue
                self.assertEqual(stamp(a.header), stamp(b.header))
                self.assertEqual(a.header.frame_id, b.header.frame_id)
                if topic == "/points":
                    np.testing.assert_array_equal(cloud_points(a), cloud_points(b))
                    continue
                for name in ("ranges", "angle_min", "angle_max", "time_increment", "range_max"):
                    np.testing.assert_array_equal(getattr(a, name), getattr(b, name))

    def test_times_increase(self):
        messages, _ = self.scanned("fine.mcap", *FINE)
        times = [time for _, time, _ in messages]
        self.assertEqual(times, sorted(times))
        self.assertEqual(times[0], 0)

    def test_a_fan_is_two_turns_of_the_mirror(self):
        messages, scan = self.scanned("fine.mcap", *FINE)
        ranges = np.full(BEAMS * TURNS, np.inf)
        ranges[array(scan, "BeamId")] = array(scan, "Range")
        ranges = ranges.astype(np.float32).reshape(TURNS, BEAMS)
        scans = select(messages, "/scan")
        self.assertEqual(len(scans), 2 * TURNS)
        for i, message in enumerate(scans):
            turn, half = divmod(i, 2)
            np.testing.assert_array_equal(message.ranges, ranges[turn, half::2])
            self.assertAlmostEqual(stamp(message.header), i * MIRROR, delta=2)
            self.assertEqual(message.header.frame_id, "laser")
            first, last = np.radians((-90 + half / 2, 90 - half / 2))
            for name, value in (("angle_min", first), ("angle_max", last),
                                ("angle_increment", np.radians(1)), ("time_increment", BEAM_TIME),
                                ("scan_time", 1 / 75), ("range_min", 0), ("range_max", 2.5)):
                self.assertAlmostEqual(getattr(message, name), value, delta=1e-6 * abs(value))

    def test_scans_and_transforms_give_the_points(self):
        messages, scan = self.scanned("fine.mcap", *FINE)
        found = []
        for message in select(messages, "/scan"):
            ranges = np.asarray(message.ranges, float)
            angles = message.angle_min + message.angle_increment * np.arange(len(ranges))
            pose = self.pose_of_fan(messages, stamp(message.header))
            # With a lookup for the last beam, as tools do that correct the motion of the sensor.
            duration = message.time_increment * (len(ranges) - 1)
            last = self.pose_of_fan(messages, stamp(message.header) + int(1e9 * duration))
            np.testing.assert_array_equal(pose, last)
            is_return = np.isfinite(ranges)
            local = np.stack((np.cos(angles), np.sin(angles), 0 * angles)) * np.where(
                is_return, ranges, 0)
            found.append((pose[:3, :3] @ local + pose[:3, 3:]).T[is_return])
        grid = self._on_grid(scan).reshape(TURNS, BEAMS, 3)
        expected = [grid[turn, half::2] for turn in range(TURNS) for half in range(2)]
        expected = [part[~np.isnan(part[:, 0])] for part in expected]
        np.testing.assert_allclose(np.concatenate(found), np.concatenate(expected), atol=3e-6)

    @staticmethod
    def _on_grid(scan):
        grid = np.full((BEAMS * TURNS, 3), np.nan)
        grid[array(scan, "BeamId")] = points(scan)
        return grid

    def test_the_cloud_is_organised(self):
        messages, scan = self.scanned("fine.mcap", *FINE)
        (cloud,) = select(messages, "/points")
        self.assertEqual((cloud.height, cloud.width, cloud.point_step, cloud.row_step),
                         (TURNS, BEAMS, 12, 12 * BEAMS))
        self.assertFalse(cloud.is_dense)
        self.assertEqual(cloud.header.frame_id, "sensor")
        times = [stamp(pose.transforms[0].header) for pose in select(messages, "/tf")]
        self.assertEqual(stamp(cloud.header), times[-1])
        pose = matrix(select(messages, "/tf")[-1].transforms[0].transform)
        np.testing.assert_allclose(pose.ravel(), field(scan, "SensorToWorld"), atol=1e-15)
        local = cloud_points(cloud).reshape(-1, 3).astype(float)
        np.testing.assert_allclose(local @ pose[:3, :3].T + pose[:3, 3], self._on_grid(scan),
                                   atol=1e-6)

    def test_other_fans(self):
        """Whole degrees take one turn of the mirror, quarters take four."""
        for beams, turns, increment in ((181, 1, 1), (721, 4, 1), (91, 1, 2)):
            with self.subTest(beams):
                messages, _ = self.scanned(f"{beams}.mcap", "--alpha-resolution", beams,
                                           "--beta-resolution", 3)
                scans = select(messages, "/scan")
                self.assertEqual(len(scans), 3 * turns)
                self.assertEqual(sum(len(each.ranges) for each in scans), 3 * beams)
                for i, message in enumerate(scans):
                    self.assertAlmostEqual(stamp(message.header), i * MIRROR, delta=2)
                    self.assertAlmostEqual(message.angle_increment, np.radians(increment), 6)
                    self.assertAlmostEqual(message.time_increment, increment * BEAM_TIME, 9)

    def test_other_platforms(self):
        """The first and the last beam of each fan hit their points with the transforms of their times."""
        for mounting in ("yawing", "yawing-top", "pitching", "rolling"):
            with self.subTest(mounting):
                messages, scan = self.scanned(
                    f"{mounting}.mcap", "--mounting", mounting, "--axis-offset", 0.1, -0.05, 0.2,
                    "--turn-rate", 20, "--beta-resolution", TURNS)
                poses = [self.chain(pose) for pose in select(messages, "/tf")]
                scans = select(messages, "/scan")
                grid = self._on_grid(scan).reshape(TURNS, BEAMS, 3)
                for turn in range(TURNS):
                    first, last = scans[2 * turn], scans[2 * turn + 1]
                    for pose, angle, distance, expected in (
                            (poses[2 * turn], first.angle_min, first.ranges[0], grid[turn, 0]),
                            (poses[2 * turn + 1], last.angle_max, last.ranges[-1], grid[turn, -2])):
                        local = distance * np.array((np.cos(angle), np.sin(angle), 0))
                        np.testing.assert_allclose(pose[:3, :3] @ local + pose[:3, 3], expected,
                                                   atol=1e-4)

    def test_beams_without_a_return(self):
        """They are infinite only if certainly no surface is within the ranges."""
        for name, options, expected in (
                ("beyond", (), np.inf), ("near", ("--minimum-range", 0.5), np.nan),
                ("dark", ("--range-at-ten-percent", 0.5), np.nan),
                ("lost", ("--range-bias", -2, "--maximum-range", 9), np.nan)):
            with self.subTest(name):
                messages, _ = self.scanned(f"{name}.mcap", *COARSE, *FINE[4:6], *options)
                ranges = np.concatenate([each.ranges for each in select(messages, "/scan")])
                missing = ranges[~np.isfinite(ranges)]
                self.assertGreater(len(missing), 0)
                np.testing.assert_array_equal(missing, np.full_like(missing, expected))


@needs("rosbags", "mcap_ros2")
class TestJourney(BagTest):
    """One bag for all scans of a trajectory."""

    def scan_journey(self, name, trajectory=JOURNEY, more=()):
        bag = self.folder / name
        words = self.done("scan", ROOM, "--trajectory", trajectory, *COARSE, "-o", bag, *more)
        return words, read_with_rosbags(bag)

    def test_journey(self):
        words, messages = self.scan_journey("journey.mcap",
                                            more=("--map", self.folder / "journey.pvd"))
        self.assertIn("wrote    ", words)
        self.assertNotIn("begin after", words)
        clouds = select(messages, "/points")
        path = read(vtkXMLPolyDataReader(), JOURNEY)
        self.assertEqual(len(clouds), path.GetNumberOfPoints())
        self.assertTrue((self.folder / "journey_0016.vtp").exists())
        for step, (cloud, position) in enumerate(zip(clouds, points(path))):
            end = stamp(cloud.header)
            self.assertTrue(step * 10**9 < end < (step + 1) * 10**9)
            pose = next(each for each in reversed(select(messages, "/tf"))
                        if stamp(each.transforms[0].header) == end).transforms[0].transform
            np.testing.assert_array_equal(matrix(pose)[:3, 3], position)
        first = [stamp(each.header) for each in select(messages, "/scan")][::len(
            select(messages, "/scan")) // len(clouds)]
        self.assertEqual(first, [step * 10**9 for step in range(len(clouds))])
        times = [time for _, time, _ in messages]
        self.assertEqual(times, sorted(times))

    def test_scans_follow_each_other_if_the_poses_are_close_in_time(self):
        words, messages = self.scan_journey("long.db3", more=("--beta-resolution", 90))
        self.assertIn("16 scans begin after the time of their pose", words)
        times = [time for _, time, _ in messages]
        self.assertEqual(times, sorted(times))
        scans = [stamp(each.header) for each in select(messages, "/scan")]
        np.testing.assert_allclose(np.diff(scans), MIRROR, atol=2)


class TestProblems(CommandLineTest):
    """What cannot be written."""

    SCAN = ("scan", ROOM, *POSE, *COARSE, "-o")

    def test_a_missing_library(self):
        for package, ending in (("laspy", "las"), ("lazrs", "laz"), ("pye57", "e57"),
                                ("rosbags", "db3"), ("rosbags", "mcap")):
            with self.subTest(ending):
                hidden = self.hide(package)
                words = self.refused(1, *self.SCAN, self.folder / f"scan.{ending}",
                                     PYTHONPATH=hidden)
                self.assertRegex(words, "Python package '(laspy|lazrs|pye57|rosbags)' is missing; "
                                 "install it: ./run python -m pip install -r "
                                 "Plugins/Python/requirements-formats.txt")

    def hide(self, package):
        """A PYTHONPATH on which a package is missing, though it may be installed."""
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        Path(folder, f"{package}.py").write_text(
            f"raise ModuleNotFoundError('No module', name={package!r})\n")
        return os.pathsep.join((folder, os.environ.get("PYTHONPATH", "")))

    @needs("rosbags")
    def test_what_exists_is_not_replaced(self):
        for name in ("old.db3", "old.mcap"):
            path = self.folder / name
            path.mkdir()
            (path / "mine").write_text("mine")
            self.assertIn("exists", self.refused(1, *self.SCAN, path))
            file = self.folder / f"file_{name}"
            file.write_text("mine")
            self.assertIn("exists", self.refused(1, *self.SCAN, file))
            self.assertEqual(file.read_text() + (path / "mine").read_text(), "minemine")

    def test_no_bag_on_the_standard_output(self):
        self.assertIn("series", self.refused(2, "scan", ROOM, "--trajectory", JOURNEY, "-o", "-"))

    def test_other_endings_of_a_journey(self):
        words = self.refused(2, "scan", ROOM, "--trajectory", JOURNEY, "-o",
                             self.folder / "scan.e57")
        self.assertIn(".pvd or .db3 or .mcap", words)

    @needs("rosbags")
    def test_a_name_that_sqlite_takes_for_an_address(self):
        self.assertIn("? # %", self.refused(1, *self.SCAN, self.folder / "a#b.db3"))
        result = run(*self.SCAN, self.folder / "a#b.mcap")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(len(read_with_rosbags(self.folder / "a#b.mcap")), 24 * 3 + 1)


if __name__ == "__main__":
    unittest.main()
