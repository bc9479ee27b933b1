#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d advise: its result is good enough, and no coarser trial is."""

import os
import pty
import re
import shlex
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from lms3d.sampling import advise, measure, set_steps, steps_down_to
from lms3d.scene import read_scene
from lms3d.simulation import Simulation

DATA = Path(os.environ.get("LMS3D_DATA_DIR") or Path(__file__).resolve().parents[2] / "Data")
ROOM = DATA / "room.wrl"
POSITION = (0.3, -0.2, 1.0)
POSE = ("--position", *POSITION)
TOLERANCE = 0.1
SAMPLES = 20_000


def run(*arguments, **options):
    """The finished process of `lms3d ARGUMENTS`."""
    return subprocess.run([sys.executable, "-m", "lms3d", *map(str, arguments)],
                          capture_output=True, text=True, timeout=300, check=False, **options)


def make_simulation():
    """A sensor in the room."""
    simulation = Simulation(read_scene(ROOM))
    simulation.sensor.SetPosition(POSITION)
    return simulation


class SearchTest(unittest.TestCase):
    """The search itself."""

    def test_steps_decrease_to_the_finest(self):
        for finest in (0.05, 0.25, 0.3, 1.0, 7.0, 8.0):
            steps = steps_down_to(finest)
            self.assertEqual(steps[-1], finest)
            self.assertEqual(steps, sorted(set(steps), reverse=True))
            self.assertEqual(steps[0], 8.0)

    def test_steps_fill_the_ranges(self):
        sensor = make_simulation().sensor
        set_steps(sensor, 1.0)
        self.assertEqual((sensor.GetAlphaResolution(), sensor.GetBetaResolution()), (181, 360))
        sensor.SetAlphaRange(-10, 20)
        sensor.SetBetaRange(0, 90)
        set_steps(sensor, 2.0)
        self.assertEqual((sensor.GetAlphaResolution(), sensor.GetBetaResolution()), (16, 46))

    def test_finds_the_coarsest_good_enough_sample(self):
        found, _ = advise(make_simulation(), TOLERANCE, 0.95, 0.5, SAMPLES)
        self.assertTrue(found.meets(0.95))
        self.assertLess(found.step, 8.0)
        simulation = make_simulation()
        coarser = [step for step in steps_down_to(0.5) if step > found.step]
        trials = [(step, factor * TOLERANCE) for step in coarser for factor in (0.125, 1, 8)]
        if found.maximum_error < 8 * TOLERANCE:
            trials.append((found.step, 2 * found.maximum_error))
        for step, bound in trials:
            sample = measure(simulation, step, bound, TOLERANCE, SAMPLES)
            self.assertFalse(sample.meets(0.95), (step, bound))

    def test_a_smaller_share_needs_no_finer_steps(self):
        steps = [advise(make_simulation(), TOLERANCE, share, 0.5, SAMPLES)[0].step
                 for share in (0.96, 0.9, 0.8)]
        self.assertEqual(steps, sorted(steps))

    def test_returns_the_best_sample_if_none_is_good_enough(self):
        found, best = advise(make_simulation(), 0.001, 0.999, 4.0, SAMPLES)
        self.assertIsNone(found)
        self.assertFalse(best.meets(0.999))

    def test_continues_if_a_coarse_scan_has_no_map(self):
        simulation = Simulation(read_scene(DATA / "teapot.wrl"))
        simulation.sensor.SetPosition(0.3, -2.9, 0.31)
        self.assertIsNone(measure(simulation, 8.0, 0.01, TOLERANCE, SAMPLES).comparison)
        found, _ = advise(simulation, TOLERANCE, 0.5, 1.0, SAMPLES)
        self.assertTrue(found.meets(0.5))

    def test_a_sensor_that_sees_nothing_finds_nothing(self):
        simulation = make_simulation()
        simulation.sensor.SetPosition(0, 0, 1000)
        self.assertEqual(advise(simulation, TOLERANCE, 0.95, 4.0, SAMPLES), (None, None))


class CommandTest(unittest.TestCase):
    """The command: its output, exit code and progress."""

    def advised(self, *arguments):
        """The output of the command, and its last line."""
        result = run("advise", ROOM, *POSE, *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout, result.stdout.splitlines()[-1]

    def test_the_advised_command_is_good_enough(self):
        output, command = self.advised("--tolerance", TOLERANCE)
        self.assertRegex(output, r"angles   \d+ elevations x \d+ turns, steps of \S+ degrees")
        with tempfile.TemporaryDirectory() as folder:
            words = shlex.split(command)
            self.assertEqual(words[0], "lms3d")
            done = run(*words[1:], cwd=folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            judged = run("compare", "map.vtp", ROOM, "--tolerance", TOLERANCE, cwd=folder).stdout
        shares = re.search(r"correct (\S+) %, complete (\S+) %", judged)
        self.assertGreaterEqual(min(float(shares[1]), float(shares[2])), 95.0)

    def test_the_advised_command_keeps_the_options(self):
        _, command = self.advised("--tolerance", 0.5, "--share", 0.5, "--alpha-range", -30, 30.5,
                                  "--maximum-range", 12, "--depth-step", 0.2, "--method", "fast")
        for words in ("--position 0.3 -0.2 1", "--alpha-range -30 30.5", "--maximum-range 12",
                      "--depth-step 0.2", "--method fast"):
            self.assertIn(words, command)
        for word in ("--beta-range", "--orientation", "--minimum-range", "--up-axis"):
            self.assertNotIn(word, command)

    def test_follows_its_progress_on_a_terminal(self):
        terminal, end = pty.openpty()
        with subprocess.Popen([sys.executable, "-m", "lms3d", "advise", ROOM, *map(str, POSE),
                               "--tolerance", "0.5", "--share", "0.5"],
                              stdout=subprocess.DEVNULL, stderr=end) as process:
            os.close(end)
            shown = b""
            try:
                while part := os.read(terminal, 4096):
                    shown += part
            except OSError:  # Linux raises it when the other end is closed
                pass
        os.close(terminal)
        self.assertEqual(process.returncode, 0)
        lines = shown.replace(b"\r", b"\n")
        percents = [int(x) for x in re.findall(rb"measuring .* (\d+) %", lines)]
        self.assertEqual(percents, sorted(percents))
        self.assertGreater(len(percents), 1)

    def test_says_what_to_do_if_nothing_is_good_enough(self):
        result = run("advise", ROOM, *POSE, "--tolerance", 0.001, "--share", 0.999, "--finest", 4)
        self.assertEqual(result.returncode, 1)
        self.assertIn("no map with steps of 4 degrees or more is good enough", result.stderr)
        self.assertIn("raise --tolerance, lower --share or lower --finest", result.stderr)

    def test_refuses_invalid_options(self):
        for code, words, arguments in (
                (2, "--tolerance", ()),
                (2, "is not above 0", ("--tolerance", 0)),
                (2, "is not below 1", ("--tolerance", 1, "--share", 1)),
                (2, "is not within 0.05 to 8", ("--tolerance", 1, "--finest", 0.01)),
                (2, "must increase", ("--tolerance", 1, "--alpha-range", 10, 10)),
                (1, "move the sensor", ("--tolerance", 1, "--maximum-range", 0.001))):
            result = run("advise", ROOM, *POSE, *arguments)
            self.assertEqual(result.returncode, code, arguments)
            self.assertIn(words, result.stderr)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)


if __name__ == "__main__":
    unittest.main()
