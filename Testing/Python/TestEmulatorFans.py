#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The fans that the emulator casts one by one equal the turns of a whole scan, to the bit.

They are cast without VTK's pipeline.
"""

import unittest

import numpy as np

import lms3d
from command_line import POSITION, room
from lms3d import DEVICES, set_device
from lms3d.emulation.fans import LiveFans
from lms3d.emulation.variants import VARIANTS, Variant

TURNS = 70

# The elevation of the first beam, and the number of beams, by angle and step (TL 47). The last beam is
# opposite: 100 degrees go from 40 to 140 degrees of 180 (TL 48).
BEAMS = {(180, 100): (-90, 181), (180, 50): (-90, 361),
         (100, 100): (-50, 101), (100, 50): (-50, 201), (100, 25): (-50, 401)}


class Failed(Exception):
    """VTK has reported an error."""


def no_check():
    """All VTK calls succeed."""


def fail():
    raise Failed


class TestLiveFans(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = room()

    def fans(self, device, seed=0, with_errors=True):
        self.sensor = sensor = lms3d.vtkLMS3DScanFilter()
        sensor.SetInputDataObject(self.scene)
        sensor.SetPosition(POSITION)
        sensor.SetBetaResolution(TURNS)
        self.errors = errors = None
        set_device(sensor, device)
        if with_errors and device != "ideal":
            self.errors = errors = lms3d.vtkLMS3DRangeErrorFilter()
            set_device(errors, device)
            errors.SetNoiseSeed(seed)
        return LiveFans(sensor, no_check, errors)

    def scan(self, variant, device, seed=0):
        low, count = BEAMS[variant.angle, variant.step]
        scan = lms3d.scan(self.scene, POSITION, alpha_range=(low, -low), alpha_resolution=count,
                          beta_resolution=TURNS, seed=seed, device=device, status=True)
        reasons = {lms3d.vtkLMS3DScanFilter.BEYOND_RANGE: np.inf,
                   lms3d.vtkLMS3DScanFilter.TOO_WEAK: -np.inf}
        for status, mark in reasons.items():
            scan.ranges[scan.status == status] = mark
        return scan.ranges

    def test_turns_are_those_of_a_scan(self):
        self.assertEqual({(variant.angle, variant.step) for variant in VARIANTS}, set(BEAMS))
        for device in DEVICES:
            fans = self.fans(device, 7)
            for variant in VARIANTS:
                with self.subTest(device=device, variant=variant):
                    found = [fans.cast_turn(variant, 0, turn, 1) for turn in range(TURNS)]
                    np.testing.assert_array_equal(found, self.scan(variant, device, 7))

    def test_elevations(self):
        """TL 47, 48; of the same variants, whose fans tell nothing of beams without a return"""
        for (angle, step), (low, count) in BEAMS.items():
            np.testing.assert_allclose(Variant(angle, step).alphas, np.linspace(low, -low, count))

    def test_no_pipeline(self):
        """An update of the pipeline would take most of a fan's time."""
        fans = self.fans("lms200-mm")
        updates = []
        for algorithm in (self.sensor, self.errors):
            algorithm.AddObserver("StartEvent", lambda *_: updates.append(1))
        fans.cast_turn(Variant(), 0, 3, 1)
        fans.cast_part(Variant(), 1, 20.0, 1.0, 2)
        self.assertEqual(updates, [])

    def test_errors(self):
        for name, value in (("sensor", "MaximumRange"), ("errors", "RangeBias")):
            fans = self.fans("lms200-mm")
            fans._check = fail
            algorithm = getattr(self, name)
            algorithm.AddObserver("ErrorEvent", lambda *_: None)
            getattr(algorithm, "Set" + value)(np.nan)
            with self.assertRaises(Failed):
                fans.cast_turn(Variant(), 0, 0, 1)

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
        exact = self.fans("lms200-mm", with_errors=False)
        fans = self.fans("lms200-mm")
        for means in (1, 4, 100):
            errors = np.concatenate([fans.cast_turn(Variant(), 0, turn, means)
                                     - exact.cast_turn(Variant(), 0, turn, 1)
                                     for turn in range(20)])
            variance = 0.005**2 / means + 0.001**2 / 12
            self.assertAlmostEqual(np.std(errors[np.isfinite(errors)]) / variance**0.5, 1.0, delta=0.05)


if __name__ == "__main__":
    unittest.main()
