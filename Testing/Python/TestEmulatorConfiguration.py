#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Status and configuration of the emulated LMS 200. TL: pages of SICK's telegram listing.

Indices of the status are counted from the code of its telegram.
"""

import unittest

from lms200 import Host, make_device
from lms3d.emulation.measured_values import CENTIMETRES
from lms3d.emulation.telegrams import frame

# 70h is the threshold for stopping (TL 31); 2 is the number of evaluations, and of restarts.
DEFAULTS = bytes.fromhex("00 00 70 00 00 00 01 00 00 02 02 00 02"
                         + 15 * "00" + "00 00 02 02 02 00")


class TestStatus(unittest.TestCase):
    """31h, in both modes (TL 122): 152 bytes"""

    def setUp(self):
        self.host = Host()

    def test_a_new_device(self):
        for prepare in (lambda: None, self.host.install):
            prepare()
            status = self.host.ask(0x31)
            self.assertEqual(len(status), 153)
            self.assertEqual(status[1:8], b"V02.30 ")
            self.assertEqual(status[124:131], b"V02.00 ")  # of the boot program
            self.assertEqual(status[18], 0)  # the type of the scanner: LMS 200
            self.assertEqual(status[107:111], bytes((180, 0, 50, 0)))
            self.assertEqual(status[116:118], b"\x67\x80")
            self.assertEqual((status[102], status[120], status[122]), (0, 0, 1))
        self.assertEqual(Host(make_device(CENTIMETRES)).ask(0x31)[122], 0)

    def test_the_motor(self):
        """TL 19: a turn of the mirror takes 13.33 ms; a 90th of it, in microseconds"""
        self.assertEqual(int.from_bytes(self.host.ask(0x31)[67:69], "little"), 148)

    def test_the_variant(self):
        """TL 47"""
        for angle, step in ((180, 100), (100, 25)):
            self.host.ask(0x3B, angle, 0, step, 0)
            self.assertEqual(self.host.ask(0x31)[107:111], bytes((angle, 0, step, 0)))

    def test_what_is_configured(self):
        """TL 96: measuring mode, unit, evaluations, and the restart with its time"""
        status = self.host.ask(0x31)
        self.assertEqual((status[102], status[122]), (0, 1))
        self.assertEqual((status[111], status[112], status[118]), (2, 0, 2))
        self.host.install()
        self.host.ask(0x77, *DEFAULTS[:5], 0x0F, 2, 0, 0, 5, 1, 7)
        status = self.host.ask(0x31)
        self.assertEqual((status[102], status[122]), (0x0F, 2))
        self.assertEqual((status[111], status[112], status[118]), (1, 7, 5))

    def test_a_permanent_rate(self):
        """TL 87"""
        self.assertEqual(self.host.ask(0x31)[119], 0)
        self.host.install()
        self.host.ask(0x66, 1)
        self.assertEqual(self.host.ask(0x31)[119], 1)


class TestConfiguration(unittest.TestCase):
    """TL 25, 31, 96"""

    def setUp(self):
        self.host = Host()

    def test_defaults(self):
        """Every byte of either firmware"""
        self.assertEqual(self.host.ask(0x74), b"\xf4" + DEFAULTS)
        self.assertEqual(Host(make_device(firmware="2.10")).ask(0x74), b"\xf4" + DEFAULTS[:32])
        centimetres = DEFAULTS[:6] + b"\x00" + DEFAULTS[7:]
        self.assertEqual(Host(make_device(CENTIMETRES)).ask(0x74), b"\xf4" + centimetres)

    def test_lengths(self):
        self.assertEqual(len(self.host.ask(0x74)), 35)
        self.assertEqual(len(Host(make_device(firmware="2.10")).ask(0x74)), 33)

    def test_missing_bytes_keep_their_values(self):
        self.host.install()
        before = self.host.ask(0x74)[1:]
        for size in (7, 32, 33, 34):
            new = bytes((1, 0, 0x60, 1, 2, 5, 0, *range(50, 77)))[:size]
            answer = self.host.ask(0x77, *new)
            self.assertEqual(answer, b"\xf7\x01" + new + before[size:])
            before = answer[2:]

    def test_bytes_beyond_it_are_ignored(self):
        host = Host(make_device(firmware="2.10"))
        host.install()
        self.assertEqual(len(host.ask(0x77, *bytes(34))), 34)
        self.host.install()
        self.assertEqual(self.host.ask(0x77, *bytes(40)), b"\xf7\x01" + bytes(34))

    def test_invalid_ones_are_refused(self):
        self.host.install()
        before = self.host.ask(0x74)[1:]
        for new in (bytes(6), bytes((0, 0, 0, 0, 0, 7, 0)), bytes((0, 0, 0, 0, 0, 0, 3))):
            self.assertEqual(self.host.ask(0x77, *new), b"\xf7\x00" + before)

    def test_the_answer_takes_time(self):
        self.host.install()
        self.host.write(frame(b"\x77" + bytes(34)))
        times = [time - self.host.now for time, _ in self.host.run(1.0)]
        self.assertAlmostEqual(times[1] - times[0], 0.396, 6)

    def test_it_stays_after_a_reset(self):
        self.host.configure(mode=5, unit=0)
        self.host.exchange(frame(b"\x10"), 3.0)
        self.assertEqual(self.host.ask(0x74)[6:8], b"\x05\x00")


if __name__ == "__main__":
    unittest.main()
