#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The fans that the emulator casts one by one equal the turns of a whole scan, to the bit."""

import unittest

import numpy as np

import lms3d
from command_line import POSITION, room
from lms3d.emulation.fans import LiveFans
from lms3d.emulation.presets import DEVICES, set_errors
from lms3d.emulation.variants import VARIANTS, Variant

TURNS = 70


def update(algorithm, time):
    algorithm.Update()


class TestLiveFans(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = room()

    def fans(self, device, seed=0):
        sensor = lms3d.vtkLMS3DScanFilter()
        sensor.SetInputDataObject(self.scene)
        sensor.SetPosition(POSITION)
        sensor.SetBetaResolution(TURNS)
        errors = None
        if DEVICES[device]:
            errors = lms3d.vtkLMS3DRangeErrorFilter()
            set_errors(errors, device, seed)
        return LiveFans(sensor, update, errors)

    def scan(self, variant, device, seed=0):
        errors = DEVICES[device]
        low = variant.first_alpha
        return lms3d.scan(self.scene, POSITION, alpha_range=(low, -low),
                          alpha_resolution=variant.count, beta_resolution=TURNS, seed=seed,
                          range_noise=errors.get("RangeNoise", 0.0),
                          range_resolution=errors.get("RangeResolution", 0.0)).ranges

    def test_turns_are_those_of_a_scan(self):
        for device in DEVICES:
            fans = self.fans(device, 7)
            for variant in VARIANTS:
                with self.subTest(device=device, variant=variant):
                    found = [fans.cast_turn(variant, 0, turn, 1) for turn in range(TURNS)]
                    np.testing.assert_array_equal(found, self.scan(variant, device, 7))

    def test_a_turn_again_is_the_same(self):
        """A telegram that a host has not received is cast again."""
        fans = self.fans("lms200-mm")
        first, again = (fans.cast_turn(Variant(), 2, 33, 1) for _ in range(2))
        np.testing.assert_array_equal(first, again)

    def test_parts_are_those_of_the_fan(self):
        fans = self.fans("ideal")
        for variant in (Variant(180, 50), Variant(180, 25)):
            whole = fans.cast_turn(variant, 0, 7, 1)
            for part in range(variant.parts):
                found = fans.cast_part(variant, part, fans.angles[7], 1.0, 1)
                np.testing.assert_allclose(found, whole[part::variant.parts], rtol=1e-12)

    def test_noise_of_means(self):
        """The mean of n scans has the noise of one, divided by the square root of n."""
        ideal = self.fans("ideal")
        fans = self.fans("lms200-mm")
        for means in (1, 4, 100):
            errors = np.concatenate([fans.cast_turn(Variant(), 0, turn, means)
                                     - ideal.cast_turn(Variant(), 0, turn, 1)
                                     for turn in range(20)])
            variance = 0.005**2 / means + 0.001**2 / 12
            self.assertAlmostEqual(np.nanstd(errors) / variance**0.5, 1.0, delta=0.05)


if __name__ == "__main__":
    unittest.main()
