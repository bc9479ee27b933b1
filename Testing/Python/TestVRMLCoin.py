#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares LMS3D with another VRML reader, Coin, for the cases of Testing/Data/vrml97.

LMS3D_COIN is the program measureWithCoin. Coin reads in single precision and makes a fixed number
of triangles for curved shapes. It rejects faulty files entirely, so the test skips these files.
"""

import json
import os
import subprocess
import unittest
from collections import namedtuple

import numpy as np

from vrml_reading import CASES, Scene

EXPECTED = json.loads((CASES / "expected.json").read_text(encoding="utf-8"))
FLAT, CURVED = 1e-5, 1e-2
VERSION = "4.0.0"  # the version whose faults expected.json lists


def run_coin(*arguments):
    return subprocess.run([os.environ["LMS3D_COIN"], *map(str, arguments)], capture_output=True,
                          text=True, timeout=60)


Measures = namedtuple("Measures", "count area bbox")


def measure(path):
    """The surfaces that Coin reads from a file; None if it fails."""
    done = run_coin(path)
    if done.returncode:
        return None
    count, area, *bbox = map(float, done.stdout.split())
    return Measures(int(count), area, np.array(bbox))


def difference(name):
    """The difference between Coin and LMS3D for a case, or an empty text."""
    expected = EXPECTED[name]
    path = CASES / expected.get("file", name + ".wrl")
    scene, found = Scene(path, SceneRoot=str(CASES)), measure(path)
    if found is None:
        return "Coin rejects it or crashes"
    tolerance = CURVED if "tol" in expected else FLAT
    size = np.linalg.norm(scene.bbox()[3:] - scene.bbox()[:3])
    is_equal = np.isclose(found.area, scene.area(), rtol=tolerance, atol=0) and np.allclose(
        found.bbox, scene.bbox(), rtol=0, atol=tolerance * size)
    return "" if is_equal else f"Coin: {found}, LMS3D: {scene.area()} {scene.bbox()}"


class Coin(unittest.TestCase):
    def test_agrees(self):
        for name, expected in EXPECTED.items():
            if not expected.get("report") and "coin" not in expected:
                with self.subTest(name):
                    self.assertEqual(difference(name), "")

    @unittest.skipIf(run_coin().stdout.strip() != VERSION, "a Coin with other faults")
    def test_still_reads_the_others_otherwise(self):
        """No case is excluded from the comparison without need."""
        for name, expected in EXPECTED.items():
            if "coin" in expected:
                with self.subTest(name):
                    self.assertNotEqual(difference(name), "")


if __name__ == "__main__":
    unittest.main()
