#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads faces of many corners: outlines and walls with windows, whose area is known, in any plane.
Very large or random faces must neither crash nor hang."""

import math
import unittest

import numpy as np

from vrml_reading import FACE, SQUARE, SceneTest


def face(points, index=None):
    """A shape with one face. The corners are in space, or in the plane z = 0."""
    index = range(len(points)) if index is None else index
    points = np.column_stack((points, np.zeros((len(points), 3 - np.shape(points)[1]))))
    return "Shape { geometry " + FACE.format(
        ", ".join(" ".join(map(repr, point)) for point in points.tolist()),
        " ".join(map(str, index))) + " }\n"


def boundary(cells):
    """Maps each corner of the unit squares to the next corners along their common boundary,
    counter-clockwise."""
    steps = {}
    for x, y in cells:
        for beyond, begin, end in (((x, y - 1), (x, y), (x + 1, y)),
                                   ((x + 1, y), (x + 1, y), (x + 1, y + 1)),
                                   ((x, y + 1), (x + 1, y + 1), (x, y + 1)),
                                   ((x - 1, y), (x, y + 1), (x, y))):
            if beyond not in cells:
                steps.setdefault(begin, []).append(end)
    return steps


def outline(chance, size):
    """The outline of a region of `size` unit squares, without holes. All corners of squares are
    corners of the face."""
    around = ((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1))
    cells = {(0, 0)}
    while len(cells) < size:
        x, y = sorted(cells)[chance.integers(len(cells))]
        dx, dy = around[2 * chance.integers(4)]
        cell = (x + dx, y + dy)
        taken = [(cell[0] + i, cell[1] + j) in cells for i, j in around]
        if sum(taken[i] != taken[i - 1] for i in range(8)) == 2:
            cells.add(cell)
    steps = boundary(cells)
    corners = [(0, 0) if (0, 0) in steps else min(steps)]
    while len(corners) < len(steps):
        corners.append(steps[corners[-1]][0])
    return np.array(corners, float), float(size)


def facade(chance, columns, rows):
    """A wall with windows as one face: 2 x 2 units for each possible window. Bridges join each
    window to the one below it, and the lowest ones to the ground."""
    corners, area = [(0, 0)], 4.0 * columns * rows
    for left in 2 * np.arange(columns) + 0.5:
        right = left + chance.uniform(0.1, 1)
        sills = [2 * row + 0.5 for row in range(rows) if chance.random() < 0.6]
        area -= len(sills) * (right - left)
        corners += [(left, 0)] + [(left, y + h) for y in sills for h in (0, 1)]
        for y in reversed(sills):
            corners += [(left, y + 1), (right, y + 1), (right, y), (left, y)]
        corners += [(left, 0)]
    return np.array(corners + [(2 * columns, 0), (2 * columns, 2 * rows), (0, 2 * rows)]), area


def somewhere(chance, corners, area):
    """The face and its area after a random choice of first corner, direction, pose and scale."""
    corners = np.roll(corners, chance.integers(len(corners)), axis=0)[::chance.choice((-1, 1))]
    scale = 10.0 ** chance.integers(-4, 5)
    axes, _ = np.linalg.qr(chance.normal(size=(3, 3)))
    place = chance.normal(size=3) * scale * 10.0 ** chance.integers(0, 3)
    return corners @ axes[:, :2].T * scale + place, area * scale ** 2


class Areas(SceneTest):
    COUNT = 3000

    def check(self, make):
        chance = np.random.default_rng(1)
        faces = [somewhere(chance, *make(chance)) for _ in range(self.COUNT)]
        scene = self.read("".join(face(corners) for corners, _ in faces))
        self.assertEqual(scene.words(), "")
        areas = np.bincount(scene.shape_ids, scene.areas(), self.COUNT)
        np.testing.assert_allclose(areas, [area for _, area in faces], rtol=1e-7)

    def test_outlines(self):
        self.check(lambda chance: outline(chance, chance.integers(1, 80)))

    def test_facades(self):
        self.check(lambda chance: facade(chance, *chance.integers(1, 6, 2)))


class Large(SceneTest):
    CORNERS = 100_000

    def circle(self):
        angles = np.arange(self.CORNERS) * (2 * np.pi / self.CORNERS)
        return np.column_stack((np.cos(angles), np.sin(angles)))

    def check(self, points, area):
        """Either the whole face is read, or a message reports its loss."""
        scene = self.read(SQUARE + face(points.tolist()))
        if not scene.messages:
            self.assertAlmostEqual((scene.area() - 1) / area, 1, places=5)
        self.assertGreaterEqual(scene.area(), 1 - 1e-9)

    def test_convex(self):
        scene = self.read(face(self.circle().tolist()))
        self.assertEqual(scene.words(), "")
        self.assertAlmostEqual(scene.area(), np.pi, places=7)

    def test_star(self):
        points = self.circle()
        points[::2] *= 0.5
        self.check(points, self.CORNERS / 2 * 0.5 * math.sin(2 * np.pi / self.CORNERS))

    def test_a_triangle_with_sides_that_bow_inwards(self):
        """Few corners are convex, so it takes too much work. The message says what to do, and no other
        face is lost."""
        side = np.arange(0, 1, 1e-4)
        bow = side + 0.4j * side * (1 - side)
        turn = np.exp(2j * np.pi / 3)
        outline = np.concatenate((bow, 1 + turn * bow, 1 + turn + turn ** 2 * bow))
        scene = self.read(SQUARE + face(np.column_stack((outline.real, outline.imag))) + SQUARE)
        self.assertEqual((scene.errors, len(scene.warnings)), ([], 1))
        self.assertRegex(scene.messages[0], r"scene\.wrl:\d+: .*1 .*too many corners for its shape, or "
                                            r"crosses itself.*: split such faces")
        self.assertEqual(scene.triangles, 2 + len(outline) - 2 + 2)
        areas = np.bincount(scene.shape_ids, scene.areas())
        self.assertAlmostEqual(areas[0], 1)
        self.assertAlmostEqual(areas[2], 1)

    def test_comb(self):
        teeth = self.CORNERS // 4
        points = [(2 * i + x, y) for i in range(teeth) for x, y in ((0, 0), (0, 9), (1, 9), (1, 0))]
        points += [(2 * teeth, 0), (2 * teeth, -1), (0, -1)]
        self.check(np.array(points[::-1], float), teeth * 9 + 2 * teeth)

    def test_faces_without_an_inside(self):
        line = np.column_stack((np.arange(self.CORNERS), np.zeros(self.CORNERS)))
        back_and_forth = np.tile([[0, 0], [1, 0], [2, 0]], (9, 1))
        for points in (np.zeros((self.CORNERS, 2)), line, back_and_forth):
            self.assertAlmostEqual(self.read(SQUARE + face(points.tolist())).area(), 1)

    def test_crossings(self):
        points = np.random.default_rng(1).random((20_000, 2))
        scene = self.read(SQUARE + face(points.tolist()))
        self.assertGreaterEqual(scene.triangles, 2)
        self.assertTrue(np.isfinite(scene.corners).all())

    def test_one_corner_over_and_over(self):
        square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        scene = self.read(face(square, [0] * self.CORNERS + [1, 2, 3] + [3] * self.CORNERS))
        self.assertEqual((scene.triangles, scene.words()), (2, ""))


if __name__ == "__main__":
    unittest.main()
