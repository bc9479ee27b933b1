#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Make building_journey.vtp: a robot drives through the corridor and all rooms of building.wrl.

    python3 Data/make_building_journey.py

The file holds a polyline of 200 poses at equal distances: the sensor is 1 m above the floor and has
one pose each second. LMS3D Scan and `lms3d scan --trajectory` accept it as a trajectory.
"""

from math import dist

from trajectory_writer import trajectory
from vrml_writer import output_parser, save

POSES = 200
HEIGHT = 1.0

# The corners of the way, x and y in metres.
WAY = (
    (-11, 0), (-9.04, 0), (-9.04, -3.2), (-10.8, -3.6), (-10.6, -6.2), (-7.9, -6.5), (-8.0, -3.2),
    (-5.2, -3.2), (-5.2, -6.3), (-2.7, -6.3), (-2.6, -3.6), (-3.2, -2.4), (-3.2, 0),  # hall
    (1.66, 0), (1.66, -2.6), (0.4, -3.2), (0.4, -5.3), (2.2, -5.4), (2.2, -3.2), (1.66, -2.2),
    (1.66, 0),  # kitchen
    (7.6, 0), (8.66, 0), (8.66, -3.0), (6.4, -2.9), (6.3, -4.4), (9.6, -4.9), (9.8, -2.6), (8.66, -2.0),
    (8.66, 0), (10.6, -0.3), (10.6, 0.4), (7.46, 0.2),  # store, the corridor's end
    (7.4, 2.9), (10.4, 2.8), (10.3, 3.7), (7.9, 4.0), (5.6, 5.2), (4.6, 4.06),
    (1.6, 4.06), (1.7, 2.8), (-3.6, 2.8), (-3.6, 4.2), (-1.04, 4.0), (-1.04, 1.4), (-1.04, 0),  # library, meeting
    (-8.44, 0), (-8.44, 2.6), (-10.4, 3.4), (-9.2, 5.4), (-7.3, 5.5), (-7.2, 3.2),  # office
)

# Each round cuts every corner of the way at a quarter of its two sides.
ROUNDS = 3


def with_corners_cut(way):
    """The way with each corner replaced by two, nearer to the middle than the corner."""
    between = [((3 * a + c) / 4, (3 * b + d) / 4) for (a, b), (c, d) in zip(way, way[1:])]
    beyond = [((a + 3 * c) / 4, (b + 3 * d) / 4) for (a, b), (c, d) in zip(way, way[1:])]
    inner = [place for pair in zip(between, beyond) for place in pair]
    return [way[0], *inner[1:-1], way[-1]]


def along(way, count):
    """Places on the way at equal distances along it, the first at its start, the last at its end."""
    step = sum(map(dist, way, way[1:])) / (count - 1)
    places, done = [way[0]], 0.0
    for a, b in zip(way, way[1:]):
        length = dist(a, b)
        while len(places) < count - 1 and len(places) * step <= done + length:
            share = (len(places) * step - done) / length
            places.append(tuple(p + share * (q - p) for p, q in zip(a, b)))
        done += length
    return [*places, way[-1]]


def main():
    """Write the trajectory to the file named on the command line."""
    parser = output_parser("Write a trajectory through the building.", "building_journey.vtp")
    arguments = parser.parse_args()
    way = WAY
    for _ in range(ROUNDS):
        way = with_corners_cut(way)
    save(arguments.output, trajectory((x, y, HEIGHT) for x, y in along(way, POSES)))


if __name__ == "__main__":
    main()
