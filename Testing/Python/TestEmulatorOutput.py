#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measured values of the emulated LMS 200, their times, and hosts that send noise."""

import random
import unittest

import numpy as np

from lms200 import Host, Ramp, make_device, split
from lms3d.emulation.measured_values import DISTANCE_BITS, UNITS_PER_METRE
from lms3d.emulation.platform import Stepped, Turning
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


class TestStreams(unittest.TestCase):
    """The sub-commands 24h to 2Ah of 20h (TL 19, 127)."""

    def stream(self, rate, variant, command, seconds=4.0, **options):
        host = Host(make_device(**options))
        host.ask(0x20, {9600: 0x42, 19200: 0x41, 38400: 0x40, 500000: 0x48}[rate])
        host.ask(0x3B, variant[0], 0, variant[1], 0)
        host.write(frame(bytes(command)))
        sent = host.run(seconds)
        self.answer_time = sent[1][0]
        return [time for time, _ in sent[2:]], [split(data)[0] for _, data in sent[2:]]

    def test_intervals(self):
        for rate, variant, hertz in ((9600, (180, 50), 75 / 58), (19200, (180, 50), 2.5),
                                     (38400, (180, 50), 4.6875), (500000, (180, 50), 37.5),
                                     (500000, (180, 100), 75), (38400, (100, 25), 4.6875)):
            with self.subTest(rate=rate, variant=variant):
                times, _ = self.stream(rate, variant, (0x20, 0x24))
                np.testing.assert_allclose(np.diff(times), 1 / hertz, atol=1e-9)

    def test_wake_ups(self):
        """A fan is cast when its last mirror turn begins; at 75 a second this is one time for both."""
        for step, wake_ups in ((100, 1), (50, 2)):
            with self.subTest(step=step):
                host = Host()
                host.ask(0x20, 0x48)
                host.ask(0x3B, 180, 0, step, 0)
                host.write(frame(b"\x20\x24"))
                host.run(0.1)
                sent = 0
                for _ in range(50 * wake_ups):
                    host.now = host.device.next_time() + 1e-5
                    while host.device.take(host.now):
                        sent += 1
                self.assertEqual(sent, 50)

    def test_the_pace_of_the_mirror(self):
        times, _ = self.stream(38400, (180, 50), (0x20, 0x24), is_paced_by_line=False)
        np.testing.assert_allclose(np.diff(times), 2 * TURN, atol=1e-9)

    def test_the_first_scan_begins_after_the_answer(self):
        for variant, turns in (((180, 100), 1), ((180, 50), 2), ((100, 25), 4)):
            times, _ = self.stream(500000, variant, (0x20, 0x24))
            self.assertGreaterEqual(times[0] - self.answer_time, turns * TURN - 1e-9)

    def test_codes_of_streams(self):
        for command, head in (((0x20, 0x26, 2), b"\xb6\x02\x69\x41"),
                              ((0x20, 0x27, 2, 0, 3, 0), b"\xb7\x02\x00\x03\x00\x02\x40"),
                              ((0x20, 0x28, 9, 2, 0, 2, 0), b"\xbf\x09\x02\x00\x02\x00\x01\x40")):
            _, payloads = self.stream(38400, (180, 50), command)
            self.assertGreater(len(payloads), 3)
            for payload in payloads:
                self.assertTrue(payload.startswith(head))

    def test_all_parts_come_round(self):
        for rate in (9600, 38400, 500000):
            for step, parts in ((50, (0, 2)), (25, (0, 1, 2, 3))):
                _, payloads = self.stream(rate, (100, step), (0x20, 0x2A), 6.0)
                found = [payload[2] >> 3 & 3 for payload in payloads]
                self.assertEqual(set(found[:len(parts)]), set(parts))

    def test_an_answer_comes_between_scans(self):
        host = Host()
        host.write(frame(b"\x20\x24"))
        host.run(3.0)
        found = split(host.exchange(frame(b"\x31"), 2.0))
        self.assertEqual((found[0], found[1][0], found[2][0]), (6, 0xB1, 0xB0))

    def test_sleep_loses_scans(self):
        """After the computer has slept, no scans come in a heap."""
        host = Host()
        host.write(frame(b"\x20\x24"))
        host.run(3.0)
        host.now += 100.0
        self.assertLessEqual(len(host.run(0.7)), 2)


class Source:
    """A source of fans that reports what it casts."""

    angles = [0.0, 90.0, 180.0, 270.0]

    def cast_turn(self, variant, scan, turn, means):
        return np.full(variant.count, 1.0 + scan + turn / 10)

    def cast_part(self, variant, part, angle, time, means):
        return np.full(len(variant.alphas[part::variant.parts]), angle)


class TestPlatform(unittest.TestCase):
    def test_steps(self):
        """No turn is lost, and the next scan follows."""
        host = Host(make_device(fans=Stepped(Source())))
        found = [words(host.ask(0x30, 1)[3:])[0] for _ in range(6)]
        self.assertEqual(found, [1000, 1100, 1200, 1300, 2000, 2100])

    def test_all_parts_of_a_turn(self):
        host = Host(make_device(fans=Stepped(Source())))
        found = [words(host.ask(0x30, 8)[3:])[0] for _ in range(6)]
        self.assertEqual(found, [1000, 1000, 1100, 1100, 1200, 1200])

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


class TestRandomHosts(unittest.TestCase):
    """Nothing stops the device, and it never reports other ranges than measured ones."""

    COMMANDS = (0x10, 0x20, 0x30, 0x31, 0x32, 0x35, 0x36, 0x37, 0x3A, 0x3B, 0x3F, 0x66, 0x74, 0x77,
                0x7B, 0x7C)

    def payload(self, random_numbers):
        data = random_numbers.randbytes(random_numbers.choice((0, 1, 1, 2, 4, 5, 7, 8, 34, 84)))
        code = random_numbers.choice((*self.COMMANDS, random_numbers.randrange(256)))
        if code == 0x20 and random_numbers.random() < 0.8:
            data = bytes((random_numbers.choice((0x24, 0x25, 0x26, 0x2A, 0x40, 0x48)),)) + data[1:]
        if random_numbers.random() < 0.05:
            code, data = 0x20, b"\x00SICK_LMS"
        return bytes((code,)) + data

    def check(self, device, sending):
        for payload in split(sending.data):
            if isinstance(payload, bytes) and payload[0] in (0xB0, 0xB6, 0xB7, 0xBF):
                self.assertIsNotNone(sending.fan)
                self.assertEqual(payload[-1], 0x10)
                if payload[0] == 0xB0:
                    self.check_first_range(payload, device.state.configuration.measuring_mode)

    def check_first_range(self, payload, mode):
        """The first beam of a scan has 1 m, and of its parts up to 3 mm more."""
        unit = payload[2] >> 6
        metres = words(payload[3:5])[0] / UNITS_PER_METRE[unit]
        self.assertAlmostEqual(metres, 1.0, delta=0.0031)
        self.assertIn(mode, DISTANCE_BITS)

    def test_100_000_telegrams(self):
        random_numbers = random.Random(19)
        device, now = make_device(), 0.0
        for number in range(100_000):
            data = frame(self.payload(random_numbers))
            kind = random_numbers.random()
            if kind < 0.05:
                data = random_numbers.randbytes(random_numbers.randrange(40))
            elif kind < 0.1:
                data = data[:random_numbers.randrange(len(data))]
            device.receive(data, now)
            now += random_numbers.choice((0.001, 0.02, 0.02, 0.1))
            if number % 50 == 0:
                now += 3.0
            for _ in range(6):
                sending = device.take(now)
                if sending:
                    self.check(device, sending)
        host = Host(device)
        host.now = now + 10.0
        host.run(10.0)
        host.exchange(frame(b"\x20\x25"))
        self.assertEqual(host.ask(0x20, 0x42), b"\xa0\x00")
        self.assertEqual(host.ask(0x31)[:2], b"\xb1V")
        self.assertIsInstance(device._fans, Ramp)


if __name__ == "__main__":
    unittest.main()
