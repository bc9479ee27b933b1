#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares each case of Testing/Data/vrml97 with the values in expected.json."""

import gzip
import itertools
import json
import tempfile
import unittest
from pathlib import Path

import numpy as np

import lms3d
from vrml_reading import CASES, ERROR, SQUARE, WARNING, Scene, SceneTest

EXPECTED = json.loads((CASES / "expected.json").read_text(encoding="utf-8"))
TOLERANCE = 1e-5


class Case(unittest.TestCase):
    """One entry of expected.json. README.md beside it explains the keys."""

    def __init__(self, name):
        super().__init__("check")
        self.name, self.expected = name, EXPECTED[name]
        self.tolerance = self.expected.get("tol", TOLERANCE)

    def __str__(self):
        return f"{self.name} ({self.expected.get('why', 'as its name says')})"

    def check(self):
        path = CASES / self.expected.get("file", self.name + ".wrl")
        self.assertTrue(lms3d.vtkVRMLImporterSource.CanReadFile(str(path)))
        self.assertEqual(self.can_read_under_another_name(path),
                         self.expected.get("report") != "refused")
        root = {"SceneRoot": str(CASES / self.expected["root"])} if "root" in self.expected else {}
        self.scene = Scene(path, **root)
        self.check_surface()
        self.check_attributes()
        self.check_report()

    def check_close(self, value, expected, tolerance, what):
        self.assertLessEqual(abs(value - expected), tolerance * abs(expected), what)

    @staticmethod
    def can_read_under_another_name(path):
        with tempfile.TemporaryDirectory() as folder:
            link = Path(folder) / "scene.txt"
            link.symlink_to(path.resolve())
            return lms3d.vtkVRMLImporterSource.CanReadFile(str(link))

    def check_surface(self):
        scene, expected = self.scene, self.expected
        self.assertTrue(np.isfinite(scene.corners).all())
        if "tris" in expected:
            self.assertEqual(scene.triangles, expected["tris"], scene.words())
        if "area" in expected:
            self.check_close(scene.area(), expected["area"], self.tolerance,
                             f"area {scene.area()}, expected {expected['area']}\n{scene.words()}")
        if "volume" in expected:
            self.check_close(scene.volume(), expected["volume"], 2 * self.tolerance,
                             f"volume {scene.volume()}, expected {expected['volume']}")
        if "bbox" in expected:
            size = np.linalg.norm(np.subtract(expected["bbox"][3:], expected["bbox"][:3]))
            np.testing.assert_allclose(
                scene.bbox(), expected["bbox"], rtol=0, atol=self.tolerance * size)

    def check_attributes(self):
        self.assertTrue(set(self.scene.shape_ids) <= set(range(len(self.scene.names))))
        if "names" in self.expected:
            self.assertEqual(self.scene.names, self.expected["names"])
        if "colors" in self.expected:
            areas = self.scene.color_areas()
            self.assertEqual(set(areas), set(self.expected["colors"]))
            for color, area in self.expected["colors"].items():
                self.check_close(areas[color], area, self.tolerance, color)

    def check_report(self):
        scene, report = self.scene, self.expected.get("report", False)
        self.assertEqual(len(scene.errors) + len(scene.warnings), bool(scene.words()))
        for text in self.expected.get("messages", []):
            self.assertIn(text, scene.words())
        if report is False:
            self.assertEqual(scene.words(), "")
        elif report == "any":
            self.assertGreater(len(scene.messages), 0)
        elif report == "warning":
            self.assertEqual(set(scene.severities), {WARNING})
            self.assertEqual(len(scene.warnings), 1)
        elif report in ("error", "refused"):
            self.assertEqual(len(scene.errors), 1)
            if scene.triangles:
                self.assertIn(ERROR, scene.severities)


class Laws(SceneTest):
    def test_every_file_is_a_case_or_part_of_one(self):
        files = {entry.get("file", name + ".wrl") for name, entry in EXPECTED.items()}
        texts = b"".join((CASES / name).read_bytes() for name in sorted(files))
        for path in sorted(CASES.glob("*.wr?")):
            self.assertTrue(path.name in files or path.name.encode() in texts, path.name)

    def test_the_order_of_fields_does_not_matter(self):
        fields = ["translation 10 20 30", "rotation 0 0 1 1.570796327", "scale 2 1 1",
                  "center 1 0 0", "scaleOrientation 0 0 1 0.785398163", "children " + SQUARE]
        orders = [f"Transform {{ {' '.join(order)} }}" for order in itertools.permutations(fields)]
        scene = Scene(self.write("\n".join(orders)))
        np.testing.assert_allclose(scene.bbox(), [9.5, 18.5, 30, 11.5, 20.5, 30], atol=1e-6)
        self.assertEqual(scene.triangles, 2 * len(orders))
        np.testing.assert_allclose(scene.corners[::2], scene.corners[:1].repeat(len(orders), 0))

    def test_a_compressed_scene_is_the_same_scene(self):
        for name in ("silent_every_node", "robot_openhrp", "ifs_two_windows", "enc_cr"):
            with self.subTest(name):
                path = self.folder / (name + ".wrl")
                path.write_bytes(gzip.compress((CASES / path.name).read_bytes()))
                np.testing.assert_array_equal(
                    Scene(path).corners, Scene(CASES / path.name).corners)

    def test_curved_shapes_keep_the_chord_error(self):
        path = self.write("Shape { geometry Sphere { radius 2 } }")
        counts = []
        for error in (0.1, 0.01, 0.001):
            scene = Scene(path, ChordError=error)
            self.assertEqual(scene.words(), "")
            np.testing.assert_allclose(np.linalg.norm(scene.corners, axis=2), 2.0, rtol=1e-12)
            a, b, c = np.moveaxis(scene.corners, 1, 0)
            normals = np.cross(b - a, c - a)
            inner = np.einsum("ij,ij->i", a, normals) / np.linalg.norm(normals, axis=1)
            self.assertGreaterEqual(inner.min(), 2.0 - error * (1 + 1e-9))
            counts.append(scene.triangles)
        self.assertEqual(counts, sorted(set(counts)))

    def test_round_sides_keep_the_chord_error(self):
        for text in ("Cylinder { radius 2 top FALSE bottom FALSE }",
                     "Cone { bottomRadius 2 height 4 bottom FALSE }"):
            for error in (0.1, 0.01, 0.001):
                with self.subTest(text, error=error):
                    scene = Scene(self.write(f"Shape {{ geometry {text} }}"), ChordError=error)
                    height = scene.corners[:, :, 1]
                    radius = 2.0 if "Cylinder" in text else (2.0 - height) / 2
                    ring = np.linalg.norm(scene.corners[:, :, ::2], axis=2)
                    np.testing.assert_allclose(ring, radius + 0 * ring, rtol=0, atol=1e-12)
                    rim = scene.corners[(height == -2).sum(axis=1) == 2] if "Cone" in text else (
                        scene.corners[(height == -1).sum(axis=1) == 2])
                    a, b = (rim[rim[:, :, 1] == rim[:, :, 1].min()].reshape(-1, 2, 3)
                            .transpose(1, 0, 2))
                    middle = np.linalg.norm(((a + b) / 2)[:, ::2], axis=1)
                    self.assertGreaterEqual(middle.min(), 2.0 - error * (1 + 1e-9))
                    self.assertLess(middle.max(), 2.0)

    def test_a_large_round_shape_needs_more_triangles_than_a_small_one(self):
        small = Scene(self.write("Shape { geometry Cylinder { radius 0.1 } }"))
        large = Scene(self.write("Shape { geometry Cylinder { radius 10 } }"))
        self.assertGreater(large.triangles, 5 * small.triangles)
        np.testing.assert_allclose(np.linalg.norm(large.corners[:, :, ::2], axis=2).max(), 10.0)

    def test_a_scaled_shape_keeps_the_chord_error_in_the_world(self):
        scene = Scene(self.write("Transform { scale 100 100 100 children "
                                 "Shape { geometry Sphere { radius 0.01 } } }"), ChordError=0.001)
        self.assertLessEqual(4 * np.pi - scene.area(), 4 * np.pi * 2e-3)


def load_tests(loader, tests, _pattern):
    """Each case is a separate test, so that -v shows which one crashes or hangs."""
    tests = loader.loadTestsFromTestCase(Laws)
    tests.addTests(Case(name) for name in EXPECTED)
    return tests


if __name__ == "__main__":
    unittest.main()
