#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The times of fans in bags equal the array Time."""

import unittest

import numpy as np

import lms3d
from command_line import POSITION, room
from lms3d.fans import Fans


class TestFans(unittest.TestCase):
    def test_times(self):
        scene = room()
        for first, last, beams in ((-90, 90, 361), (-90, 90, 181), (-90, 90, 721),
                                   (-90, 90, 601), (-90, 90, 91), (-90, 90, 257), (0, 0.2, 2)):
            with self.subTest(first=first, beams=beams):
                scan = lms3d.scan(scene, POSITION, alpha_range=(first, last),
                                  alpha_resolution=beams, beta_resolution=3, time=True)
                fans = Fans(scan.alpha)
                expected = np.empty((3, beams))
                for turn in range(3):
                    for part in fans.parts:
                        count = len(part.alpha)
                        expected[turn, part.beams] = (fans.time(turn) + part.delay
                                                      + np.arange(count) * part.beam_time)
                        np.testing.assert_allclose(np.diff(part.alpha), part.step, rtol=1e-9)
                np.testing.assert_allclose(scan.times, expected.ravel()[scan.beams], atol=1e-12)


if __name__ == "__main__":
    unittest.main()
