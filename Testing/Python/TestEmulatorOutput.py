#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Requested values of the emulated LMS 200, and hosts that send noise. TL: pages of SICK's telegram
listing."""

import random
import unittest

import numpy as np

from lms200 import Host, Ramp, make_device, split
from lms3d.emulation.measured_values import UNITS_PER_METRE
from lms3d.emulation.telegrams import frame

TURN = 1 / 75


def words(data):
    return np.frombuffer(data, "<u2").tolist()


class TestRequests(unittest.TestCase):
    """The commands 30h, 36h, 37h, 3Fh, also in installation mode (TL 122)."""

    def setUp(self):
        self.host = Host()

    def test_one_scan(self):
        """Values come from the right to the left (TL 48)."""
        for prepare in (lambda: None, self.host.install):
            prepare()
            data = self.host.ask(0x30, 1)
            self.assertEqual(data[:3], b"\xb0\x69\x41")
            self.assertEqual(words(data[3:]), list(range(1000, 1361)))

    def test_sub_range_and_means(self):
        self.assertEqual(self.host.ask(0x37, 3, 0, 5, 0), b"\xb7\x03\x00\x05\x00\x03\x40"
                         + np.array((1002, 1003, 1004), "<u2").tobytes())
        self.assertEqual(self.host.ask(0x36, 4)[:4], b"\xb6\x04\x69\x41")
        self.assertEqual(self.host.ask(0x3F, 4, 361 % 256, 1, 361 % 256, 1),
                         b"\xbf\x04\x69\x01\x69\x01\x01\x40\x50\x05")

    def test_partial_scans(self):
        """TL 46: whole degrees have 181 values, all others 180, over 180 degrees always"""
        for step, parts in ((50, 2), (25, 4)):
            host = Host()
            host.ask(0x3B, 100, 0, step, 0)
            for _ in range(parts + 2):
                data = host.ask(0x30, 8)
                word = int.from_bytes(data[1:3], "little")
                part = (word >> 11 & 3) * parts // 4
                self.assertEqual((word >> 13, word & 0x3FF), (0b011, 180 + (part == 0)))
                last = 1000 + 180 * parts
                self.assertEqual(words(data[3:]), list(range(1000 + part, last + 1, parts)))

    def test_indices(self):
        """Bit 1 of the availability"""
        self.host.configure(availability=2)
        first, second = self.host.ask(0x30, 1), self.host.ask(0x30, 1)
        self.assertEqual(len(first), 3 + 722 + 2)
        self.assertEqual((second[-1] - first[-1]) % 256, 1)
        turns = round((self.host.device._fans.times[-1] - self.host.device._fans.times[-2]) / TURN)
        self.assertEqual((second[-2] - first[-2]) % 256, turns % 256)

    def test_the_longest_telegram(self):
        """401 values with their number of scans, sub-range and indices; `ask` checks the check sum"""
        self.host.ask(0x3B, 100, 0, 25, 0)
        self.host.configure(availability=2)
        data = self.host.ask(0x3F, 2, 1, 0, 401 % 256, 1)
        self.assertEqual(len(data), 1 + 1 + 4 + 2 + 2 * 401 + 2)
        self.assertEqual(words(data[8:-2]), list(range(1000, 1401)))

    def test_a_request_is_answered_within_60_ms(self):
        """TL 24"""
        for step in (100, 50, 25):
            self.host.ask(0x3B, 100, 0, step, 0)
            for _ in range(40):
                self.host.now += 0.0017
                self.host.write(frame(b"\x30\x01"))
                start = self.host.now
                (acknowledged, _), (arrived, _) = self.host.run(0.2)
                self.assertAlmostEqual(acknowledged - start, 0.004, 6)
                self.assertGreaterEqual(arrived - start, 0.010)
                self.assertLessEqual(arrived - start, 0.060)


class TestRandomHosts(unittest.TestCase):
    """Nothing stops the device, and it never reports other ranges than measured ones."""

    COMMANDS = (0x10, 0x20, 0x30, 0x31, 0x32, 0x35, 0x36, 0x37, 0x3A, 0x3B, 0x3F, 0x66, 0x74, 0x77,
                0x7B, 0x7C)
    # Requests and streams: whether they have a number of scans, and a sub-range.
    VALUES = ((b"\x36", True, False), (b"\x37", False, True), (b"\x3f", True, True),
              (b"\x20\x26", True, False), (b"\x20\x27", False, True), (b"\x20\x28", True, True))
    # The same for the codes of their telegrams.
    HEADS = {0xB0: (False, False), 0xB6: (True, False), 0xB7: (False, True), 0xBF: (True, True)}

    def payload(self, random_numbers):
        if random_numbers.random() < 0.2:
            return self.value_command(random_numbers)
        data = random_numbers.randbytes(random_numbers.choice((0, 1, 1, 2, 4, 5, 7, 8, 34, 84)))
        code = random_numbers.choice((*self.COMMANDS, random_numbers.randrange(256)))
        if code == 0x20 and random_numbers.random() < 0.8:
            data = bytes((random_numbers.choice((0x24, 0x25, 0x26, 0x2A, 0x40, 0x48)),)) + data[1:]
        if random_numbers.random() < 0.05:
            code, data = 0x20, b"\x00SICK_LMS"
        return bytes((code,)) + data

    def value_command(self, random_numbers):
        """A command for mean values or a sub-range, which only some variants have."""
        command, has_means, has_borders = random_numbers.choice(self.VALUES)
        if has_means:
            command += bytes((random_numbers.choice((2, 3, 4, 250)),))
        if has_borders:
            last = random_numbers.choice((5, 101, 181, 361, 402))
            command += np.array((random_numbers.randint(1, last), last), "<u2").tobytes()
        return command

    def take(self, device, now, end, is_late):
        """Take a few telegrams at their times, or when all of them are late."""
        for _ in range(6):
            due = device.next_time()
            if due is None or due > end:
                return
            now = end if is_late else max(now, due)
            sending = device.take(now)
            if sending:
                self.check(device, sending)

    def check(self, device, sending):
        for payload in split(sending.data):
            if isinstance(payload, bytes) and payload[0] in self.HEADS:
                self.assertIsNotNone(sending.fan)
                self.assertEqual(payload[-1], 0x10)
                self.check_values(payload[:-1], device.state.variant)
                self.counts[payload[0]] += 1

    def check_values(self, payload, variant):
        """All values: beam i has 1 m and i mm."""
        has_means, has_borders = self.HEADS[payload[0]]
        if has_means:
            self.assertIn(payload[1], range(2, 251))
        data = payload[1 + has_means:]
        first, last, step = 1, variant.angle * 100 // variant.step + 1, 1
        if has_borders:
            (first, last), data = words(data[:4]), data[4:]
        (word,), data = words(data[:2]), data[2:]
        if word >> 13 & 1:  # a part of 180 degrees
            step = 100 // variant.step
            first = (word >> 11 & 3) * step // 4 + 1
            last = 180 * step + 1
        beams = np.arange(first - 1, last, step)
        self.assertEqual(word & 0x3FF, len(beams))
        scale = UNITS_PER_METRE[word >> 14]
        np.testing.assert_allclose(np.array(words(data[:2 * len(beams)])) / scale,
                                   1 + beams / 1000, rtol=0, atol=0.5001 / scale)

    def test_100_000_telegrams(self):
        random_numbers = random.Random(19)
        device, now = make_device(), 0.0
        self.counts = dict.fromkeys(self.HEADS, 0)
        for number in range(100_000):
            data = frame(self.payload(random_numbers))
            kind = random_numbers.random()
            if kind < 0.05:
                data = random_numbers.randbytes(random_numbers.randrange(40))
            elif kind < 0.1:
                data = data[:random_numbers.randrange(len(data))]
            device.receive(data, now)
            end = now + random_numbers.choice((0.001, 0.02, 0.02, 0.1))
            if number % 50 == 0:
                end += 3.0
            self.take(device, now, end, is_late=random_numbers.random() < 0.5)
            now = end
        self.assertGreater(min(self.counts.values()), 200, self.counts)
        host = Host(device)
        host.now = now + 10.0
        host.run(10.0)
        host.exchange(frame(b"\x20\x25"))
        self.assertEqual(host.ask(0x20, 0x42), b"\xa0\x00")
        self.assertEqual(host.ask(0x31)[:2], b"\xb1V")
        self.assertIsInstance(device._fans, Ramp)


if __name__ == "__main__":
    unittest.main()
