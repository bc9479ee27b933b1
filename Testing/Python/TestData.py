#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes of the paper: the committed files equal the output of their generators,
and they have the size, closure and free space that the figures need."""

import unittest

import numpy as np

from scene_pieces import distances, generated
from scene_tests import ClosedSceneTests, SceneTests

SENSOR = np.array([0.3, -0.2, 1.0])


class TestRoom(ClosedSceneTests, unittest.TestCase):
    scene, script, smallest_area, shell = "room.wrl", "make_room.py", 4e-5, "Room"

    def test_has_the_triangles_of_the_paper(self):
        self.assertEqual(self.triangle_count(), 804)

    def test_volume_of_the_rooms(self):
        main_room, niche, doorway = 8 * 6 * 3, 1.8 * 0.14 * 1.18, 0.92 * 0.16 * 2.06
        small_room = (2.54 + 2.79) / 2 * 3.55 * 2.6
        (volume,) = self.pieces["Room"].volumes()
        self.assertAlmostEqual(-volume, main_room + niche + doorway + small_room, 9)

    def test_sensor_has_half_a_metre_around_it(self):
        nearest = min(distances(SENSOR, mesh.corners()).min() for mesh in self.pieces.values())
        self.assertGreaterEqual(nearest, 0.5)

    def test_nothing_reaches_through_a_wall(self):
        for name, mesh in self.pieces.items():
            if name == "Room":
                continue
            with self.subTest(name):
                self.assertTrue(self.stays_inside(mesh.points))

    def stays_inside(self, points):
        """Whether all points lie in the main room, or all in the smaller one."""
        def between(low, high):
            return np.all((points >= low) & (points <= high))

        far_wall = 6.7 + (points[:, 1].min() + 0.7) / 3.55 * 0.25
        main_room = between([-4, -3, 0], [4, 3, 3])
        return main_room or between([4.16, -0.7, 0], [far_wall, 2.85, 2.6])

    def test_pieces_stand_on_the_floor_or_on_something(self):
        feet = {name: mesh.points[:, 2].min() for name, mesh in self.pieces.items()}
        raised = {name: round(z, 3) for name, z in feet.items() if z != 0}
        self.assertEqual(raised, {
            "Books": 0.5, "Picture": 1.3, "DoorLeaf": 0.01, "LampShade": 1.5,
            "BoxOnTop": 0.55, "BoxAtTheTop": 0.91, "CrateOnTop": 0.8,
        })


class TestTeapot(SceneTests, unittest.TestCase):
    scene, script, smallest_area = "teapot.wrl", "make_teapot.py", 5e-7

    def all_points(self):
        return np.vstack([mesh.points for mesh in self.pieces.values()])

    def test_parts(self):
        self.assertEqual(list(self.pieces), ["Body", "Lid", "Handle", "Spout", "Bottom"])
        self.assertFalse(any(mesh.solid for mesh in self.pieces.values()))

    def test_triangles_of_32_patches_without_the_collapsed_ones(self):
        cells = 7
        counts = {name: len(mesh.triangles) for name, mesh in self.pieces.items()}
        patch, tip = 2 * cells**2, 4 * cells
        self.assertEqual(counts, {
            "Body": 12 * patch, "Lid": 8 * patch - tip, "Handle": 4 * patch, "Spout": 4 * patch,
            "Bottom": 4 * patch - tip,
        })

    def test_dimensions(self):
        low, high = self.all_points().min(axis=0), self.all_points().max(axis=0)
        np.testing.assert_allclose(low, [-0.15, -0.1, 0], atol=1e-9)
        np.testing.assert_allclose(high[1:], [0.1, 0.1575], atol=1e-9)
        self.assertAlmostEqual(high[0], 0.1717, 4)

    def test_round_parts_are_nearly_round(self):
        """Newell's quarters deviate from a circle by at most 0.6 % of the radius."""
        points = self.pieces["Body"].points
        belt = points[np.isclose(points[:, 2], 0.045)]
        radii = np.hypot(belt[:, 0], belt[:, 1])
        self.assertEqual(len(belt), 28)
        self.assertLess(np.abs(radii / 0.1 - 1).max(), 0.006)

    def test_mirrored_about_the_plane_of_the_spout(self):
        points = {tuple(point) for point in self.all_points()}
        self.assertTrue(all((x, -y + 0.0, z) in points for x, y, z in points))

    def test_borders_are_at_the_ends_of_the_parts(self):
        """Rim and foot of the body; one rim of lid and bottom; both ends of a tube."""
        for name, ends in {"Body": 2, "Lid": 1, "Handle": 2, "Spout": 2, "Bottom": 1}.items():
            with self.subTest(name):
                edges = self.pieces[name].directed_edges()
                around = 28 if name in ("Body", "Lid", "Bottom") else 14
                self.assertEqual(sum((b, a) not in edges for a, b in edges), ends * around)

    def test_bottom_closes_the_body(self):
        body, bottom = ({tuple(p) for p in self.pieces[name].points} for name in ("Body", "Bottom"))
        self.assertEqual(len(body & bottom), 28)

    def test_parts_face_outwards(self):
        for name, mesh in self.pieces.items():
            with self.subTest(name):
                self.assertTrue(all(volume > 0 for volume in mesh.volumes()))

    def test_subdivisions_can_be_set(self):
        self.assertEqual(generated(self.script, "--subdivisions", "3").count(b"-1"), 552)


if __name__ == "__main__":
    unittest.main(verbosity=2)
