#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The building and the journeys: the committed files equal the output of their generators, the
rooms are closed, and the journey through the building passes all rooms and touches nothing."""

import unittest
import xml.etree.ElementTree as ET

import numpy as np

from scene_pieces import DATA, distances, generated, read
from scene_tests import ClosedSceneTests

# x0, x1, y0, y1 and height of each room.
ROOMS = {
    "Corridor": (-12, 12, -1.1, 1.1, 2.7), "Office": (-12, -5.2, 1.26, 6.5, 3),
    "Meeting": (-5.04, 3, 1.26, 7.2, 3), "Library": (3.16, 12, 1.26, 6.5, 3),
    "Hall": (-12, -1.5, -8, -1.26, 3.6), "Kitchen": (-1.34, 4.6, -6.2, -1.26, 3),
    "Store": (4.76, 12, -6.2, -1.26, 3),
}
# The widths of the doorways, 0.16 m long and 2.06 m high.
DOORWAYS = 7 * [0.92] + [1.6]
# The widths of the windows, 0.14 m deep and 1.18 m high.
WINDOWS = 4 * [1.8] + [5.6] + 3 * [2.0] + [2.3, 1.2]


def read_journey(name):
    """The times and places of a journey."""
    arrays = ET.parse(DATA / name).getroot().iter("DataArray")
    times, places = (np.array(next(arrays).text.split(), float) for _ in range(2))
    return times, places.reshape(-1, 3)


def rooms_of(points):
    """The names of the rooms that hold all points."""
    low, high = points.min(axis=0), points.max(axis=0)
    return [name for name, (x0, x1, y0, y1, height) in ROOMS.items()
            if np.all(low >= (x0, y0, 0)) and np.all(high <= (x1, y1, height))]


class TestBuilding(ClosedSceneTests, unittest.TestCase):
    scene, script, smallest_area, shell = "building.wrl", "make_building.py", 4e-5, "Building"

    def test_number_of_triangles(self):
        self.assertEqual(self.triangle_count(), 3520)

    def test_volume_of_the_rooms(self):
        rooms = sum((x1 - x0) * (y1 - y0) * height for x0, x1, y0, y1, height in ROOMS.values())
        (volume,) = self.pieces["Building"].volumes()
        self.assertAlmostEqual(
            -volume, rooms + 0.16 * 2.06 * sum(DOORWAYS) + 0.14 * 1.18 * sum(WINDOWS), 9)

    def test_each_piece_of_furniture_is_in_one_room(self):
        furnished = set()
        for name, mesh in self.pieces.items():
            if name != "Building":
                with self.subTest(name):
                    (room,) = rooms_of(mesh.points)
                    furnished.add(room)
        self.assertEqual(furnished, set(ROOMS))


class TestBuildingJourney(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.times, cls.places = read_journey("building_journey.vtp")

    def test_files_are_what_their_generators_write(self):
        for name in ("journey", "building_journey"):
            with self.subTest(name):
                self.assertEqual(generated(f"make_{name}.py"), (DATA / f"{name}.vtp").read_bytes())

    def test_two_hundred_poses_of_a_slow_robot(self):
        self.assertEqual(self.times.tolist(), list(range(200)))
        np.testing.assert_array_equal(self.places[:, 2], 1)
        steps = np.linalg.norm(np.diff(self.places, axis=0), axis=1)
        self.assertLess(steps.max(), 0.6)
        self.assertGreater(steps.min(), 0.4)

    def test_passes_all_rooms(self):
        passed = [room for place in self.places for room in rooms_of(place[None])]
        for room in ROOMS:
            with self.subTest(room):
                self.assertGreaterEqual(passed.count(room), 10)

    def test_has_a_third_of_a_metre_around_it(self):
        """Also between the poses."""
        middles = (self.places[1:] + self.places[:-1]) / 2
        corners = np.vstack([mesh.corners() for mesh in read(DATA / "building.wrl").values()])
        for place in (*self.places, *middles):
            with self.subTest(place=place.tolist()):
                self.assertGreaterEqual(distances(place, corners).min(), 1 / 3)


if __name__ == "__main__":
    unittest.main(verbosity=2)
