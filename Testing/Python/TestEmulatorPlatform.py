#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The platform of the emulated LMS 200: which fan, and which part of it, a telegram has."""

import unittest

import numpy as np

from lms200 import Host, make_device, split
from lms3d.emulation.platform import Stepped, Turning
from lms3d.emulation.telegrams import frame


def words(data):
    return np.frombuffer(data, "<u2").tolist()


class Source:
    """A source of fans that reports what it casts."""

    angles = [0.0, 90.0, 180.0, 270.0]

    def cast_turn(self, variant, scan, turn, means):
        return np.full(variant.count, 1.0 + scan + turn / 10)

    def cast_part(self, variant, part, angle, time, means):
        return np.full(len(variant.alphas[part::variant.parts]), angle)


class Numbers(Source):
    """A range in millimetres is 100 times the number of the turn, and the number of the beam."""

    def cast_turn(self, variant, scan, turn, means):
        number = len(self.angles) * scan + turn
        return number / 10 + np.arange(variant.count) / 1000


def make_host(step):
    """A host of a device that turns in steps."""
    host = Host(make_device(fans=Stepped(Numbers())))
    host.ask(0x3B, 100, 0, step, 0)
    return host


def read_part(payload):
    """The word before the values of a partial scan of Numbers, and the turn and part they have."""
    turn, part = divmod(words(payload[3:5])[0], 100)
    return words(payload[1:3])[0], (turn % len(Source.angles), part)


def request_part(host, part, parts):
    """read_part of one part: the request comes within the turn of the mirror that measures it."""
    turn = round(host.now * 75) + 1
    turn += (part - turn) % parts
    host.now = turn / 75 + 0.001
    return read_part(host.ask(0x30, 8))


class TestPlatform(unittest.TestCase):
    def test_steps(self):
        """No turn is lost, and the next scan follows."""
        host = Host(make_device(fans=Stepped(Source())))
        found = [words(host.ask(0x30, 1)[3:])[0] for _ in range(6)]
        self.assertEqual(found, [1000, 1100, 1200, 1300, 2000, 2100])

    def test_all_parts_of_a_turn(self):
        """The platform waits for each part, in any order and however often another part has come."""
        for step, parts, turns in ((50, (1, 1, 0, 0, 0, 1, 1), (0, 0, 0, 1, 1, 1, 2)),
                                   (25, (2, 0, 0, 3, 2, 1, 1, 2), (0, 0, 0, 0, 0, 0, 1, 1))):
            host = make_host(step)
            self.assertEqual([request_part(host, part, 100 // step)[1] for part in parts],
                             list(zip(turns, parts)))

    def test_another_step_halfway(self):
        """Parts of another step do not count: the platform waits for all parts of the new one."""
        for step, parts, other, others, turns in (
                (25, (0, 1), 50, (0, 0, 1, 0), (0, 0, 0, 1)),
                (50, (0,), 25, (1, 2, 3, 3, 0, 0), (0, 0, 0, 0, 0, 1)),
                (25, (0, 1, 2), 100, (0, 0), (0, 1))):
            with self.subTest(step=step, other=other):
                host = make_host(step)
                for part in parts:
                    self.assertEqual(request_part(host, part, 100 // step)[1], (0, part))
                host.ask(0x3B, 100, 0, other, 0)
                self.assertEqual([request_part(host, part, 100 // other)[1] for part in others],
                                 list(zip(turns, others)))

    def test_a_whole_fan_halfway(self):
        """It turns the platform, and the part that came before it does not count afterwards."""
        host = make_host(50)
        self.assertEqual(request_part(host, 0, 2)[1], (0, 0))
        host.ask(0x30, 1)
        self.assertEqual([request_part(host, part, 2)[1] for part in (1, 1, 0, 0)],
                         [(1, 1), (1, 1), (1, 0), (2, 0)])

    def test_the_bits_of_the_part(self):
        """TL 46: bits 11 and 12 are 0 for x.00 degrees, 1 for x.25, 2 for x.50 and 3 for x.75; bit 13
        says that the scan is partial. At each angle of the platform, the values are of the same part."""
        for step, bits in ((50, (0, 2)), (25, (0, 1, 2, 3))):
            host = make_host(step)
            for turn in range(len(Source.angles)):
                for part, expected in enumerate(bits):
                    word, found = request_part(host, part, len(bits))
                    self.assertEqual(found, (turn, part))
                    self.assertEqual((word >> 11 & 3, word >> 13 & 1), (expected, 1))

    def test_the_bits_of_the_part_in_a_stream(self):
        """TL 46, for 20h 2Ah"""
        for step, bits in ((50, (0, 2)), (25, (0, 1, 2, 3))):
            host = make_host(step)
            host.ask(0x20, 0x48)
            host.write(frame(b"\x20\x2a"))
            found = {}
            for _, data in host.run(0.6):
                payload = split(data)[0]
                if payload != 6 and payload[0] == 0xB0:
                    word, (turn, part) = read_part(payload)
                    self.assertEqual(word >> 11 & 3, bits[part])
                    found.setdefault(turn, set()).add(word >> 11 & 3)
            self.assertEqual(found, {turn: set(bits) for turn in range(len(Source.angles))})

    def test_a_lost_telegram_keeps_the_platform(self):
        device = make_device(fans=Stepped(Source()))
        for now in (1.0, 2.0):
            device.receive(frame(b"\x30\x01"), now)
            sendings = []
            while device.next_time() is not None:
                sendings.append(device.take(device.next_time()))
            self.assertEqual(sendings[-1].fan.angle, 0.0)

    def test_a_steady_turn(self):
        """The half degrees are a turn of the mirror younger than the whole ones (TL 19)."""
        platform = Turning(Source(), 37.5, 100.0)
        fan = platform.measure(make_device().state.variant, None, 102.0, 1)
        self.assertAlmostEqual(fan.angle, 75.0)
        np.testing.assert_allclose(fan.ranges[0::2], 75.0)
        np.testing.assert_allclose(fan.ranges[1::2], 75.5)


if __name__ == "__main__":
    unittest.main()
