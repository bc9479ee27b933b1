#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Telegrams of the LMS 200 as SICK's telegram listing (TL) prints them; numbers are its pages."""

import random
import unittest

import numpy as np

from lms3d.emulation.crc import compute_crc
from lms3d.emulation.measured_values import (
    CENTIMETRES,
    DECIMETRES,
    DISTANCE_BITS,
    MILLIMETRES,
    encode_count,
    encode_ranges,
)
from lms3d.emulation.telegrams import MAXIMUM_SIZE, TelegramReader, frame, frame_answer
from lms3d.emulation.variants import TURNS_PER_SECOND, VARIANTS, Output, Variant, interval

# Printed telegrams: what they are, and their bytes.
HOST = {
    "request one scan": "02 00 02 00 30 01 31 18",
    "send scans continuously": "02 00 02 00 20 24 34 08",
    "500000 Bd": "02 00 02 00 20 48 58 08",
    "installation mode": "02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5",
    "180 degrees by 0.5": "02 00 05 00 3B B4 00 32 00 3B 1F",
}
DEVICE = {
    "variant accepted": "02 80 07 00 BB 01 B4 00 32 00 10 03 9D",
    "mode switched": "02 80 03 00 A0 00 10 16 0A",
    "not possible": "02 80 02 00 92 10 7F 33",
}
PLAIN = Output(0xB0)

# Bits of the distance by the measuring mode, from table 7-28 of TL.
BITS = {0x00: 13, 0x01: 13, 0x02: 13, 0x03: 14, 0x04: 14, 0x05: 15, 0x06: 15, 0x0F: 16, 0x3F: 16}


def read_all(data, now=0.0):
    return TelegramReader().read(data, now)


class TestFrames(unittest.TestCase):
    def test_the_check_sum_of_printed_telegrams(self):
        """TL 107"""
        for name, text in {**HOST, **DEVICE}.items():
            with self.subTest(name):
                data = bytes.fromhex(text)
                self.assertEqual(compute_crc(data[:-2]), data[-2:])

    def test_the_check_sum_of_random_bytes(self):
        """TL 107, step by step"""
        random_numbers = random.Random(4)
        for size in (1, 2, 3, 4, 100, 732, 810, 817):
            data = random_numbers.randbytes(size)
            register = before = 0
            for byte in data:
                register = register << 1 ^ (0x18005 if register & 0x8000 else 0)
                register ^= before << 8 | byte
                before = byte
            self.assertEqual(compute_crc(data), register.to_bytes(2, "little"))

    def test_misprints_are_not_accepted(self):
        """Table 6-4 of TL prints 5F B2 for the password; the rule of TL 107 gives BE C5."""
        data = bytes.fromhex(HOST["installation mode"])
        self.assertNotEqual(compute_crc(data[:-2]), b"\x5f\xb2")

    def test_frames(self):
        """TL 21, 22"""
        for text in HOST.values():
            data = bytes.fromhex(text)
            self.assertEqual(frame(data[4:-2]), data)
            self.assertEqual(read_all(data), [data[4:-2]])
        for text in DEVICE.values():
            data = bytes.fromhex(text)
            self.assertEqual(frame_answer(data[4], data[5:-3]), data)

    def test_sizes_of_measured_values(self):
        """181, 361 and 401 values; a telegram has at most 812 bytes (TL 22)"""
        for variant, size in ((Variant(180, 100), 372), (Variant(180, 50), 732),
                              (Variant(100, 25), 812)):
            self.assertEqual(PLAIN.size(variant, False), size)
        self.assertEqual(MAXIMUM_SIZE, 812)


class TestReader(unittest.TestCase):
    scan = bytes.fromhex(HOST["request one scan"])
    payload = scan[4:-2]

    def test_pieces(self):
        """TL 24: bytes may come one by one"""
        reader = TelegramReader()
        found = [payload for i, byte in enumerate(self.scan)
                 for payload in reader.read(bytes((byte,)), i * 0.006)]
        self.assertEqual(found, [self.payload])

    def test_a_gap_drops_a_telegram(self):
        """TL 24"""
        reader = TelegramReader()
        self.assertEqual(reader.read(self.scan[:4], 0.0), [])
        self.assertEqual(reader.read(self.scan[4:], 0.6), [])
        self.assertEqual(reader.read(self.scan, 1.2), [self.payload])

    def test_a_bad_check_sum(self):
        """TL 23"""
        bad = self.scan[:-1] + b"\x00"
        self.assertEqual(read_all(bad), [None])
        self.assertEqual(read_all(bad + self.scan), [self.payload])

    def test_another_address(self):
        """TL 24: silence"""
        self.assertEqual(read_all(frame(self.payload, 5)), [])
        self.assertEqual(read_all(frame(self.payload, 5) + self.scan), [self.payload])

    def test_noise(self):
        """TL 24: the telegram that follows noise is found, also if the noise looks like one"""
        random.seed(1)
        for noise in (b"\x00", b"\x02", b"\x02\x00", b"\x02\x02\x02\x02", b"\x02\x00\xff\xff",
                      b"\x02\x00\x05\x00", b"\x06\x15", random.randbytes(700)):
            with self.subTest(noise[:8]):
                self.assertEqual(read_all(noise + self.scan + noise)[0:1], [self.payload])

    def test_noise_within(self):
        for i in range(1, len(self.scan)):
            with self.subTest(i):
                found = read_all(self.scan[:i] + b"\x55" + self.scan[i:] + self.scan)
                self.assertEqual(found[-1], self.payload)

    def test_a_lost_byte(self):
        for i in range(len(self.scan)):
            with self.subTest(i):
                found = read_all(self.scan[:i] + self.scan[i + 1:] + self.scan)
                self.assertEqual(found[-1], self.payload)

    def test_no_bytes_pile_up(self):
        reader = TelegramReader()
        for i in range(2000):
            reader.read(random.Random(i).randbytes(50), i * 0.01)
            self.assertLessEqual(len(reader._bytes), MAXIMUM_SIZE)


class TestValues(unittest.TestCase):
    def test_codes(self):
        """Codes are at the upper end of the distance's bits (table 7-28 of TL)."""
        self.assertEqual(DISTANCE_BITS, BITS)
        for mode, bits in BITS.items():
            top = 2**bits - 1
            for unit, scale in ((MILLIMETRES, 1000), (CENTIMETRES, 100), (DECIMETRES, 10)):
                with self.subTest(mode=mode, unit=unit):
                    ranges = np.array([0.1, (top - 9) / scale, (top - 8) / scale, 1e6, np.inf,
                                       np.nan, -np.inf])
                    values = encode_ranges(ranges, unit, mode)
                    self.assertEqual(values.tolist(), [round(0.1 * scale), top - 9, top - 8,
                                                       top - 8, top - 8, top, top - 4])
                    self.assertEqual(values.dtype, "<u2")

    def test_16_metres(self):
        """TL prints 16385 beside 3FF7h, which is 16375."""
        self.assertEqual(encode_ranges(np.array([20.0]), MILLIMETRES, 0x03).tolist(), [0x3FF7])

    def test_the_count(self):
        """Number, part (TL 46), unit"""
        self.assertEqual(encode_count(361, MILLIMETRES), b"\x69\x41")
        self.assertEqual(encode_count(361, CENTIMETRES), b"\x69\x01")
        self.assertEqual(encode_count(361, DECIMETRES), b"\x69\x81")
        for parts, part, word in ((4, 1, 0x2800), (4, 3, 0x3800), (2, 1, 0x3000), (2, 0, 0x2000)):
            count = int.from_bytes(encode_count(180, CENTIMETRES, part, parts), "little")
            self.assertEqual(count, 180 | word)


class TestLawOfTheLine(unittest.TestCase):
    """How many scans arrive; the mirror turns 75 times a second (TL 19, 127)."""

    def rate(self, variant, line, output=PLAIN):
        size = output.size(variant, False)
        return TURNS_PER_SECOND / interval(output, variant, size, line)

    def test_whole_scans(self):
        for variant, rates in ((Variant(180, 100), (2.5, 5, 9.375, 75)),
                               (Variant(180, 50), (75 / 58, 2.5, 4.6875, 37.5)),
                               (Variant(100, 25), (75 / 64, 75 / 32, 4.6875, 18.75))):
            for line, rate in zip((9600, 19200, 38400, 500000), rates):
                self.assertEqual(self.rate(variant, line), rate)

    def test_scans_of_the_table(self):
        """Table 10-17 of TL: every 29th, 15th, 8th scan arrives, and so on."""
        for variant, counts in ((Variant(180, 50), (29, 15, 8)), (Variant(180, 100), (30, 15, 8)),
                                (Variant(100, 25), (16, 8, 4))):
            for line, count in zip((9600, 19200, 38400), counts):
                self.assertEqual(self.rate(variant, line), 75 / count / variant.parts)

    def test_partial_scans_come_round(self):
        """All parts of a partial scan arrive, at every rate."""
        partial = Output(0xB0, is_partial=True)
        for line in (9600, 19200, 38400, 500000):
            for step in (50, 25):
                variant = Variant(100, step)
                turns = interval(partial, variant, partial.size(variant, False), line)
                self.assertEqual({i * turns % variant.parts for i in range(4)},
                                 set(range(variant.parts)))

    def test_the_mirror_alone(self):
        for variant in VARIANTS:
            self.assertEqual(interval(PLAIN, variant, 812, None), variant.parts)


if __name__ == "__main__":
    unittest.main()
