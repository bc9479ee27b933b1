#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The pseudo-terminal of lms3d emulate: rates, and hosts that come and go or send noise."""

import random
import termios
import time
import unittest

import numpy as np

from command_line import POSE, ROOM
from emulator_process import EmulatorProcess, PortHost, split
from lms3d.emulation.telegrams import frame

SCAN = frame(b"\x30\x01")
STREAM_INTERVAL = 1 / 75


class TestTerminal(unittest.TestCase):
    """All tests share one process, as hosts do one after another."""

    @classmethod
    def setUpClass(cls):
        cls.emulator = EmulatorProcess()
        cls.addClassCleanup(cls.emulator.__exit__)

    def setUp(self):
        self.host = PortHost(self.emulator.port)
        self.addCleanup(lambda: self.host.__exit__())
        self.reset()

    def reset(self):
        """The device sends nothing, at 9600 Bd, and has 361 values."""
        for rate in (9600, 19200, 38400, 500000):
            self.host.set_rate(rate)
            if self.host.ask(0x20, 0x25, seconds=0.15):
                self.host.read(0.05)
                self.host.go_to(9600)
                self.host.ask(0x3B, 180, 0, 50, 0)
                return
        self.fail("the device does not answer at any rate")

    def test_raw_without_settings(self):
        """A host that sets nothing gets all bytes unchanged, and no echo."""
        flags = termios.tcgetattr(self.host.file)
        self.assertEqual((flags[0], flags[1], flags[3]), (0, 0, 0))
        self.assertEqual(len(self.host.ask(0x30, 1)), 725)

    def test_rates(self):
        for rate in (19200, 38400, 500000, 9600):
            self.host.go_to(rate)
            self.assertEqual(self.host.ask(0x31)[:2], b"\xb1V")

    def test_silence_at_a_wrong_rate(self):
        for rate in (19200, 38400, 500000):
            self.host.set_rate(rate)
            self.assertIsNone(self.host.ask(0x31, seconds=0.15))
        self.host.set_rate(9600)
        self.assertIsNotNone(self.host.ask(0x31))

    def test_a_stream_at_a_wrong_rate(self):
        self.host.go_to(38400)
        self.host.start_stream()
        self.host.set_rate(19200)
        self.assertEqual(self.host.read(0.5), b"")
        self.host.set_rate(38400)
        self.assertEqual(len(self.host.read_telegrams(1)), 1)

    def test_stand_ins_for_500000(self):
        self.host.go_to(500000)
        for rate in (38400, 57600, 115200, 230400, 460800):
            self.host.set_rate(rate)
            self.assertIsNotNone(self.host.ask(0x31))
        self.host.set_rate(19200)
        self.assertIsNone(self.host.ask(0x31, seconds=0.15))

    def test_a_host_that_goes_finds_no_old_bytes(self):
        self.host.go_to(500000)
        self.host.start_stream()
        time.sleep(0.5)
        self.host.__exit__()
        time.sleep(0.3)
        self.host = PortHost(self.emulator.port)
        data = self.host.read(0.02)
        self.assertLessEqual(len(data), 732 * 2)
        self.assertTrue(data == b"" or split(data))

    def test_a_host_that_does_not_read(self):
        """Whole telegrams are lost, and no parts."""
        self.host.ask(0x3B, 180, 0, 100, 0)
        self.host.go_to(500000)
        self.host.start_stream()
        time.sleep(2.5)
        found = self.host.read_telegrams(120)
        self.assertEqual(len(found), 120)
        self.assertEqual({payload[0] for _, payload in found}, {0xB0})

    def test_noise(self):
        random_numbers = random.Random(2)
        for _ in range(60):
            self.host.write(random_numbers.randbytes(random_numbers.randrange(1, 200)))
        time.sleep(0.6)
        self.host.read(0.1)
        self.assertIsNotNone(self.host.ask(0x31))

    def test_random_telegrams(self):
        random_numbers = random.Random(3)
        for _ in range(300):
            code = random_numbers.choice((0x31, 0x30, 0x3A, 0x74, 0x77, 0x3B, 0x36, 0x99))
            self.host.write(frame(bytes((code,)) + random_numbers.randbytes(2)))
            time.sleep(0.002)
        time.sleep(0.6)
        self.host.read(0.1)
        self.assertIsNotNone(self.host.ask(0x31))

    def test_intervals_and_processor_time(self):
        """75 fans a second. Other programs delay single fans, so the best 25 count."""
        self.host.ask(0x3B, 180, 0, 100, 0)
        self.host.go_to(500000)
        self.host.start_stream()
        before = self.emulator.seconds()
        found = self.host.read_telegrams(300)
        share = (self.emulator.seconds() - before) / (found[-1][0] - found[0][0])
        late = np.abs(np.diff([time for time, _ in found]) - STREAM_INTERVAL)
        best = min(np.median(late[i:i + 25]) for i in range(0, 275, 25))
        print(f"processor time {share:.1%}; intervals are off by {np.median(late) * 1000:.2f} ms "
              f"(median), {late.max() * 1000:.1f} ms at most")
        self.assertLess(best, 0.003)
        self.assertLess(share, 0.5)  # a loop that waits busily takes all

    def test_two_emulators(self):
        with EmulatorProcess(ROOM, *POSE, "--unit", "cm") as other:
            with PortHost(other.port) as host:
                self.assertNotEqual(other.port, self.emulator.port)
                self.assertEqual(host.ask(0x31)[122], 0)
                self.assertEqual(self.host.ask(0x31)[122], 1)


if __name__ == "__main__":
    unittest.main()
