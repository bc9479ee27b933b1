#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Make journey.vtp: a robot drives through room.wrl and the doorway into the smaller room.

    python3 Data/make_journey.py

The file holds a polyline of 17 poses: the sensor is 1 m above the floor and moves 0.5 m to the east
each second. LMS3D Scan and `lms3d scan --trajectory` accept it as a trajectory.
"""

from trajectory_writer import trajectory
from vrml_writer import output_parser, save

POSES = 17
START_X, STEP, HEIGHT = -2.5, 0.5, 1.0

# From x = -2.5 to 2.5, on the way to the doorway, the robot turns to the north.
SOUTH, NORTH, BEND = -1.2, 0.75, 5.0


def place(i):
    """The sensor's position at pose i, metres."""
    share = min(i * STEP / BEND, 1.0)
    smooth = share * share * (3.0 - 2.0 * share)
    return (START_X + i * STEP, SOUTH + (NORTH - SOUTH) * smooth, HEIGHT)


def main():
    """Write the trajectory to the file named on the command line."""
    parser = output_parser("Write a trajectory through the room of Figure 5.", "journey.vtp")
    save(parser.parse_args().output, trajectory(place(i) for i in range(POSES)))


if __name__ == "__main__":
    main()
